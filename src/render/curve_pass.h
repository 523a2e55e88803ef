// Curves as strokes of constant width in pixels, drawn anew for every picture.
#pragma once

#include "render/stroke.h"
#include "render/tile_mask.h"
#include "render/view_scene.h"

namespace poinsot {

class CurvePass {
 public:
    void draw(const ViewScene& scene, const Curve& curve, CurveStore& store);
    // Marks the tiles that the curve may touch.
    static void mark(const ViewScene& scene, const Curve& curve, CurveStore& store,
                     TileMask& marks);

 private:
    struct Stroke : StrokeProgram {
        explicit Stroke(const Solids& solids);
    };
    BySolids<Stroke> strokes_;
    int n_drawn_ = 0;  // since the depth buffer was emptied
};

}  // namespace poinsot
