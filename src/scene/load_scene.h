// Reads a scene file: TOML → Scene, with the place of each error.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace poinsot {

// Returns the "key=value" of an override. An override is the "key=value" of --set; if another
// option stands for it, the override begins with that option, for messages: "--size
// film.size=640x360".
std::string_view assignment_of(std::string_view override_text);

// Reads a scene file. The overrides replace values of the file, in order; a value that is not TOML
// is taken as a string. Throws SceneError, also if the file cannot be read. Files that the scene
// names are relative to its own folder and must lie there unless `outside` is allowed.
Scene load_scene(const std::filesystem::path& file, std::span<const std::string> overrides = {},
                 OutsideFiles outside = OutsideFiles::refused);

// Reads a scene from text; `file_name` is used in messages, for the scene's name and for its
// folder.
Scene parse_scene(std::string_view text, const std::string& file_name,
                  std::span<const std::string> overrides = {},
                  OutsideFiles outside = OutsideFiles::refused);

// Returns the text of a scene or theme file, at most most_scene_file_bytes of it. Throws SceneError
// for a file that cannot be read.
std::string text_of_file(const std::filesystem::path& file);

}  // namespace poinsot
