// Type over the whole picture: the scene's title and caption, and the clock.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "drawing/stage_data.h"

namespace poinsot {

// Drawers of the overlays that the scene asks for; without a list of its own it shows all that it
// has text for.
std::vector<Drawer> make_overlays(StageData& stage);

// Rows at the top and at the bottom of the picture that the overlays take, and where the title
// ends.
struct OverlayBands {
    int top_px = 0;
    int bottom_px = 0;
    double title_right_px = 0.0;
};
OverlayBands overlay_bands(StageData& stage);

// What the overlays of a picture so wide take more than on a screen, where a line of "one pixel at
// 1080 rows" is `px` pixels wide: type that has its size in points takes more of a narrow page.
int rows_added_by_type(const Scene& scene, int width_px, double px, const LeastSizes& least);

// What they take of such a picture altogether.
int rows_of_overlays(const Scene& scene, int width_px, double px, const LeastSizes& least);

// Between the overlays and the picture's sides, pixels at 1080 rows.
constexpr double overlay_margin = 40.0;

// What they are called in `show` and in fades.
struct OverlayName {
    std::string_view name;
    std::string_view summary;
};
std::span<const OverlayName> overlays();

// Whether a name in `show` is one of these.
bool is_overlay(std::string_view name);

}  // namespace poinsot
