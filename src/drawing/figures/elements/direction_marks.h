// Small chevrons of constant size along a curve, which show the direction of motion in a still.
#pragma once

#include <vector>

#include "drawing/stage/panel.h"

namespace poinsot {

// The chevrons of one curve, at fixed positions on the curve. Their spacing does not depend on how
// much of the curve is shown.
class DirectionMarks {
 public:
    // `backwards`: the curve's points are in the order opposite to the motion.
    DirectionMarks(const Panel& panel, StageStore& store, const CurveGeometry& geometry,
                   double spacing, bool backwards);

    // Adds the chevrons on the shown part of the curve, in the curve's colour and opacity; only the
    // newest ones, so that a long history costs no more than a short one. Needs the builder's
    // camera. Copies `curve`, since it may be one of the builder's curves.
    void add_to(ViewBuilder& builder, Curve curve, bool grows) const;

 private:
    struct Mark {
        double index = 0.0;  // in points of the curve
        Eigen::Vector3d at, ahead;
    };
    const Panel* panel_;
    const CurveGeometry* chevron_;
    std::vector<Mark> marks_;
};

// Whether the scene requests direction marks.
bool wants_marks(const Panel& panel);

// Whether the contact point moves against the order of a polhode's points, in body axes at any
// scale: evaluated at the motion's start, where dω/dt = J⁻¹(Jω × ω) (Landau & Lifshitz, Mechanics
// §36).
bool runs_backwards(const Panel& panel, const std::vector<Eigen::Vector3d>& points);

}  // namespace poinsot
