#include "drawing/figures/elements/length_ticks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "drawing/stage/stage_store.h"
#include "shapes/projection.h"

namespace poinsot {

namespace {

constexpr double wanted_tick_spacing = 0.15;  // in largest half-axes
constexpr double tick_reach_px = 7.0;         // of a tick on each side of the curve, at 1080 rows
constexpr double tick_stroke_share = 0.6;     // of the curve's width
constexpr std::ptrdiff_t most_ticks_shown = 60;

// The vector from a point to the next one; at the end of an open curve zero.
Eigen::Vector3d next_step(const CurveGeometry& geometry, std::size_t k) {
    const auto& points = geometry.points;
    if (k + 1 < points.size()) return points[k + 1] - points[k];
    return geometry.closed ? (points.front() - points.back()).eval() : Eigen::Vector3d::Zero();
}

// The curve's opacity at one of its points, 0…1.
double presence_on(const Curve& curve, double index) {
    if (!(curve.fade_points > 0.0)) return 1.0;
    return std::clamp(1.0 - (curve.last - index) / curve.fade_points, 0.0, 1.0);
}

}  // namespace

bool wants_ticks(const Panel& panel) { return panel.stage->scene.trail.ticks; }

double tick_spacing(double length) {
    if (!(length > 0.0)) return wanted_tick_spacing;
    return length / std::max(1.0, std::round(length / wanted_tick_spacing));
}

double polygon_length(const CurveGeometry& geometry) {
    double length = 0.0;
    for (std::size_t k = 0; k < geometry.points.size(); ++k)
        length += next_step(geometry, k).norm();
    return length;
}

double nearest_place(const CurveGeometry& geometry, const Eigen::Vector3d& point) {
    double best = std::numeric_limits<double>::infinity(), place = 0.0;
    for (std::size_t k = 0; k < geometry.points.size(); ++k) {
        const Eigen::Vector3d side = next_step(geometry, k), to = point - geometry.points[k];
        const double share =
            std::clamp(to.dot(side) / std::max(side.squaredNorm(), 1e-300), 0.0, 1.0);
        const double off = (to - share * side).squaredNorm();
        if (!(off < best)) continue;
        best = off;
        place = static_cast<double>(k) + share;
    }
    return place;
}

LengthTicks::LengthTicks(const Panel& panel, StageStore& store, const CurveGeometry& geometry,
                         double spacing, double origin, const NormalAt& normal_at)
    : panel_(&panel), segment_(store.unit_segment()) {
    const auto& points = geometry.points;
    if (points.size() < 2 || !(spacing > 0.0)) return;
    // The length up to the origin.
    double to_origin = 0.0;
    const double whole = std::floor(origin);
    for (std::size_t k = 0; k < static_cast<std::size_t>(whole); ++k)
        to_origin += next_step(geometry, k).norm();
    to_origin +=
        (origin - whole) *
        next_step(geometry, std::min(static_cast<std::size_t>(whole), points.size() - 1)).norm();
    double next = std::fmod(to_origin, spacing), run = 0.0;
    // A closed curve's last tick would be its first again.
    const double end = geometry.closed ? polygon_length(geometry) - 1e-6 * spacing
                                       : std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Eigen::Vector3d side = next_step(geometry, k);
        const double piece = side.norm();
        for (; piece > 0.0 && next <= run + piece && next < end; next += spacing) {
            const double share = (next - run) / piece;
            Tick& tick = ticks_.emplace_back();
            tick.index = static_cast<double>(k) + share;
            tick.at = points[k] + share * side;
            tick.aside = normal_at(tick.at).cross(side).normalized();
        }
        run += piece;
    }
}

void LengthTicks::add_to(ViewBuilder& builder, Curve curve) const {
    const auto begin = std::lower_bound(ticks_.begin(), ticks_.end(), curve.first,
                                        [](const Tick& t, double x) { return t.index < x; });
    const auto end = std::upper_bound(begin, ticks_.end(), curve.last,
                                      [](double x, const Tick& t) { return x < t.index; });
    for (auto tick = end - std::min(end - begin, most_ticks_shown); tick != end; ++tick) {
        const Eigen::Vector3d at = curve.placement * tick->at;
        const Projected here = project(builder.view, at);
        if (!(here.depth > 0.0)) continue;
        const double reach = tick_reach_px * panel_->px * units_per_pixel(builder.view, here.depth);
        const Eigen::Vector3d aside = reach * (curve.placement.linear() * tick->aside).normalized();
        Curve mark = curve;
        mark.geometry = segment_;
        mark.first = 0.0;
        mark.last = 1e300;
        mark.width_px = tick_stroke_share * curve.width_px;
        mark.dash_px = mark.fade_points = 0.0;
        mark.lasting = false;
        mark.placement.linear() << 2.0 * aside, aside.unitOrthogonal(),
            aside.normalized().cross(aside.unitOrthogonal());
        mark.placement.translation() = at - aside;
        mark.opacity *= presence_on(curve, tick->index);
        if (mark.opacity > 0.0) builder.view.curves.push_back(mark);
    }
}

}  // namespace poinsot
