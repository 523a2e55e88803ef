// The picture or film that a file describes, drawn again.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "production/picture.h"
#include "production/record.h"
#include "production/telling.h"
#include "scene/load_scene.h"

namespace poinsot {

struct RedrawRequest {
    std::filesystem::path file;
    // A file of the same kind; {scene} in its name becomes the scene's, #### the frame's number.
    std::filesystem::path output{};
    Backend backend = Backend::automatic;
    OutsideFiles outside = OutsideFiles::refused;
};

// Whether a file can be drawn again here, as far as that can be told without drawing.
struct RedrawCheck {
    std::string obstacle;            // why it cannot be, in a line; empty: it can
    std::vector<std::string> notes;  // what may keep it from the same bytes, a line each
};

// Reads the scene of the file's record, makes its motion and its stage, and opens the renderer. The
// request's output is not looked at.
RedrawCheck check_redraw(const RedrawRequest& request, const Record& record,
                         const Telling& telling);

// Draws as the file's record says; what may keep this machine from the same bytes is told. Throws
// InputError for a file without a record, and for a mesh or a picture that has changed since;
// EnvironmentError.
void redraw(const RedrawRequest& asked, const Telling& telling);

}  // namespace poinsot
