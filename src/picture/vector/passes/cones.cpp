#include "vector/passes/cones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace poinsot::vector {

namespace {

using std::numbers::pi;

struct ConeAxes {
    explicit ConeAxes(const Cone& cone) : axis(cone.axis.normalized()) {
        const Eigen::Vector3d across = cone.reference - cone.reference.dot(axis) * axis;
        first = across.norm() > 1e-9 ? Eigen::Vector3d(across.normalized()) : axis.unitOrthogonal();
        second = axis.cross(first);
        constexpr double least = 1e-3;
        radius = cone.length * std::tan(std::clamp(cone.half_angle_rad, least, 0.5 * pi - least));
    }
    Eigen::Vector3d first, second, axis;
    double radius = 0.0;  // of the rim
};

// The colour of a cone at a point of the paper, with the colour behind it.
struct ConeSeen {
    int n_sheets = 0;
    ColourOver look;
};

ConeSeen seen_at(const Canvas& canvas, const Cone& cone, const ConeAxes& axes,
                 const Eigen::Vector2d& at) {
    // Intersects the line of sight o + t d with the cone: across² = (slope along)², with `along` up
    // to that of the rim.
    const double slope = axes.radius / cone.length;
    const Eigen::Vector3d o = canvas.projection.ray_origin(at) - cone.apex;
    const Eigen::Vector3d d = canvas.projection.ray(at);
    const double o_along = o.dot(axes.axis), d_along = d.dot(axes.axis);
    const double a = d.squaredNorm() - (1.0 + slope * slope) * d_along * d_along;
    const double b = o.dot(d) - (1.0 + slope * slope) * o_along * d_along;
    const double c = o.squaredNorm() - (1.0 + slope * slope) * o_along * o_along;
    const double square = b * b - a * c;
    ConeSeen seen;
    seen.look.behind = canvas.behind(at);
    if (square < 0.0 || std::abs(a) < 1e-12) return seen;
    const double root = std::sqrt(square);
    std::array<double, 2> meetings{(-b - root) / a, (-b + root) / a};
    std::sort(meetings.begin(), meetings.end(), std::greater<>());
    Eigen::Vector3d light = linear(seen.look.behind);
    for (const double t : meetings) {
        const Eigen::Vector3d x = o + t * d;
        const double along = x.dot(axes.axis);
        if (along <= 0.0 || along >= cone.length) continue;
        ++seen.n_sheets;
        const Eigen::Vector3d outward =
            (x - (1.0 + slope * slope) * along * axes.axis).normalized();
        const Eigen::Vector3d to_eye = -d.normalized();
        const double side = outward.dot(to_eye) < 0.0 ? -1.0 : 1.0;
        const Layer layer = cone_surface(cone, canvas.lights, {side * outward, to_eye});
        const Cover cover = canvas.occluders.at(cone.apex + x, {});
        const double alpha = layer.alpha * (cover.clear + (1.0 - cover.clear) * cover.transmitted);
        light += alpha * (layer.light - light);
    }
    seen.look.wanted = encoded(light);
    return seen;
}

// The outline of the view's only ellipsoid, across which the look of a cone changes; nothing if
// there are several.
std::optional<PaperEllipse> only_outline(const Canvas& canvas) {
    if (canvas.view.ellipsoids.size() != 1) return std::nullopt;
    const auto limb = limb_of(canvas.occluders.spheres()[0]);
    return limb ? picture_of(*limb, canvas.projection) : std::nullopt;
}

// Fills the region inside the rim, where a line of sight meets one sheet, and the region between
// rim and apex, where it meets both; each with one ink that is right on average.
void fill_sheets(const Canvas& canvas, const Cone& cone, const ConeAxes& axes,
                 const PaperEllipse& rim, Path hull) {
    constexpr int n = 32;
    const std::optional<PaperEllipse> outline = only_outline(canvas);
    const Eigen::Vector2d apex = canvas.projection.place(cone.apex);
    const Eigen::Vector2d reach = (rim.a.cwiseAbs2() + rim.b.cwiseAbs2()).cwiseSqrt();
    const Eigen::Vector2d low = apex.cwiseMin(rim.centre - reach);
    const Eigen::Vector2d step = (apex.cwiseMax(rim.centre + reach) - low) / n;
    std::array<std::array<std::vector<ColourOver>, 2>, 2> looks;  // by outline and number of sheets
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const Eigen::Vector2d at = low + step.cwiseProduct(Eigen::Vector2d(i + 0.5, j + 0.5));
            const ConeSeen seen = seen_at(canvas, cone, axes, at);
            if (seen.n_sheets == 0) continue;
            const bool within = outline && outline->radius_of(at) < 1.0;
            looks[within ? 1 : 0][seen.n_sheets == 2 ? 1 : 0].push_back(seen.look);
        }
    Path within_rim = canvas.path_of(rim);
    Path between = std::move(hull);
    if (!between.steps.empty()) between.add(within_rim);
    const bool is_split = !(looks[0][0].empty() && looks[0][1].empty()) &&
                          !(looks[1][0].empty() && looks[1][1].empty());
    for (const bool within : {false, true}) {
        const auto& [one, both] = looks[within ? 1 : 0];
        if (one.empty() && both.empty()) continue;
        if (is_split) canvas.add(canvas.clip_to(*outline, within));
        if (!both.empty() && !between.steps.empty()) canvas.add(Fill{between, ink_for(both), true});
        if (!one.empty()) canvas.add(Fill{within_rim, ink_for(one), false});
        if (is_split) canvas.add(ClipEnd{});
    }
}

void stroke_track(const Canvas& canvas, const Track& track, const Colour& colour, double opacity,
                  double width_pt) {
    for (const Span& span : canvas.occluders.spans(track, {})) {
        const double shown =
            opacity * (span.cover.clear + (1.0 - span.cover.clear) * span.cover.transmitted);
        if (shown < 1e-3) continue;
        Stroke stroke;
        stroke.path = canvas.path_of(track, span.from, span.to, conic_tolerance_pt);
        const Eigen::Vector3d middle = track.flow(0.5 * (span.from + span.to)).position;
        stroke.ink = as_in_light(colour, shown, canvas.behind(canvas.projection.place(middle)));
        stroke.width_pt = width_pt;
        stroke.round = false;
        canvas.add(std::move(stroke));
    }
}

// The rim of a cone and the two generators along which its surface turns away from the eye, in the
// cone's colour.
void draw_cone_contour(const Canvas& canvas, const Cone& cone, const ConeAxes& axes,
                       const Conic& rim) {
    const Projection& projection = canvas.projection;
    const Colour colour = contour_colour(cone.colour, canvas.ground(projection.place(cone.apex)));
    const double width_pt = std::max(canvas.line_pt(cone.rim_px), contour_pt);
    stroke_track(canvas, track_of(rim, 0.0, 2.0 * pi), colour, cone.presence, width_pt);
    // The normal at the angle s is cos s first + sin s second - slope axis; on the contour it is
    // perpendicular to the line of sight.
    const Eigen::Vector3d sight = projection.towards_eye(cone.apex);
    const double first = sight.dot(axes.first), second = sight.dot(axes.second);
    const double swing = std::hypot(first, second);
    const double needed = axes.radius / cone.length * sight.dot(axes.axis);
    if (!(std::abs(needed) < swing)) return;  // the eye sees into the cone, or along its axis
    const double middle = std::atan2(second, first), reach = std::acos(needed / swing);
    for (const double angle : {middle - reach, middle + reach}) {
        const Eigen::Vector3d run = rim.at(angle) - cone.apex;
        Track track;
        track.flow = [apex = cone.apex, run](double s) { return CurveFlow{apex + s * run, run}; };
        track.knots = {0.0, 1.0};
        stroke_track(canvas, track, colour, cone.presence, width_pt);
    }
}

}  // namespace

void draw_cone(const Canvas& canvas, const Cone& cone) {
    if (!(cone.opacity > 0.0 && cone.presence > 0.0 && cone.length > 0.0)) return;
    const ConeAxes axes(cone);
    const Eigen::Vector3d middle = cone.apex + cone.length * axes.axis;
    const Conic rim{middle, axes.radius * axes.first, axes.radius * axes.second};
    const auto ellipse = picture_of(rim, canvas.projection);
    const Projection& projection = canvas.projection;
    if (!ellipse ||
        (projection.perspective && projection.depth(cone.apex) <= projection.near_depth))
        return;
    if (canvas.shading == Shading::none) {
        draw_cone_contour(canvas, cone, axes, rim);
        return;
    }
    const Eigen::Vector2d apex = projection.place(cone.apex);

    if (canvas.has_fills()) {
        // Rim and apex, and the region between them.
        const Eigen::Vector2d from_rim = ellipse->paper_from_circle().inverse() * apex;
        const double apart = from_rim.norm();
        Path hull;
        if (apart > 1.0) {
            const double towards = std::atan2(from_rim.y(), from_rim.x());
            const double touch = std::acos(1.0 / apart);
            const double from = towards + touch, to = towards + 2.0 * pi - touch;
            hull.add(arc_of(*ellipse, from, to,
                            std::max(2, static_cast<int>(std::ceil((to - from) / 0.7)))));
            hull.line(apex);
            hull.close();
        }
        fill_sheets(canvas, cone, axes, *ellipse, std::move(hull));
    }
    const ConeLines lines = cone_lines();
    const Colour dark = encoded(lines.tone * linear(cone.colour));
    if (cone.rim_px > 0.0)
        stroke_track(canvas, track_of(rim, 0.0, 2.0 * pi), dark, lines.rim_opacity * cone.presence,
                     canvas.line_pt(cone.rim_px));
    for (int k = 0; k < cone.n_rulings; ++k) {
        const double angle = cone.phase_rad + 2.0 * pi * k / cone.n_rulings;
        const Eigen::Vector3d end = rim.at(angle);
        const Eigen::Vector3d run = end - cone.apex;
        // Towards the apex the lines become dense and fade, as on the screen: they end where half
        // the opacity is left.
        constexpr double half_left_px = 9.0;
        const Eigen::Vector3d along_rim =
            std::cos(angle) * rim.sine_axis - std::sin(angle) * rim.cosine_axis;
        const double apart_px =
            spacing_px(projection, end, run, 2.0 * pi / cone.n_rulings * along_rim);
        if (!(apart_px > half_left_px)) continue;
        Track track;
        track.flow = [apex_at = cone.apex, run](double s) {
            return CurveFlow{apex_at + s * run, run};
        };
        track.knots = {half_left_px / apart_px, 1.0};
        stroke_track(canvas, track, dark, lines.generator_opacity * cone.presence,
                     canvas.line_pt(0.6 * cone.rim_px));
    }
}

}  // namespace poinsot::vector
