// Opens the session of a scene file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "production/session/session.h"
#include "scene/files/load_scene.h"

namespace poinsot {

// A request to open a scene.
struct SceneRequest {
    std::string file;
    // The scene itself; `file` is then its name in messages, in whose folder the files that it
    // names lie. Empty: it is read from the file.
    std::optional<std::string> text{};
    std::vector<Override> overrides{};
    OutsideFiles outside = OutsideFiles::refused;
    PrintChoices print{};
    std::vector<double> times_s{};  // instants outside of the film that a stepped motion must cover
    bool draws = true;              // false: only numbers are asked for
};

// The text of a scene, and the scene. Throw SceneError.
std::string text_of(const SceneRequest& request);
Scene scene_of(const SceneRequest& request);

// Its pictures have the fonts of this computer. Throws InputError.
Session open_session(const SceneRequest& request, const Task& task = {});

}  // namespace poinsot
