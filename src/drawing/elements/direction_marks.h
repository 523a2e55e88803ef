// Small chevrons of constant size along a curve, so that a still shows which way it is run along.
#pragma once

#include <vector>

#include "drawing/panel.h"

namespace poinsot {

// The chevrons of one curve: they stand on the curve at places that never change, as many as keep a
// distance that does not depend on how much of the curve is shown.
class DirectionMarks {
 public:
    // `backwards`: the curve's points run against the motion.
    DirectionMarks(Panel& panel, const CurveGeometry& geometry, double spacing, bool backwards);

    // Adds those on the shown stretch of the curve, in its colour and as opaque as the curve is
    // there; the newest ones only, so that a long history costs no more than a short one. Needs the
    // sheet's camera. Copies `curve`: it may be one of the sheet's.
    void add_to(Sheet& sheet, Curve curve, bool grows) const;

 private:
    struct Mark {
        double index = 0.0;  // in points of the curve
        Eigen::Vector3d at, ahead;
    };
    Panel* panel_;
    const CurveGeometry* chevron_;
    std::vector<Mark> marks_;
};

// Whether the scene wants them.
bool wants_marks(const Panel& panel);

// Whether the contact point runs against the order of a polhode's points, in body axes at any
// scale: at the motion's start, where dω/dt = J⁻¹(Jω × ω) (Landau & Lifshitz, Mechanics §36).
bool runs_backwards(const Panel& panel, const std::vector<Eigen::Vector3d>& points);

}  // namespace poinsot
