// Many rectangles of whole pixels drawn at once.
#pragma once

#include <vector>

#include "render/gl_handles.h"
#include "render/tile_mask.h"

namespace poinsot {

// Corners for shaders/rectangles.vert.
class Rectangles {
 public:
    Rectangles();
    // Draws them with the program in use.
    void draw(const std::vector<PixelRect>& rects);

 private:
    GlVertexArray vertex_array_;
    GlBuffer corners_, indices_;
    std::size_t n_most_ = 0;  // that there are elements for
    std::vector<float> values_;
};

// Makes elements for rectangles of four corners each in the element buffer that is bound.
void fill_rectangle_elements(std::size_t n_rectangles);

}  // namespace poinsot
