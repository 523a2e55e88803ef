// The interface between the drawing layer and the renderers: simple shapes in views, without
// physics.
//
// Lengths are in *picture units*: each view has its own axes, which the drawing layer chooses so
// that relevant objects have a size of order one (the largest half-axis of the ellipsoid is 1).
// Sizes that end in _px are pixels of the final picture. Colours are sRGB-encoded components in [0,
// 1]; a renderer blends them in linear light.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "shapes/camera.h"
#include "shapes/colour.h"
#include "shapes/labels.h"
#include "shapes/lines.h"
#include "shapes/solids.h"

namespace poinsot {

// A picture inside the picture, with its own axes and camera. Pixels, y down, row 0 is the top.
struct View : SolidLists, LineLists {
    int x_px = 0, y_px = 0, width_px = 0, height_px = 0;
    Camera camera;
    Light light;
    Background background;
    std::vector<Label> labels;
    std::string_view name{};                // the kind of panel
    std::deque<GlyphMask> live_masks;       // of labels used only in this drawing
    std::deque<CurveGeometry> live_curves;  // of curves used only in this drawing
};

// Passes each list of a view's shapes to a function, including labels.
template <typename Function>
void for_each_list(View& view, const Function& function) {
    for_each(static_cast<SolidLists&>(view), function);
    for_each(static_cast<LineLists&>(view), function);
    function(view.labels);
}

// Something that is shown without its name.
struct UnnamedThing {
    std::string_view name;
    bool is_in_sight = true;  // false: too little of it is seen; true: there is no room
};

// A whole video frame or still, or a part that is drawn separately.
struct Drawing {
    int width_px = 0, height_px = 0;
    Background background;
    // For a part: the rows over which the background's gradient extends, where the first may be
    // above the part; 0 rows: those of the picture.
    int background_top_px = 0, background_rows_px = 0;
    std::vector<View> views;
    // Text for which a page had no space: running text with formulas.
    std::vector<std::string> left_out{};
    // Things shown without their names.
    std::vector<UnnamedThing> unnamed{};
};

}  // namespace poinsot
