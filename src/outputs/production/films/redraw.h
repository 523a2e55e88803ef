// Redraws the picture or film that a file's record describes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "production/records/record.h"
#include "production/session/task.h"
#include "production/stills/picture.h"
#include "scene/files/load_scene.h"

namespace poinsot {

struct RedrawRequest {
    std::filesystem::path file;
    // A file of the same kind; in its name, {scene} is replaced by the scene's name, #### by the
    // frame's number.
    std::filesystem::path output{};
    Backend backend = Backend::automatic;
    OutsideFiles outside = OutsideFiles::refused;
};

// Whether a file can be redrawn here, as far as is known without drawing.
struct RedrawCheck {
    std::string obstacle;            // the reason why not, one line; empty: it can be redrawn
    std::vector<std::string> notes;  // possible causes of different bytes, one line each
};

// Reads the scene of the file's record, makes its motion and its stage, and opens the renderer. The
// request's output is ignored.
RedrawCheck check_redraw(const RedrawRequest& request, const Record& record, const Task& task);

// Redraws a file from its record, and reports possible causes of different bytes. Throws InputError
// for a file without a record, and for a mesh or a picture that has changed since;
// EnvironmentError.
void redraw(const RedrawRequest& asked, const Task& task);

}  // namespace poinsot
