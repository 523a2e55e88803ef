#include "production/stills/output_place.h"

#include <algorithm>
#include <string>
#include <system_error>

#include "encoding/frame_name.h"
#include "system/files/atomic_file.h"

namespace poinsot {

namespace {
constexpr const char* default_folder = "output";
constexpr std::string_view scene_placeholder = "{scene}";
}  // namespace

bool has_scene_name(std::string_view pattern) {
    return pattern.find(scene_placeholder) != std::string_view::npos;
}

std::filesystem::path with_scene_name(const std::filesystem::path& pattern,
                                      std::string_view scene_name) {
    std::string name(scene_name);
    std::replace(name.begin(), name.end(), '#', '_');
    std::string path = pattern.string();
    for (std::size_t at = 0; (at = path.find(scene_placeholder, at)) != std::string::npos;
         at += name.size())
        path.replace(at, scene_placeholder.size(), name);
    return path;
}

std::filesystem::path numbered_output(const std::filesystem::path& pattern, std::int64_t number,
                                      std::string_view scene_name) {
    return with_scene_name(has_frame_number(pattern) ? frame_name(pattern, number) : pattern,
                           scene_name);
}

std::filesystem::path default_output(std::string_view scene_name, std::string_view suffix) {
    return with_scene_name(std::filesystem::path(default_folder) /
                               (std::string(scene_placeholder) + std::string(suffix)),
                           scene_name);
}

OutputPlace::OutputPlace(const std::string& asked, const Scene& scene, std::string_view suffix)
    : path_(asked) {
    if (path_.empty()) {
        // Errors are reported when the file is opened.
        std::error_code ignored;
        made_ = std::filesystem::create_directory(default_folder, ignored);
        path_ = default_output(scene.name, suffix);
    }
    check_aside(path_);
}

OutputPlace::~OutputPlace() {
    std::error_code not_empty;
    if (made_) std::filesystem::remove(default_folder, not_empty);
}

}  // namespace poinsot
