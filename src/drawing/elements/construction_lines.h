// What elements on the lines of the construction share with other panels: how much of the plane is
// seen, and the scale of its distances.
#pragma once

#include <array>

#include "drawing/panel.h"

namespace poinsot {

// How much of the invariable plane's opacity is left to a camera, 0…1: between the eye and the body
// the plane is glass that the body is seen through, from grazing views on by degrees, for there
// hardly any of it is seen. `foot`: the plane's point on L.
double plane_presence(const Eigen::Vector3d& foot, const Camera& camera);

// How far a plane about a point is drawn, at most `wanted`: so near that the rim towards us is
// seen, for then the panel has no hard edge and the plane is faint where the caption stands;
// `least` at least. Needs the panel's camera.
double radius_in_view(const Panel& panel, const Eigen::Vector3d& centre, double least,
                      double wanted);

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

}  // namespace poinsot
