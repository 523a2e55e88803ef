// Arrows and dots, farthest first.
#pragma once

#include <vector>

#include "render/program.h"
#include "render/tile_mask.h"
#include "render/view_scene.h"

namespace poinsot {

class ArrowPass {
 public:
    ArrowPass();

    // What is hidden is drawn before the curves, what is visible after them.
    enum class Layer { hidden, visible };
    // Orders the view's arrows and dots; to be called before `draw`.
    void order(const ViewScene& scene);
    void draw(const ViewScene& scene, Layer layer) const;
    void mark(const ViewScene& scene, TileMask& marks) const;

 private:
    void draw_arrow(const ViewScene& scene, const Arrow& arrow, Layer layer) const;
    void draw_dot(const ViewScene& scene, const Dot& dot, Layer layer) const;

    Program arrow_;
    GLint corners_, outline_, shape_, axis_, body_, base_, anchor_, colour_, style_;
    Program dot_;
    GLint dot_corners_, dot_at_, dot_colour_, dot_rim_, dot_style_;
    std::vector<int> order_;  // arrows by index, dots after them
};

}  // namespace poinsot
