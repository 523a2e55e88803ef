#include "drawing/figures/elements/direction_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shapes/projection.h"

namespace poinsot {

namespace {

constexpr double reach_px = 9.0;       // length of an arm along and across the curve, at 1080 rows
constexpr double stroke_share = 0.75;  // of the curve's width
constexpr double tick_px = 6.5;        // half of its length
constexpr std::size_t most_chevrons = 16, most_ticks = 1000;

// From the end of one arm over the tip to the end of the other; the tip points along x.
CurveGeometry chevron() {
    CurveGeometry geometry;
    geometry.points = {{-1.0, 0.8, 0.0}, {0.0, 0.0, 0.0}, {-1.0, -0.8, 0.0}};
    return geometry;
}

CurveGeometry tick() {
    CurveGeometry geometry;
    geometry.points = {{0.0, tick_px / reach_px, 0.0}, {0.0, -tick_px / reach_px, 0.0}};
    return geometry;
}

// A piece of a curve between two of its points. `length` is that of the arc, not of its chord: the
// chords of many turns would be short by pixels.
struct Piece {
    Eigen::Vector3d from, along;
    double length = 0.0;
};

std::vector<Piece> pieces_of(const CurveGeometry& geometry) {
    const std::vector<Eigen::Vector3d>& points = geometry.points;
    if (points.empty()) return {};
    const std::size_t n = points.size() - (geometry.closed ? 0 : 1);
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector3d along = points[(i + 1) % points.size()] - points[i];
        pieces.push_back({points[i], along, along.norm()});
    }
    // The curvature between a piece and the next one: the angle between them over the way from the
    // middle of one to that of the other.
    std::vector<double> curvature(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        if (!geometry.closed && i + 1 == n) break;
        const Piece &a = pieces[i], &b = pieces[(i + 1) % n];
        const double angle = std::atan2(a.along.cross(b.along).norm(), a.along.dot(b.along));
        const double way = 0.5 * (a.along.norm() + b.along.norm());
        if (way > 0.0) curvature[i] = angle / way;
    }
    for (std::size_t i = 0; i < n; ++i) {
        const bool is_first = !geometry.closed && i == 0, is_last = !geometry.closed && i + 1 == n;
        const double before = is_first ? curvature[i] : curvature[(i + n - 1) % n];
        const double after = is_last ? before : curvature[i];
        // An arc of the angle θ is longer than its chord by θ²/24 of it.
        const double angle = 0.5 * (before + after) * pieces[i].length;
        if (angle < 1.0) pieces[i].length *= 1.0 + angle * angle / 24.0;
    }
    return pieces;
}

// The length of a curve up to an index.
double length_to(const std::vector<Piece>& pieces, double index) {
    double length = 0.0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        length += std::clamp(index - static_cast<double>(i), 0.0, 1.0) * pieces[i].length;
    return length;
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

double nearest_index(const CurveGeometry& geometry, const Eigen::Vector3d& place) {
    double least = std::numeric_limits<double>::infinity(), found = 0.0;
    double i = 0.0;
    for (const Piece& piece : pieces_of(geometry)) {
        const double squared = piece.along.squaredNorm();
        const double share =
            squared > 0.0 ? std::clamp(piece.along.dot(place - piece.from) / squared, 0.0, 1.0)
                          : 0.0;
        const double off = (piece.from + share * piece.along - place).squaredNorm();
        if (off < least) least = off, found = i + share;
        i += 1.0;
    }
    return found;
}

double length_of(const CurveGeometry& geometry) {
    return length_to(pieces_of(geometry), std::numeric_limits<double>::infinity());
}

DirectionMarks::DirectionMarks(const Panel& panel, StageStore& store, const CurveGeometry& geometry,
                               const Marking& marking)
    : panel_(&panel),
      form_(keep(panel, store, marking.tick_at ? tick() : chevron(), 0.0, "a direction mark")),
      most_(marking.tick_at ? most_ticks : most_chevrons) {
    const std::vector<Piece> pieces = pieces_of(geometry);
    const double length = length_to(pieces, std::numeric_limits<double>::infinity());
    // A closed curve has an integral number of equal gaps.
    const double step = geometry.closed
                            ? length / std::max(1.0, std::round(length / marking.spacing))
                            : marking.spacing;
    if (!(step > 0.0)) return;
    double next =
        marking.tick_at ? std::fmod(length_to(pieces, *marking.tick_at), step) : 0.5 * step;
    double run = 0.0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece& piece = pieces[i];
        while (piece.length > 0.0 && next <= run + piece.length) {
            const double share = (next - run) / piece.length;
            Mark mark;
            mark.index = static_cast<double>(i) + share;
            mark.at = piece.from + share * piece.along;
            mark.ahead = (marking.backwards ? -1.0 : 1.0) * piece.along.normalized();
            marks_.push_back(mark);
            next += step;
        }
        run += piece.length;
    }
}

void DirectionMarks::add_to(ViewBuilder& builder, Curve curve, bool grows) const {
    const auto begin = std::lower_bound(marks_.begin(), marks_.end(), curve.first,
                                        [](const Mark& m, double x) { return m.index < x; });
    const auto end = std::upper_bound(marks_.begin(), marks_.end(), curve.last,
                                      [](double x, const Mark& m) { return x < m.index; });
    const auto n_shown = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, end - begin));
    const auto newest = end - static_cast<std::ptrdiff_t>(std::min(n_shown, most_));
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
        arms.geometry = form_;
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
            if (n_shown > most_ && mark == newest && end != marks_.end()) {
                const double step = std::max(1e-9, end->index - (end - 1)->index);
                opacity *= std::clamp(1.0 - (curve.last - (end - 1)->index) / step, 0.0, 1.0);
            }
        }
        arms.opacity *= opacity;
        if (arms.opacity > 0.0) builder.view.curves.push_back(arms);
    }
}

}  // namespace poinsot
