// Reads a scene file, and the files that it names, from the disk.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "scene/parse_scene.h"

namespace poinsot {

// Whether a scene may name files outside its own folder.
enum class OutsideFiles { refused, allowed };

// The files of a scene's own folder, in which they must lie unless `outside` is allowed.
SceneFiles files_of_folder(OutsideFiles outside = OutsideFiles::refused);

// Reads a scene file and the files that it names; see parse_scene. Throws SceneError, also if the
// file cannot be read.
Scene load_scene(const std::filesystem::path& file, std::span<const Override> overrides = {},
                 OutsideFiles outside = OutsideFiles::refused);

// Returns the text of a scene or theme file, at most most_scene_file_bytes of it. Throws SceneError
// for a file that cannot be read.
std::string text_of_file(const std::filesystem::path& file);

}  // namespace poinsot
