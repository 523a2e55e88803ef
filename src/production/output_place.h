// Where a picture or film goes: the user's name with its number and its scene put in, or a place of
// our own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "scene/scene.h"

namespace poinsot {

// Whether a name asks for the scene's with {scene}.
bool has_scene_name(std::string_view pattern);

// The pattern with every {scene} replaced by the scene's name. A '#' in that counts nothing, so it
// becomes '_'.
std::filesystem::path with_scene_name(const std::filesystem::path& pattern,
                                      std::string_view scene_name);

// The same, its first #### replaced by a number.
std::filesystem::path numbered_output(const std::filesystem::path& pattern, std::int64_t number,
                                      std::string_view scene_name);

// output/<scene> with a suffix.
std::filesystem::path default_output(std::string_view scene_name, std::string_view suffix);

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
