// The contract between whoever draws and whoever makes pictures of it: plain shapes in views, with
// nothing of the physics in them.
//
// Lengths are in *picture units*: each view has its own axes, chosen by the drawing layer so that
// everything that matters has a size of order one (the largest half-axis of the ellipsoid is 1).
// Sizes that end in _px are pixels of the final picture. Colours are sRGB-encoded components in [0,
// 1]; a renderer mixes them in linear light.
#pragma once

#include <deque>
#include <vector>

#include "shapes/camera.h"
#include "shapes/colour.h"
#include "shapes/labels.h"
#include "shapes/lines.h"
#include "shapes/solids.h"

namespace poinsot {

// One picture within the picture, with its own axes and camera. Pixels, y down, row 0 on top.
struct View : SolidLists, LineLists {
    int x_px = 0, y_px = 0, width_px = 0, height_px = 0;
    Camera camera;
    Light light;
    Background background;
    std::vector<Label> labels;
    std::deque<GlyphMask> live_masks;       // of labels that belong to this drawing alone
    std::deque<CurveGeometry> live_curves;  // likewise of curves
};

// Passes each list of a view's shapes to a function, labels among them.
template <typename Function>
void for_each_list(View& view, const Function& function) {
    for_each(static_cast<SolidLists&>(view), function);
    for_each(static_cast<LineLists&>(view), function);
    function(view.labels);
}

// A whole video frame or still, or a part of one that is drawn by itself.
struct Drawing {
    int width_px = 0, height_px = 0;
    Background background;
    // Of a part: the rows that the background's gradient spans, from a row above the part or its
    // first; 0 rows: those of the picture.
    int background_top_px = 0, background_rows_px = 0;
    std::vector<View> views;
};

}  // namespace poinsot
