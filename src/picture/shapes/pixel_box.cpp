#include "shapes/pixel_box.h"

#include <algorithm>

namespace poinsot {

void PixelBox::add(const Eigen::Vector2d& point, double margin) {
    left = std::min(left, point.x() - margin);
    top = std::min(top, point.y() - margin);
    right = std::max(right, point.x() + margin);
    bottom = std::max(bottom, point.y() + margin);
}

PixelBox PixelBox::within(const PixelBox& other) const {
    return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
            std::min(bottom, other.bottom)};
}

PixelBox box_of(const Projection& projection) {
    const Eigen::Vector2d low = projection.corner, high = low + projection.size;
    return {low.x(), low.y(), high.x(), high.y()};
}

}  // namespace poinsot
