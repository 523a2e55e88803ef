// The size of a picture on paper: millimetres, dots per inch and points, as pixels.
#pragma once

#include <optional>
#include <string>

#include "drawing/stage/type/least_sizes.h"

namespace poinsot {

constexpr double mm_per_inch = 25.4;
constexpr double pt_per_inch = 72.0;  // as in PDF

// Lines are proportional to text: labels are 34 pixels per em if a polhode is 4 pixels wide. With
// labels of 8.5 points, the curves are 1 point wide, L and ω 1.15, axes 0.85, an ellipsoid's
// principal sections, rulings and grids 0.5; titles are 10 points, captions and all other text 8
// points.
constexpr double default_type_pt = 8.5;
constexpr double longest_inches = 200.0;  // of a PDF page's side: ISO 32000-1, annex C
constexpr double least_dpi = 10.0, most_dpi = 10'000.0;
constexpr double default_dpi = 300.0;

// Options for a still's size on paper.
struct PrintChoices {
    std::optional<double> width_mm, height_mm;  // --width-mm, --height-mm
    std::optional<double> dpi;                  // --dpi
    std::optional<double> type_pt;              // --type-pt, size of labels
    std::string journal{};                      // --journal, whose limits apply
    // Lower limits of text, sub- and superscripts, and line widths.
    double least_type_pt = 8.0, least_script_pt = 6.0, least_line_pt = 0.5;
};

struct PrintSize {
    int width_px = 0, height_px = 0;
    double line_scale = 1.0;  // pixels for a line of "one pixel at 1080 rows"
    double pixels_per_metre = 0.0;
    double px_per_pt = 0.0;
    LeastSizes least{};
};

// The size on paper of a picture that has the scene's size in pixels unless millimetres are given;
// a side that is not given follows from the scene's aspect ratio. Empty if no option is about
// paper. Throws InputError for impossible sizes, with the option's name.
std::optional<PrintSize> print_size_of(const PrintChoices& print, int scene_width_px,
                                       int scene_height_px);

}  // namespace poinsot
