#include "drawing/line_rules.h"

#include <algorithm>

namespace poinsot {

namespace {

void raise(double& width_px, double least_px) {
    if (width_px > 0.0) width_px = std::max(width_px, least_px);
}

void thicken(double least_px, View& view) {
    for (Ellipsoid& ellipsoid : view.ellipsoids) {
        raise(ellipsoid.section_px, least_px);
        raise(ellipsoid.ruling_px, least_px);
    }
    for (Plane& plane : view.planes) raise(plane.grid_px, least_px);
    // Its rulings are thinner than its rim.
    constexpr double ruling_share = 0.6;
    for (Cone& cone : view.cones) raise(cone.rim_px, least_px / ruling_share);
    for (Curve& curve : view.curves) raise(curve.width_px, least_px);
    for (Arrow& arrow : view.arrows) raise(arrow.shaft_px, least_px);
    for (Dot& dot : view.dots) raise(dot.rim_px, least_px);
}

}  // namespace

void follow_line_rules(const StageData& stage, View& view) {
    if (stage.options.least.line_px > 0.0) thicken(stage.options.least.line_px, view);
}

}  // namespace poinsot
