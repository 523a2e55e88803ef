// Opens the session of a scene file.
#pragma once

#include <string>
#include <vector>

#include "production/session/session.h"
#include "scene/files/load_scene.h"

namespace poinsot {

// A request to open a scene file.
struct SceneRequest {
    std::string file;
    std::vector<std::string> overrides;  // see load_scene
    OutsideFiles outside = OutsideFiles::refused;
    PrintChoices print;
    std::vector<double> times_s;  // instants outside of the film that a stepped motion must cover
};

// Its pictures have the fonts of this computer. Throws InputError.
Session open_session(const SceneRequest& request, const ProgressSink& progress = {});

}  // namespace poinsot
