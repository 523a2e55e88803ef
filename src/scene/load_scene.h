// Reading a scene file: TOML → Scene, with a place for everything that is wrong.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace poinsot {

// An override is a "key=value" of --set. One that another option stands for begins with that
// option, which messages then name: "--size film.size=640x360". This is its "key=value".
std::string_view assignment_of(std::string_view override_text);

// Reads a scene file. The overrides replace, in order, what the file says; a value that is not TOML
// counts as a string. Throws SceneError, for a file that cannot
// be read, too. Files that the scene names are looked for in its own folder; only with `outside`
// allowed may they lie elsewhere.
Scene load_scene(const std::filesystem::path& file, std::span<const std::string> overrides = {},
                 OutsideFiles outside = OutsideFiles::refused);

// The same from text; `file_name` is used in messages, for the scene's name and for its folder.
Scene parse_scene(std::string_view text, const std::string& file_name,
                  std::span<const std::string> overrides = {},
                  OutsideFiles outside = OutsideFiles::refused);

// What stands in the file of a scene or a theme, at most most_scene_file_bytes of it. Throws
// SceneError for one that cannot be read.
std::string text_of_file(const std::filesystem::path& file);

}  // namespace poinsot
