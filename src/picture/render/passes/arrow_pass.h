// Draws arrows and dots, farthest first.
#pragma once

#include <vector>

#include "render/passes/program.h"
#include "render/tile_mask.h"
#include "render/view_scene.h"

namespace poinsot {

class ArrowPass {
 public:
    // Hidden parts are drawn before the curves, visible parts after them.
    enum class Layer { hidden, visible };
    // Sorts the view's arrows and dots; must be called before `draw`.
    void order(const ViewScene& scene);
    void draw(const ViewScene& scene, Layer layer);
    void mark(const ViewScene& scene, TileMask& marks) const;

 private:
    void draw_arrow(const ViewScene& scene, const Arrow& arrow, Layer layer);
    void draw_dot(const ViewScene& scene, const Dot& dot, Layer layer);

    struct ArrowProgram : PolygonProgram {
        explicit ArrowProgram(const Solids& solids);
    };
    struct DotProgram : PolygonProgram {
        explicit DotProgram(const Solids& solids);
    };
    BySolids<ArrowProgram> arrow_programs_;
    BySolids<DotProgram> dot_programs_;
    std::vector<std::size_t> order_;  // arrows by index, dots after them
};

}  // namespace poinsot
