// Ticks at equal lengths along the contact point's two paths. The ellipsoid rolls without slipping,
// so the two paths are equally long between the same instants: counted from the contact at one
// instant, their ticks meet at the contact.
#pragma once

#include <functional>
#include <vector>

#include "drawing/stage/panel.h"

namespace poinsot {

// The distance between ticks, in picture units: the polhode's length divided by a whole number, so
// that ticks meet again after each round; a fixed distance on a curve that does not close.
// `length`: of the closed polhode; 0: it does not close.
double tick_spacing(double length);

// The ticks of one curve.
class LengthTicks {
 public:
    // Outward direction of the curve's surface at one of its points, in the geometry's axes.
    using NormalAt = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

    // `origin`: a tick's place, in points of the curve.
    LengthTicks(const Panel& panel, StageStore& store, const CurveGeometry& geometry,
                double spacing, double origin, const NormalAt& normal_at);

    // Adds the ticks on the shown part of the curve, in its colour; only the newest ones, so that a
    // long history costs no more than a short one.
    void add_to(ViewBuilder& builder, Curve curve) const;

 private:
    struct Tick {
        double index = 0.0;         // in points of the curve
        Eigen::Vector3d at, aside;  // across the curve on its surface, unit
    };
    const Panel* panel_;
    const CurveGeometry* segment_;
    std::vector<Tick> ticks_;
};

// Whether the scene requests ticks.
bool wants_ticks(const Panel& panel);

// The length of a curve's polygon; of a closed one including its last side.
double polygon_length(const CurveGeometry& geometry);

// The place on a curve that is nearest to a point, in points of the curve.
double nearest_place(const CurveGeometry& geometry, const Eigen::Vector3d& point);

}  // namespace poinsot
