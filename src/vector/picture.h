// Draws shapes as a page of vectors, as render/ draws them as pixels. Depends on shapes/ only.
#pragma once

#include "shapes/views.h"
#include "vector/canvas.h"
#include "vector/page.h"

namespace poinsot::vector {

struct PageChoices {
    double pt_per_px = 0.24;  // points on paper per pixel of the drawing
    Shading shading = Shading::tone;
    DrawPixels draw_pixels{};  // used only by Shading::picture
};

// Returns the page of a drawing. It refers to the drawing's fonts, which must outlive it.
Page page_of(const Drawing& drawing, const PageChoices& choices);

}  // namespace poinsot::vector
