// Small marks of constant size along a curve: chevrons, which show the direction of motion in a
// still, or ticks, which show how curves roll on each other.
#pragma once

#include <optional>
#include <vector>

#include "drawing/stage/panel.h"

namespace poinsot {

// How the marks of a curve lie on it.
struct Marking {
    double spacing = 1.0;
    bool backwards = false;  // the curve's points are in the order opposite to the motion
    // Ticks instead of chevrons, one of them at this index.
    std::optional<double> tick_at{};
};

// The marks of one curve, at fixed positions on the curve. Their spacing does not depend on how
// much of the curve is shown.
class DirectionMarks {
 public:
    DirectionMarks(const Panel& panel, StageStore& store, const CurveGeometry& geometry,
                   const Marking& marking);

    // Adds the marks on the shown part of the curve, in the curve's colour and opacity; only the
    // newest ones, so that a long history costs no more than a short one. Needs the builder's
    // camera. Copies `curve`, since it may be one of the builder's curves.
    void add_to(ViewBuilder& builder, Curve curve, bool grows) const;

 private:
    struct Mark {
        double index = 0.0;  // in points of the curve
        Eigen::Vector3d at, ahead;
    };
    const Panel* panel_;
    const CurveGeometry* form_;
    std::size_t most_;
    std::vector<Mark> marks_;
};

// Whether the scene requests direction marks.
bool wants_marks(const Panel& panel);

// The index of a curve's point that is nearest to a place, between its points.
double nearest_index(const CurveGeometry& geometry, const Eigen::Vector3d& place);

// The length of a curve, that of a closed one with its last piece.
double length_of(const CurveGeometry& geometry);

// Whether the contact point moves against the order of a polhode's points, in body axes at any
// scale: evaluated at the motion's start, where dω/dt = J⁻¹(Jω × ω) (Landau & Lifshitz, Mechanics
// §36).
bool runs_backwards(const Panel& panel, const std::vector<Eigen::Vector3d>& points);

}  // namespace poinsot
