// Draws curves as strokes of constant width in pixels.
#pragma once

#include "render/passes/curve_layer.h"
#include "render/passes/stroke.h"
#include "render/tile_mask.h"
#include "render/view_scene.h"

namespace poinsot {

// A curve of which all but the end is cached.
struct KeptStroke {
    const StrokeDashes& dashes;
    const StrokeEnds& ends;
    const CurveLayer& layer;
};

class CurvePass {
 public:
    void draw(const ViewScene& scene, const Curve& curve, CurveStore& store);
    // Draws the end of a curve, and its cached part from a layer, on these rectangles.
    void draw_kept(const ViewScene& scene, const Curve& curve, const KeptStroke& kept,
                   const std::vector<PixelRect>& rects, CurveStore& store);
    // Marks the tiles that the curve may touch.
    static void mark(const ViewScene& scene, const Curve& curve, CurveStore& store,
                     TileMask& marks);

 private:
    struct Stroke : StrokeProgram {
        explicit Stroke(const Solids& solids);
    };
    const Stroke& program_for(const ViewScene& scene, const Curve& curve);
    // layer: the cached part of the curve, or null.
    Constants constants_of(const ViewScene& scene, const Curve& curve, const StrokeDashes& dashes,
                           const CurveLayer* layer);

    BySolids<Stroke> strokes_;
    // Bound if nothing is cached: with the same types of textures, the driver can use one compiled
    // shader.
    KeptTextures none_{3, 3, false};
    int n_drawn_ = 0;  // since the depth buffer was cleared
};

}  // namespace poinsot
