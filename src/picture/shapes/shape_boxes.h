// The rectangles in a picture that hold shapes: where a picture shows an element.
#pragma once

#include <optional>
#include <vector>

#include "shapes/pixel_box.h"
#include "shapes/views.h"

namespace poinsot {

// Collects the rectangles of the shapes of one view, in pixels of its drawing. A shape that reaches
// behind the eye has the whole view. Hidden parts count.
class ShapeBoxes {
 public:
    ShapeBoxes(const View& view, std::vector<PixelBox>& boxes) : projection_(view), boxes_(boxes) {}

    // Curves and arrows as many small rectangles along them.
    void add(const Curve& curve);
    void add(const Arrow& arrow);
    void add(const Dot& dot);
    void add(const Label& label);
    void add(const Ellipsoid& ellipsoid);
    void add(const Plane& plane);
    void add(const Cone& cone);
    void add(const Mesh& mesh);

 private:
    void add_to(PixelBox& box, const Eigen::Vector3d& point) const;
    void add_box(PixelBox box, double margin_share);
    void add_segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double half_px);
    void add_disc(const Eigen::Vector3d& centre, const Eigen::Vector3d& along,
                  const Eigen::Vector3d& across, const std::optional<Eigen::Vector3d>& apex);

    Projection projection_;
    std::vector<PixelBox>& boxes_;
};

}  // namespace poinsot
