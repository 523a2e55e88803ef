// The herpolhode when it has more turns than can be drawn: it then runs over itself, or it has
// filled the annulus between the circles that it touches.
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

// The annulus as a line that is wound up in it, so closely that the line's width covers it all.
struct FilledAnnulus {
    double filled_after_s = 0.0;  // of the motion from where the curve begins
    std::vector<Eigen::Vector3d> points;
};

// The time after which a line of `width` along the herpolhode covers the annulus, with edges within
// `tolerance` of the annulus's, and the line that then replaces it; absent if the herpolhode never
// covers it, or if that line would need more than `most_points`.
std::optional<FilledAnnulus> filled_annulus(const StageContext& stage, const PathPoint& point,
                                            double tolerance, double width,
                                            std::size_t most_points);

// The annulus in a panel, and the instant from which it replaces the curve.
struct AnnulusCurve {
    double from_s = 0.0;
    Curve curve;
};

// The annulus of a trail, where it has one, drawn as the trail's `curve` is; `place` takes its
// points to the panel. Notes that it is drawn.
std::optional<AnnulusCurve> annulus_of(
    const Panel& panel, StageStore& store, const TimedCurve& timed, const Curve& curve,
    const std::function<CurveGeometry(const std::vector<Eigen::Vector3d>& points)>& place);

}  // namespace poinsot
