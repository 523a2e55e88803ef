// The names of curves and surfaces in the picture: polhode, herpolhode, invariable plane, …
//
// In a film a name keeps its side, which is chosen once for all frames, so that it moves smoothly
// with what it names, and fades out where there is no room for it. In a still it stands on the side
// where there is most room. Names give way to the labels of vectors.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/stage/panel.h"
#include "drawing/stage/stage_store.h"
#include "drawing/stage/type/labels.h"
#include "shapes/views.h"

namespace poinsot {

struct NamedThing;

// The side of a thing: a direction in the picture, from right to below, and a distance from 0,
// near, on.
struct NameSide {
    double angle_rad = 0.0;
    double level = 0.0;
};

// A name that a panel shows if it shows the thing.
struct ThingName {
    const NamedThing* thing = nullptr;
    TextBlock type;
    Colour colour;
    Eigen::Vector2d offset_px = Eigen::Vector2d::Zero();  // by hand
    std::optional<NameSide> side{};                       // absent: the best of the instant
};

// The words for curves and cones in texts of the scene, and the roles of their colours in the
// theme. Surfaces have no words here: their colours are too pale for letters.
struct ThingWords {
    std::string text;
    std::string_view role;
};
std::vector<ThingWords> words_of_things(const Scene& scene);

// Sets the names that the scene wants in this panel, at its size.
std::vector<ThingName> set_thing_names(const Panel& panel, StageStore& store);

// Adds the names of what the view shows to its labels. Its other labels are placed already;
// `overlays` are boxes of text over all panels. Returns the things that are shown without their
// names.
std::vector<UnnamedThing> place_thing_names(const Panel& panel, const std::vector<ThingName>& names,
                                            const std::vector<LabelBox>& overlays, View& view);

// A view whose labels are placed, without the names of things, and the boxes that are taken
// besides: at first those of the text over all panels.
struct PlacedLabels {
    const View* view = nullptr;
    std::vector<LabelBox> taken;
};

// Chooses the side of each name for all frames of a film, from instants of it. It depends neither
// on how much of a curve is drawn at an instant nor on which part of a film is made.
void choose_sides(const Panel& panel, std::vector<PlacedLabels> instants,
                  std::vector<ThingName>& names);

}  // namespace poinsot
