// The picture or film that a file describes, drawn again.
#pragma once

#include <filesystem>
#include <string>

#include "production/picture.h"
#include "production/telling.h"
#include "scene/load_scene.h"

namespace poinsot {

struct RedrawRequest {
    std::filesystem::path file;
    // A file of the same kind; {scene} in its name becomes the scene's, #### the frame's number.
    std::filesystem::path output;
    Backend backend = Backend::automatic;
    OutsideFiles outside = OutsideFiles::refused;
};

// Draws as the file's record says; what may keep this machine from the same bytes is told. Throws
// InputError for a file without a record, and for a mesh or a picture that has changed since;
// EnvironmentError.
void redraw(const RedrawRequest& asked, const Telling& telling);

}  // namespace poinsot
