#include "production/output_place.h"

#include <string>
#include <system_error>

namespace poinsot {

namespace {
constexpr const char* kFolder = "output";
}

OutputPlace::OutputPlace(const std::string& asked, const Scene& scene, std::string_view suffix)
    : path_(asked) {
    if (!path_.empty()) return;
    // What cannot be made is said where the file is opened.
    std::error_code ignored;
    made_ = std::filesystem::create_directory(kFolder, ignored);
    path_ = std::filesystem::path(kFolder) / (scene.name + std::string(suffix));
}

OutputPlace::~OutputPlace() {
    std::error_code not_empty;
    if (made_) std::filesystem::remove(kFolder, not_empty);
}

}  // namespace poinsot
