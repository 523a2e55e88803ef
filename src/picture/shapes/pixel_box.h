// Rectangles of a picture in pixels: x right, y down, pixel centres at half-integers.
#pragma once

#include <Eigen/Core>

#include "shapes/projection.h"

namespace poinsot {

// A rectangle of pixels; its sides may be fractional.
struct PixelBox {
    double left = 1e300, top = 1e300, right = -1e300, bottom = -1e300;
    bool operator==(const PixelBox&) const = default;
    bool empty() const { return !(left < right && top < bottom); }
    void add(const Eigen::Vector2d& point, double margin = 0.0);
    PixelBox within(const PixelBox& other) const;
};

// The rectangle of a projection's view.
PixelBox box_of(const Projection& projection);

}  // namespace poinsot
