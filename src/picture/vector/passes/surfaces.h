// Surfaces drawn as pixels by an external renderer.
#pragma once

#include <functional>

#include "vector/canvas.h"

namespace poinsot::vector {

// Renders a drawing to pixels of the size that it gives.
using DrawPixels = std::function<Raster(const Drawing& drawing)>;
// Draw surfaces in pixels of at least 600 per inch: first everything around the ellipsoids, which
// are slightly smaller there; then the ellipsoids, slightly larger, clipped by their outlines.
void draw_ground_pixels(const Canvas& canvas, const DrawPixels& draw);
void draw_ellipsoid_pixels(const Canvas& canvas, const DrawPixels& draw);

}  // namespace poinsot::vector
