// Outlines of the curves and surfaces of a view in the picture: where a name can point to.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "shapes/views.h"

namespace poinsot {

// A visible point of a curve or of a surface's outline, and the straight piece that ends there.
struct VisiblePoint {
    Eigen::Vector3d at;             // view axes
    Eigen::Vector2d px, before_px;  // the point, and the beginning of its piece
    double weight_px = 0.0;         // the piece's length, less where the outline fades out
};
using Outline = std::vector<VisiblePoint>;

// Some `most` points of a curve, at fixed places of its geometry, and its ends, without those that
// a surface hides.
Outline outline_of(const View& view, const Curve& curve, int most);
// The limb of an ellipsoid, as seen from far away.
Outline outline_of(const View& view, const Ellipsoid& ellipsoid, int most);
// A circle.
Outline outline_of(const View& view, const Eigen::Vector3d& centre, const Eigen::Vector3d& axis,
                   double radius, int most);
// The rim of a cone.
Outline outline_of(const View& view, const Cone& cone, int most);

// The outline's outermost point in a direction of the picture. It moves smoothly with direction and
// outline: it is a mean of the points within a few `blur_px` of the outermost.
struct OutermostPoint {
    Eigen::Vector3d at;
    Eigen::Vector2d px;
    double spread_px = 0.0;  // how far apart these points are
};
std::optional<OutermostPoint> outermost(const Outline& outline, const Eigen::Vector2d& direction,
                                        double blur_px);

// Where the picture of a point is relative to that of an ellipsoid: less than 1 inside, 1 on its
// limb.
double nearness_to_ellipsoid(const View& view, const Ellipsoid& ellipsoid,
                             const Eigen::Vector2d& px);

// The same for a cone: 1 on its outline at the height of the point, infinite beyond its ends.
double nearness_to_cone(const View& view, const Cone& cone, const Eigen::Vector2d& px);

}  // namespace poinsot
