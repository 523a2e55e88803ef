// Many pictures in one, each with its values below.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "production/session/files/open_session.h"
#include "production/session/print_size.h"
#include "production/session/session.h"
#include "production/session/still_moment.h"
#include "production/session/task.h"
#include "production/stills/picture.h"
#include "production/vectors/vector_still.h"

namespace poinsot {

struct SheetCell {
    SceneRequest scene;
    std::string caption;   // running text with formulas
    std::string values{};  // the same as plain text, for the record
};

struct SheetRequest {
    std::vector<SheetCell> cells;  // row by row
    int n_columns = 1, n_rows = 1;
    std::string output;              // a PNG, a PDF or an SVG
    std::optional<double> time_s{};  // of the motion; empty: see `when`
    StillTime when = StillTime::common;
    // For vectors; the width is that of the sheet.
    PrintChoices print{};
    VectorChoices vectors{};
};

// Draws the sheet; places after the last cell stay empty. Throws InputError for more cells than
// places, for pictures of different sizes, and for a sheet larger than the largest picture;
// EnvironmentError.
void draw_sheet(const SheetRequest& request, LazyRenderer& renderer, const Task& task);

}  // namespace poinsot
