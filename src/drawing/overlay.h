// Type over the whole picture: the scene's title and caption, and the clock.
#pragma once

#include <string_view>
#include <vector>

#include "drawing/stage_data.h"

namespace poinsot {

// Drawers of the overlays that the scene asks for; without a list of its own it shows all that it
// has text for.
std::vector<Drawer> make_overlays(StageData& stage);

// Rows at the top and at the bottom of the picture that the overlays take.
struct OverlayBands {
    int top_px = 0;
    int bottom_px = 0;
};
OverlayBands overlay_bands(StageData& stage);

// Whether a name in `show` is one of these.
bool is_overlay(std::string_view name);

}  // namespace poinsot
