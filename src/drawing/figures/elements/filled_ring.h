// The herpolhode when it has more turns than can be drawn: it then runs over itself, or it has
// filled the ring between the circles that it touches.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "drawing/stage/panel.h"

namespace poinsot {

struct TimedCurve;

// A point of the herpolhode at an instant, measured from the foot of L, in the axes shown.
using PathPoint = std::function<Eigen::Vector3d(double time_s)>;

// The time, up to `longest_s`, after which the herpolhode runs over itself: for as long as `span_s`
// to within half of `tolerance`. None where it does not. Precondition, here and below: a motion in
// closed form, whose herpolhode is no point.
std::optional<double> retracing_s(const StageContext& stage, double span_s, double longest_s,
                                  double tolerance);

// The ring as a line that is wound up in it, so closely that the line's width leaves nothing free.
struct FilledRing {
    double filled_after_s = 0.0;  // of the motion from where the curve begins
    std::vector<Eigen::Vector3d> points;
};

// A line of `width` along the herpolhode leaves nothing of the ring free from that time on, and
// what its edge then looks like is within `tolerance` of the ring's. None where that is never, or
// where the line would need more than `most_points`.
std::optional<FilledRing> filled_ring(const StageContext& stage, const PathPoint& point,
                                      double tolerance, double width, std::size_t most_points);

// The ring in a panel, and the instant from which it replaces the curve.
struct RingCurve {
    double from_s = 0.0;
    Curve curve;
};

// The ring of a trail, where it has one, drawn as the trail's `curve` is; `place` takes its points
// to the panel. Notes that it is drawn.
std::optional<RingCurve> ring_of(
    const Panel& panel, StageStore& store, const TimedCurve& timed, const Curve& curve,
    const std::function<CurveGeometry(const std::vector<Eigen::Vector3d>& points)>& place);

}  // namespace poinsot
