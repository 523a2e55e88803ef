// Path of a picture or film: the user's pattern with the scene's name and the number inserted, or a
// default path.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace poinsot {

// Whether a pattern contains {scene}.
bool has_scene_name(std::string_view pattern);

// The pattern with every {scene} replaced by the scene's name. A '#' in the scene's name becomes
// '_', since it is not part of a number.
std::filesystem::path with_scene_name(const std::filesystem::path& pattern,
                                      std::string_view scene_name);

// The same with the first #### replaced by a number.
std::filesystem::path numbered_output(const std::filesystem::path& pattern, std::int64_t number,
                                      std::string_view scene_name);

// output/<scene> with this suffix.
std::filesystem::path default_output(std::string_view scene_name, std::string_view suffix);

// The scene's file and those that it names: no output replaces them.
std::vector<std::filesystem::path> files_read_for(const Scene& scene);

// output/<scene> with a suffix, or the user's path. The folder output/ is created if needed, and
// removed again if it stays empty; other folders must exist.
class OutputPlace {
 public:
    // asked: the user's path, or empty. Throws as check_replaceable does: a file of the default
    // name is replaced if it is as its record says.
    OutputPlace(const std::string& asked, const Scene& scene, std::string_view suffix);
    ~OutputPlace();
    OutputPlace(OutputPlace&& other) noexcept
        : path_(std::move(other.path_)),
          inputs_(std::move(other.inputs_)),
          is_named_(other.is_named_),
          made_(std::exchange(other.made_, false)) {}
    OutputPlace& operator=(OutputPlace&&) = delete;

    const std::filesystem::path& path() const { return path_; }

    // Throws likewise for one of the files that the path numbers.
    void check(const std::filesystem::path& file) const;

 private:
    std::filesystem::path path_;
    std::vector<std::filesystem::path> inputs_;
    bool is_named_ = false, made_ = false;
};

}  // namespace poinsot
