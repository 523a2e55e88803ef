// Elements on the lines of the construction: L through its foot on the plane, ρ to the contact, ω
// and the axis of rotation along it, ∇F, and the distances between them. Rows of the table in
// elements.cpp; picture axes.
#pragma once

#include <array>

#include "drawing/panel.h"

namespace poinsot {

// How much of the invariable plane's opacity is left to a camera, 0…1: between the eye and the body
// the plane is glass that the body is seen through, from grazing views on by degrees, for there
// hardly any of it is seen. `foot`: the plane's point on L.
double plane_presence(const Eigen::Vector3d& foot, const Camera& camera);

// The distances 1/√I₁, 1/√I₂, 1/√I₃ at which a plane touches the ends of the half-axes, and √(2T)/L
// among them, on a scale along L beside the ellipsoid.
class LevelScale {
 public:
    explicit LevelScale(const Panel& panel);

    // Lengths in picture units. Needs the sheet's camera.
    void add_to(Sheet& sheet, const Eigen::Vector3d& half_axes, const Eigen::Vector3d& foot) const;

 private:
    static constexpr double tick = 0.06;  // half of it, picture units
    static constexpr double gap = 6.0;    // before a name, px at 1080 rows

    // How far to the right it stands, so that its names do not run out of the view.
    double aside(const View& view, const Eigen::Vector3d& right) const;

    const Panel* panel_;
    std::array<SetType, 3> types_;
    SetType own_;
};

// L from the centre through the plane, its foot there marked with a right angle.
Drawer make_momentum(Panel& panel);
// ω from the centre: to the contact, or beyond it where ρ is shown as well.
Drawer make_omega(Panel& panel);
// The line of all matter that is at rest at the instant: through centre and contact, and out.
Drawer make_spin_axis(Panel& panel);
// The point where ellipsoid and plane touch: the tip of ρ.
Drawer make_contact(Panel& panel);
// ρ = ω/√(2T), from the centre to the contact: F(ρ) = 1.
Drawer make_radius(Panel& panel);
// The plane that touches the ellipsoid at ρ: a patch of the invariable plane.
Drawer make_tangent(Panel& panel);
// ∇F at ρ: it points along L, as ∇F = 2 I ρ.
Drawer make_gradient(Panel& panel);
// The projection of ρ on L: from the tip of ρ across to L, and along L to the centre.
Drawer make_projection(Panel& panel);
// The plane's distance √(2T)/L from the centre, as a dimension line beside the ellipsoid.
Drawer make_distance(Panel& panel);
// That scale for the motion's own plane.
Drawer make_levels(Panel& panel);
// ω × r of the matter on the ellipsoid along an arc that faces the camera, from the contact, where
// it is at rest, to the other end of the axis.
Drawer make_velocity(Panel& panel);

}  // namespace poinsot
