// Where a picture or film goes unless the user says.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "scene/scene.h"

namespace poinsot {

// output/<scene> with a suffix, or what the user has said. That folder is made when it is missing
// and goes again if nothing came to lie in it; a folder that the user names is theirs to make.
class OutputPlace {
 public:
    // asked: what the user has said, or empty.
    OutputPlace(const std::string& asked, const Scene& scene, std::string_view suffix);
    ~OutputPlace();
    OutputPlace(OutputPlace&& other) noexcept
        : path_(std::move(other.path_)), made_(std::exchange(other.made_, false)) {}
    OutputPlace& operator=(OutputPlace&&) = delete;

    const std::filesystem::path& path() const { return path_; }

 private:
    std::filesystem::path path_;
    bool made_ = false;
};

}  // namespace poinsot
