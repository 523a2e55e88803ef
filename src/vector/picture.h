// Shapes → a page of vectors: what render/ is for pixels. It sees shapes/ and nothing of what drew
// them.
#pragma once

#include "shapes/views.h"
#include "vector/canvas.h"
#include "vector/page.h"

namespace poinsot::vector {

struct PageChoices {
    double pt_per_px = 0.24;  // points on paper for a pixel of the drawing
    Shading shading = Shading::tone;
    DrawPixels draw_pixels{};  // asked by Shading::picture alone
};

// All that a drawing shows. The page refers to the drawing's fonts, which must outlive it.
Page page_of(const Drawing& drawing, const PageChoices& choices);

}  // namespace poinsot::vector
