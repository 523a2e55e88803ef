#include "drawing/figures/elements/filled_annulus.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "drawing/figures/elements/trail.h"
#include "mechanics/free/free_rotation.h"
#include "numerics/three_gaps.h"

namespace poinsot {

namespace {

using std::numbers::pi;

// Advance of the contact point about L in one polhode period, in turns, in the axes shown.
double advance_turns(const StageContext& stage) {
    if (stage.turns()) return 0.0;  // those axes turn with it
    return stage.motion.motion().free_constants().advance_per_period_rad.value_or(0.0) / (2.0 * pi);
}

Polhode::Annulus circles_of(const StageContext& stage) { return stage.rolling->polhode.annulus(); }

// An instant at which the curve touches a circle of the annulus, searched through half a period, in
// which it touches each once.
double touching_s(const PathPoint& point, double period_s, bool outer) {
    constexpr int n = 4096;
    int best = 0;
    double best_radius = point(0.0).norm();
    for (int k = 1; k < n; ++k) {
        const double radius = point(period_s * k / n).norm();
        if (outer ? radius > best_radius : radius < best_radius) best = k, best_radius = radius;
    }
    return period_s * best / n;
}

// Largest distance of the curve from a circle of the annulus after it has turned about L by half of
// `gap_rad` from the point where it touches this circle: there two neighbouring turns meet that
// touch the circle `gap_rad` apart.
double notch(const StageContext& stage, const PathPoint& point, double period_s, double gap_rad,
             bool outer) {
    const Polhode::Annulus annulus = circles_of(stage);
    const double radius = outer ? annulus.outer : annulus.inner;
    const double touches_s = touching_s(point, period_s, outer);
    const Eigen::Vector3d from = point(touches_s);
    constexpr double step = 1.0 / 65536.0;  // of a period
    double deepest = 0.0;
    for (const double side : {1.0, -1.0}) {
        for (int k = 1; k <= 4096; ++k) {
            const Eigen::Vector3d at = point(touches_s + side * k * step * period_s);
            const double angle = std::atan2(from.cross(at).norm(), from.dot(at));
            if (k == 4096) return std::numeric_limits<double>::infinity();
            // The instant of contact is known to a sixteenth of the search step.
            if (k <= 16 || angle < 0.5 * gap_rad) continue;
            deepest = std::max(deepest, std::abs(at.norm() - radius));
            break;
        }
    }
    return deepest;
}

}  // namespace

std::optional<double> retracing_s(const StageContext& stage, double span_s, double longest_s,
                                  double tolerance) {
    const FreeRotationConstants constants = stage.motion.motion().free_constants();
    const double outer = circles_of(stage).outer;
    if (stage.rolling->polhode.kind() == Polhode::Kind::circle) {
        // A circle, traversed at a constant rate; in axes that turn with it, a point.
        const double rate_rad_s = std::abs(constants.mean_advance_rate_rad_s);
        if (!(rate_rad_s > 0.0)) return std::nullopt;
        const double turn_s = 2.0 * pi / rate_rad_s;
        return turn_s <= longest_s ? std::optional(turn_s) : std::nullopt;
    }
    if (!constants.polhode_period_s) return std::nullopt;
    const double period_s = *constants.polhode_period_s;
    const double most = std::min(longest_s / period_s, 1e9);
    const auto k =
        returning_mark(advance_turns(stage), static_cast<std::int64_t>(most),
                       [&](std::int64_t n_periods, double distance) {
                           const double n_times =
                               std::max(1.0, span_s / (static_cast<double>(n_periods) * period_s));
                           return n_times * 2.0 * pi * distance * outer <= 0.5 * tolerance;
                       });
    if (!k) return std::nullopt;
    return static_cast<double>(*k) * period_s;
}

std::optional<FilledAnnulus> filled_annulus(const StageContext& stage, const PathPoint& point,
                                            double tolerance, double width,
                                            std::size_t most_points) {
    const FreeRotationConstants constants = stage.motion.motion().free_constants();
    const Polhode::Annulus annulus = circles_of(stage);
    if (!constants.polhode_period_s || stage.turns() || !(width > 0.0)) return std::nullopt;
    // After half a polhode period, ω has returned with two components reversed, and the curve
    // repeats, rotated about L by half of the period's advance.
    const double period_s = 0.5 * *constants.polhode_period_s;
    const double turned = 0.5 * advance_turns(stage);

    // The distance between turns is less than half a line's width, and the turns touch the circles
    // at such small intervals that the notches between them are invisible.
    double gap_rad = 0.5 * width / annulus.outer;
    const auto deepest_notch = [&] {
        return std::max(notch(stage, point, period_s, gap_rad, false),
                        notch(stage, point, period_s, gap_rad, true));
    };
    constexpr int most_halvings = 12;
    int n_halvings = 0;
    while (!(deepest_notch() <= tolerance) && n_halvings < most_halvings)
        gap_rad *= 0.5, ++n_halvings;
    if (n_halvings == most_halvings) return std::nullopt;
    const auto n_periods = marks_until_gap(turned, gap_rad / (2.0 * pi));
    if (!n_periods) return std::nullopt;

    FilledAnnulus filled;
    filled.filled_after_s = (*n_periods + 1.0) * period_s;

    // A spiral from one circle to the other, with one turn along each. The sagitta r(1 − cos(π/n))
    // stays below the tolerance.
    const double n_turns =
        std::max(1.0, std::ceil((annulus.outer - annulus.inner) / (0.5 * width)));
    const double n_a_turn =
        std::max(64.0, std::ceil(pi / std::sqrt(2.0 * std::min(1.0, tolerance / annulus.outer))));
    if (!((n_turns + 2.0) * n_a_turn < static_cast<double>(most_points))) return std::nullopt;
    const Eigen::Vector3d normal = stage.rolling->construction.normal_space();
    const Eigen::Vector3d across = normal.unitOrthogonal(), along = normal.cross(across);
    const int n = static_cast<int>((n_turns + 2.0) * n_a_turn);
    for (int k = 0; k <= n; ++k) {
        const double turn = k / n_a_turn;
        const double share = std::clamp((turn - 1.0) / n_turns, 0.0, 1.0);
        const double radius = annulus.inner + share * (annulus.outer - annulus.inner);
        const double angle = 2.0 * pi * turn;
        filled.points.push_back(radius * (std::cos(angle) * across + std::sin(angle) * along));
    }
    return filled;
}

std::optional<AnnulusCurve> annulus_of(
    const Panel& panel, StageStore& store, const TimedCurve& timed, const Curve& curve,
    const std::function<CurveGeometry(const std::vector<Eigen::Vector3d>& points)>& place) {
    if (!timed.annulus) return std::nullopt;
    AnnulusCurve annulus{timed.annulus->from_s, curve};
    annulus.curve.geometry =
        keep(panel, store, place(timed.annulus->points), panel.curve_units(), "the ring");
    annulus.curve.dash_px = 0.0;
    annulus.curve.lasting = true;
    store.note(
        "the herpolhode has so many turns that its curve covers its ring; it is drawn as a filled "
        "ring");
    return annulus;
}

}  // namespace poinsot
