// The size and the times of a drawing.
#pragma once

#include <optional>
#include <vector>

#include "drawing/stage/type/least_sizes.h"
#include "shapes/camera.h"
#include "typeset/font_source.h"

namespace poinsot {

struct StageOptions {
    int width_px = 1920;
    int height_px = 1080;
    int samples = 1;          // samples × samples rendered pixels form one final pixel
    double line_scale = 0.0;  // pixels for a line of "one pixel at 1080 rows"; 0: height_px / 1080
    double px_per_pt = 0.0;   // pixels of a point on paper; 0: height_px / 540, as on a slide
    // Largest distance of polylines from their curves; 0: from the scene's accuracy.
    double curve_px = 0.0;
    LeastSizes least{};         // on paper, of the picture drawn
    double first_time_s = 0.0;  // the instants that are drawn lie between these; histories begin
    double last_time_s = 0.0;   // with the first and are made up to the last
    std::optional<double> first_shown_s{};  // no instant before it is drawn; else the first
    // A single picture: names and leaders are whole or absent, instead of fading as in a film.
    bool is_still = false;
    double repeat_s = 0.0;  // of the motion, after which the picture repeats; 0: never
    // Cameras to use instead of those that frame the motion, by panel; empty: none. Moving cameras
    // keep theirs.
    std::vector<std::optional<Camera>> views{};
    FontSource fonts{};
};

}  // namespace poinsot
