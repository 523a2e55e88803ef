#include "drawing/figures/elements/direction_marks.h"

#include <algorithm>
#include <cmath>

#include "shapes/projection.h"

namespace poinsot {

namespace {

constexpr double reach_px = 9.0;       // length of an arm along and across the curve, at 1080 rows
constexpr double stroke_share = 0.75;  // of the curve's width
constexpr std::size_t most_marks = 16;

// From the end of one arm over the tip to the end of the other; the tip points along x.
CurveGeometry chevron() {
    CurveGeometry geometry;
    geometry.points = {{-1.0, 0.8, 0.0}, {0.0, 0.0, 0.0}, {-1.0, -0.8, 0.0}};
    return geometry;
}

// The curve's opacity at one of its points, 0…1.
double presence_at(const Curve& curve, double index) {
    if (!(curve.fade_points > 0.0)) return 1.0;
    return std::clamp(1.0 - (curve.last - index) / curve.fade_points, 0.0, 1.0);
}

}  // namespace

bool wants_marks(const Panel& panel) { return panel.stage->scene.trail.direction_marks; }

bool runs_backwards(const Panel& panel, const std::vector<Eigen::Vector3d>& points) {
    const MotionProblem& problem = panel.stage->motion.motion().problem();
    const Eigen::Matrix3d& axes = problem.inertia.body_from_principal();
    const Eigen::Vector3d& moments = problem.inertia.moments_kg_m2();
    const Eigen::Vector3d omega = axes.transpose() * problem.start.omega_body;
    const Eigen::Vector3d rate =
        moments.cwiseProduct(omega).cross(omega).cwiseQuotient(moments).stableNormalized();
    const Eigen::Vector3d towards = axes * rate;
    const Eigen::Vector3d contact = problem.start.omega_body.stableNormalized();
    double best = -1.0;
    bool backwards = false;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double nearness = points[i].normalized().dot(contact);
        if (nearness <= best) continue;
        best = nearness;
        backwards = (points[i] - points[i - 1]).dot(towards) < 0.0;
    }
    return backwards;
}

DirectionMarks::DirectionMarks(const Panel& panel, StageStore& store, const CurveGeometry& geometry,
                               double spacing, bool backwards)
    : panel_(&panel), chevron_(keep(panel, store, chevron(), 0.0, "a direction mark")) {
    const std::vector<Eigen::Vector3d>& points = geometry.points;
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    // A closed curve has an integral number of equal gaps.
    const double step =
        geometry.closed ? length / std::max(1.0, std::round(length / spacing)) : spacing;
    if (!(step > 0.0)) return;
    double next = 0.5 * step;
    double run = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Eigen::Vector3d along = points[i] - points[i - 1];
        const double piece = along.norm();
        while (piece > 0.0 && next <= run + piece) {
            const double share = (next - run) / piece;
            Mark mark;
            mark.index = static_cast<double>(i - 1) + share;
            mark.at = points[i - 1] + share * along;
            mark.ahead = (backwards ? -1.0 : 1.0) / piece * along;
            marks_.push_back(mark);
            next += step;
        }
        run += piece;
    }
}

void DirectionMarks::add_to(ViewBuilder& builder, Curve curve, bool grows) const {
    const auto begin = std::lower_bound(marks_.begin(), marks_.end(), curve.first,
                                        [](const Mark& m, double x) { return m.index < x; });
    const auto end = std::upper_bound(marks_.begin(), marks_.end(), curve.last,
                                      [](double x, const Mark& m) { return x < m.index; });
    const auto n_shown = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, end - begin));
    const auto newest = end - static_cast<std::ptrdiff_t>(std::min(n_shown, most_marks));
    const Eigen::Matrix3d axes = camera_axes(builder.view.camera);
    for (auto mark = n_shown > 0 ? newest : end; mark != end; ++mark) {
        const Eigen::Vector3d at = curve.placement * mark->at;
        const Eigen::Vector3d ahead = (curve.placement.linear() * mark->ahead).normalized();
        const Projected here = project(builder.view, at);
        if (!(here.depth > 0.0)) continue;
        // In the picture plane, so that its size is constant; invisible where the curve points at
        // the eye.
        const double unit = units_per_pixel(builder.view, here.depth);
        const Projected there = project(builder.view, at + 0.5 * reach_px * unit * ahead);
        const Eigen::Vector2d run = (there.px - here.px) / (0.5 * reach_px);
        const double flat = std::clamp(run.norm() / 0.4, 0.0, 1.0);
        if (!(run.norm() > 1e-6)) continue;
        const Eigen::Vector2d direction = run.normalized();
        const Eigen::Vector3d forward = direction.x() * axes.col(0) - direction.y() * axes.col(1);

        Curve arms = curve;
        arms.geometry = chevron_;
        arms.first = 0.0;
        arms.last = 1e300;
        arms.width_px = stroke_share * curve.width_px;
        arms.dash_px = arms.fade_points = 0.0;
        arms.lasting = false;
        const double size = reach_px * panel_->px * unit;
        arms.placement.linear() << forward, axes.col(2).cross(forward), axes.col(2);
        arms.placement.linear() *= size;
        arms.placement.translation() = at;
        // A mark fades in at the end of a growing curve, and fades out as the oldest one.
        double opacity = flat * presence_at(curve, mark->index);
        if (grows) {
            const double gap = marks_.size() > 1 ? marks_[1].index - marks_[0].index : 1.0;
            opacity *= std::clamp(3.0 * (curve.last - mark->index) / std::max(gap, 1e-9), 0.0, 1.0);
            if (n_shown > most_marks && mark == newest && end != marks_.end()) {
                const double step = std::max(1e-9, end->index - (end - 1)->index);
                opacity *= std::clamp(1.0 - (curve.last - (end - 1)->index) / step, 0.0, 1.0);
            }
        }
        arms.opacity *= opacity;
        if (arms.opacity > 0.0) builder.view.curves.push_back(arms);
    }
}

}  // namespace poinsot
