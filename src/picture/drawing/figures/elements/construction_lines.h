// Shared by the elements on the lines of the construction and by other panels: the plane's
// visibility, and the scale of its distances.
#pragma once

#include <array>

#include "drawing/stage/panel.h"

namespace poinsot {

// The factor of the invariable plane's opacity for a camera, 0…1: a plane between the eye and the
// body must be transparent so that the body stays visible. The factor rises gradually from grazing
// views on, where the plane covers hardly anything. `foot`: the plane's point on L.
double plane_presence(const Eigen::Vector3d& foot, const Camera& camera);

// Radius to which a plane about a point is drawn, between `least` and `wanted`: so small that the
// rim is in view, so that the panel has no hard edge; only on a screen may the plane continue to
// the picture's sides and its upper edge. Needs the panel's camera.
double radius_in_view(const Panel& panel, const Eigen::Vector3d& centre, double least,
                      double wanted);

// The distances 1/√I₁, 1/√I₂, 1/√I₃ at which a plane touches the ends of the half-axes, and
// √(2T)/L, on a scale along L beside the ellipsoid.
class LevelScale {
 public:
    explicit LevelScale(const Panel& panel, StageStore& store);

    // Lengths in picture units. Needs the builder's camera.
    void add_to(ViewBuilder& builder, const Eigen::Vector3d& half_axes,
                const Eigen::Vector3d& foot) const;

 private:
    static constexpr double tick = 0.06;  // half of its length, picture units
    static constexpr double gap = 6.0;    // before a name, px at 1080 rows

    // How far to the right the scale is placed, so that its names stay in the view.
    double aside(const View& view, const Eigen::Vector3d& right) const;

    const Panel* panel_;
    std::array<TextBlock, 3> types_;
    TextBlock distance_;
};

}  // namespace poinsot
