// The part of a path that is shown at an instant, of a contact point or of a top's axis: all of it,
// the part traversed so far, or the last part, fading.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "construction/timed_path.h"
#include "drawing/stage/drawer.h"
#include "drawing/stage/panel.h"
#include "drawing/stage/stage_context.h"
#include "shapes/smooth_form.h"

namespace poinsot {

// A part of a path, from and to as fractional point indices, as in Curve.
struct ShownStretch {
    double first = 0.0;
    double last = 0.0;
    double fade_points = 0.0;  // as in Curve
    bool grows = false;        // whether it ends at the moving point
    bool lasting = false;      // as in Curve, for fixed points

    void apply_to(Curve& curve) const {
        curve.first = first, curve.last = last, curve.fade_points = fade_points;
        curve.lasting = lasting;
    }
};

// A path sampled exactly over the time span that its trail needs.
class Trail {
 public:
    // `kind`: "whole", "history" or "fading". `period_s`: the time after which the path repeats, if
    // it does; then one period before the film's start was sampled, too.
    Trail(const StageContext& stage, const std::string& kind, const TimedPath& path,
          std::optional<double> period_s);

    ShownStretch at(double time_s) const;
    // The index of the point at the stage's first instant.
    double first_index() const { return times_.index_at(first_time_s_); }

 private:
    std::string kind_;
    TimedPath times_;  // without its points
    double first_time_s_;
    double last_time_s_;
    std::optional<double> period_s_;
    double length_s_;
    bool loops_;  // whether the film loops: then motion precedes the first instant
};

// The line that fills the annulus, in the axes of the curve's points, and the instant from which it
// replaces the curve.
struct AnnulusFromThen {
    double from_s = 0.0;
    std::vector<Eigen::Vector3d> points;
};

// A path's points with the part of them that an instant shows.
struct TimedCurve {
    std::vector<Eigen::Vector3d> points;
    Trail trail;
    double off = 0.0;      // as in TimedPath; more than the tolerance: it cannot be drawn
    SmoothMaker smooth{};  // of motions in closed form
    std::optional<AnnulusFromThen> annulus{};
};

// Draws the part of the curve that the trail shows at an instant.
Drawer traversed(Curve curve, Trail trail);

// The path of the contact point on the plane, measured from the foot of L in the ellipsoid's
// lengths, to a tolerance in them; in the space axes that the stage's instants are given in.
// `width` is that of the line that will be drawn, in the same lengths: a path of too many turns is
// an annulus once such a line fills it; 0: never. Precondition, here and below: the stage has a
// construction.
TimedCurve herpolhode_trail(const StageContext& stage, double tolerance, double width = 0.0);

// Width of the herpolhode's line, px at 1080 rows, where its annulus has a width of `annulus_px`
// pixels in the picture. On paper the line is thin enough that its turns stay apart.
double herpolhode_width_px(const Panel& panel, double annulus_px);

// Adds a herpolhode on a wider, pale line that keeps the plane's grid and shadow off it.
void add_on_grid(const Panel& panel, const Curve& curve, View& view);

// The place in the picture of a point of the ellipsoid, which is in body axes and its lengths.
using BodyMap = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

// The same on the ellipsoid, in body axes; or where `map` takes it, the tolerance being there.
TimedCurve polhode_trail(const StageContext& stage, double tolerance, const BodyMap& map = {});

}  // namespace poinsot
