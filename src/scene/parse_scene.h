// Reads a scene: TOML → Scene, with the place of each error.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"
#include "scene/scene_files.h"

namespace poinsot {

// Returns the "key=value" of an override. An override is the "key=value" of --set; if another
// option stands for it, the override begins with that option, for messages: "--size
// film.size=640x360".
std::string_view assignment_of(std::string_view override_text);

// Reads a scene from text; `file_name` is used in messages, for the scene's name and for its
// folder. The overrides replace values of the text, in order; a value that is not TOML is taken as
// a string. `files` gives the bytes of the files that the scene names. Throws SceneError.
Scene parse_scene(std::string_view text, const std::string& file_name,
                  std::span<const std::string> overrides = {},
                  const SceneFiles& files = no_scene_file);

}  // namespace poinsot
