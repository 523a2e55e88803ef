#include "production/stills/output_place.h"

#include <algorithm>
#include <string>
#include <system_error>

#include "encoding/film_parts.h"
#include "encoding/frame_name.h"
#include "production/records/record.h"
#include "production/records/verify.h"
#include "system/files/own_files.h"

namespace poinsot {

namespace {
constexpr const char* default_folder = "output";
constexpr std::string_view scene_placeholder = "{scene}";

// Whether a picture or film is as its record says, or is a part of a film.
bool is_as_recorded(const std::filesystem::path& file) {
    return looks_like_part(file) || verify(file, read_record(file)).verified == Verified::yes;
}
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

std::vector<std::filesystem::path> files_read_for(const Scene& scene) {
    std::vector<std::filesystem::path> files{scene.file};
    const auto add = [&](const std::string& name) {
        if (!name.empty()) files.push_back(scene.file.parent_path() / name);
    };
    add(scene.body.mesh);
    add(scene.object.mesh);
    add(scene.measured.file);
    for (const FacePictureSpec& picture : scene.object.pictures) add(picture.file);
    return files;
}

OutputPlace::OutputPlace(const std::string& asked, const Scene& scene, std::string_view suffix)
    : path_(asked), inputs_(files_read_for(scene)), is_named_(!asked.empty()) {
    if (path_.empty()) {
        // Errors are reported when the file is opened.
        std::error_code ignored;
        made_ = std::filesystem::create_directory(default_folder, ignored);
        path_ = default_output(scene.name, suffix);
    }
    check(path_);
    if (!has_frame_number(path_)) return;
    for (const std::filesystem::path& input : inputs_)
        if (is_frame_of(input, path_)) check(path_.parent_path() / input.filename());
}

void OutputPlace::check(const std::filesystem::path& file) const {
    check_replaceable({.path = file,
                       .is_own = is_named_ ? IsOwn() : IsOwn(is_as_recorded),
                       .what = "the output",
                       .inputs = inputs_});
}

OutputPlace::~OutputPlace() {
    std::error_code not_empty;
    if (made_) std::filesystem::remove(default_folder, not_empty);
}

}  // namespace poinsot
