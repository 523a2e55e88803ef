// The size of a picture on paper: millimetres, dots per inch and points, as pixels.
#pragma once

#include <optional>

namespace poinsot {

// Lines keep their proportion to type: labels are 34 pixels an em where a polhode is 4 pixels wide.
// So at 8.5 points a label, the curves are 1 point, L and ω 1.15, axes 0.85, an ellipsoid's
// principal sections 0.43, rulings and grids 0.25, titles 10 and captions 6.5 points.
constexpr double default_type_pt = 8.5;
constexpr double default_dpi = 300.0;

// A still's size on paper.
struct PrintChoices {
    std::optional<double> width_mm, height_mm;  // --width-mm, --height-mm
    std::optional<double> dpi;                  // --dpi
    std::optional<double> type_pt;              // --type-pt, of labels
    int bit_depth = 8;                          // --depth
};

struct PrintSize {
    int width_px = 0, height_px = 0;
    double line_scale = 1.0;  // pixels for a line of "one pixel at 1080 rows"
    double pixels_per_metre = 0.0;
};

// Of a picture that has the scene's size in pixels unless millimetres are given; a side that is not
// given follows from the scene's shape. Nothing if the command line does not speak of paper.
// Throws InputError for sizes that no picture has, naming the option.
std::optional<PrintSize> print_size_of(const PrintChoices& print, int scene_width_px,
                                       int scene_height_px);

}  // namespace poinsot
