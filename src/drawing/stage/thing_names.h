// The names of curves and surfaces in the picture: polhode, herpolhode, invariable plane, …
//
// Where a name stands is a function of the drawing alone, not of earlier frames. Names give way to
// the labels of vectors, and are left out where there is no room for them.
#pragma once

#include <string_view>
#include <vector>

#include "drawing/stage/panel.h"
#include "drawing/stage/stage_store.h"
#include "drawing/stage/type/labels.h"
#include "shapes/views.h"

namespace poinsot {

struct NamedThing;

// A name that a panel shows if it shows the thing.
struct ThingName {
    const NamedThing* thing = nullptr;
    TextBlock type;
    Colour colour;
    Eigen::Vector2d offset_px = Eigen::Vector2d::Zero();  // by hand
};

// Sets the names that the scene wants in this panel, at its size.
std::vector<ThingName> set_thing_names(const Panel& panel, StageStore& store);

// Adds the names of what the view shows to its labels. Its other labels are placed already;
// `overlays` are boxes of text over all panels. Returns the things that are shown but whose names
// have no room.
std::vector<std::string_view> place_thing_names(const Panel& panel,
                                                const std::vector<ThingName>& names,
                                                const std::vector<LabelBox>& overlays, View& view);

}  // namespace poinsot
