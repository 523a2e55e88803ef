// The contents of a journal's figure, for comparison with the journal's requirements.
#pragma once

#include <string>
#include <vector>

#include "shapes/views.h"

namespace poinsot {

// Sizes in points, contrasts as colour_vision.h defines them.
struct FigureReport {
    double width_mm = 0.0, height_mm = 0.0;
    double least_line_pt = 0.0;    // of lines and the shafts of arrows; 0: none
    double least_type_pt = 0.0;    // of letters; 0: no text
    double least_script_pt = 0.0;  // of sub- and superscripts; 0: none
    // Least contrasts with the page, of what is drawn: faded colours are blended with the page. 0:
    // none.
    double type_contrast = 0.0;
    double line_contrast = 0.0;         // of lines and arrows where they are visible
    double hidden_contrast = 0.0;       // of their parts that are drawn pale behind bodies
    double margin_pt = 0.0;             // from the page's edges to the nearest text or arrow
    std::vector<std::string> left_out;  // what the page does not show, in words
};

// `pt_per_px`: of the drawing.
FigureReport report_on(const Drawing& drawing, double pt_per_px);

// One line for each property.
std::string in_words(const FigureReport& report);

}  // namespace poinsot
