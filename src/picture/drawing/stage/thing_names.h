// The names of curves and surfaces in the picture: polhode, herpolhode, invariable plane, …
//
// In a film the side of a name is planned once for all frames: the name keeps its side for seconds,
// so that it moves smoothly with what it names, and fades quickly where it appears, changes its
// side or leaves. In a still it stands on the side where there is most room. Names give way to the
// labels of vectors. All distances are in the height of the letters, so that the choice does not
// depend on the picture's size.
#pragma once

#include <vector>

#include "drawing/stage/panel.h"
#include "drawing/stage/stage_store.h"
#include "drawing/stage/type/labels.h"
#include "drawing/stage/type/named_thing.h"
#include "shapes/views.h"

namespace poinsot {

// Sets the names that the scene wants in this panel, at its size.
std::vector<ThingName> set_thing_names(const Panel& panel, StageStore& store);

// The distance of names from the edges of the panel.
double name_margin_px(const Panel& panel);

// Adds the names of the things that the view shows to its labels. Its other labels are placed
// already; `overlays` are boxes of text over all panels. `is_planned`: whether the view is that of
// the film at `film_s`, for which the spans are made; else each name stands where there is room.
// Returns the things that are shown without their names.
std::vector<UnnamedThing> place_thing_names(const Panel& panel, const std::vector<ThingName>& names,
                                            const std::vector<LabelBox>& overlays, double film_s,
                                            bool is_planned, View& view);

// A view whose labels are placed, without the names of things, and the boxes that are taken
// besides: at first those of the text over all panels.
struct PlacedLabels {
    const View* view = nullptr;
    std::vector<LabelBox> taken;
    double film_s = 0.0;
};

// Seconds of a film that a page repeats at a stop: its end looks like its beginning.
struct FilmLoop {
    double begin_s = 0.0, end_s = 0.0;
};

// Plans where each name stands in a film, from instants spread evenly over it, at least two.
// `is_loop`: the whole film is one; `loops`: those of stops. The plan does not depend on which part
// of the film is made.
void plan_names(const Panel& panel, std::vector<PlacedLabels> instants, bool is_loop,
                const std::vector<FilmLoop>& loops, std::vector<ThingName>& names);

}  // namespace poinsot
