// How much of a path of the contact point is shown at an instant: all of it, what has been run
// along, or the last stretch, fading.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "construction/timed_path.h"
#include "drawing/stage_data.h"
#include "shapes/smooth_form.h"

namespace poinsot {

// A stretch of a path's points, in fractions of them, as Curve counts.
struct ShownStretch {
    double first = 0.0;
    double last = 0.0;
    double fade_points = 0.0;  // as in Curve
    bool grows = false;        // whether its end is where the contact point is
    bool lasting = false;      // as in Curve, where the points stand still

    void apply_to(Curve& curve) const {
        curve.first = first, curve.last = last, curve.fade_points = fade_points;
        curve.lasting = lasting;
    }
};

// A path that was sampled over the stretch of time that its trail needs, and no more.
class Trail {
 public:
    // `kind`: "whole", "history" or "fading". `period_s`: after which the path runs over itself,
    // if it does; then one period of it before the film begins was sampled, too.
    Trail(const StageData& stage, const std::string& kind, const TimedPath& path,
          std::optional<double> period_s);

    ShownStretch at(double time_s) const;

 private:
    std::string kind_;
    TimedPath times_;  // without its points
    double first_time_s_;
    double last_time_s_;
    std::optional<double> period_s_;
    double length_s_;
    bool loops_;  // there was motion before the first instant, the same as in the film
};

// What is drawn instead of a curve from an instant on: the line that fills the ring, in the axes of
// the curve's points.
struct RingFromThen {
    double from_s = 0.0;
    std::vector<Eigen::Vector3d> points;
};

// A path's points with the part of them that an instant shows.
struct TimedCurve {
    std::vector<Eigen::Vector3d> points;
    Trail trail;
    double off = 0.0;      // as in TimedPath; more than the tolerance: it cannot be drawn
    SmoothMaker smooth{};  // of motions in closed form
    std::optional<RingFromThen> ring{};
};

// The path of the contact point on the plane, measured from the foot of L in the ellipsoid's
// lengths, to a tolerance in them; in the space axes that the stage's instants are given in.
// `width` is that of the line that will be drawn, in the same lengths: a path of too many turns is
// a ring once such a line fills it; 0: never. Precondition, here and below: the stage has a
// construction.
TimedCurve herpolhode_trail(const StageData& stage, double tolerance, double width = 0.0);

// Where a point of the ellipsoid, in body axes and its lengths, is drawn.
using BodyMap = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

// The same on the ellipsoid, in body axes; or where `map` takes it, the tolerance being there.
TimedCurve polhode_trail(const StageData& stage, double tolerance, const BodyMap& map = {});

}  // namespace poinsot
