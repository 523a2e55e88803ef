// Reading a scene file: TOML → Scene, with a place for everything that is wrong.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace poinsot {

// Reads a scene file. `overrides` are the "key=value" of --set, in order: they replace what the
// file says; a value that is not TOML counts as a string. Throws SceneError, for a file that cannot
// be read, too.
Scene load_scene(const std::filesystem::path& file, std::span<const std::string> overrides = {});

// The same from text; `file_name` is used in messages and for the scene's name.
Scene parse_scene(std::string_view text, const std::string& file_name,
                  std::span<const std::string> overrides = {});

}  // namespace poinsot
