// The soft shadow of an ellipsoid on a plane: the same light as in render/shadow_web.h, drawn as
// nested outlines of equal darkness, between which it fades.
#include "vector/passes/shadow.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "shapes/soft_shadow.h"

namespace poinsot::vector {

namespace {

constexpr int most_levels = 12, n_spokes = 16;

// The places of a level of darkness on paper, one for each spoke.
using Outline = std::array<Eigen::Vector2d, n_spokes>;

// The distance along a direction from the hub up to which the shadow is darker than this level;
// searched from outside inwards.
double extent(const SoftShadow& shadow, const Eigen::Vector3d& direction, double level) {
    constexpr int n_steps = 48;
    const double limit = shadow.limit(direction);
    const auto is_darker = [&](double r) {
        return shadow.darkness(shadow.hub() + r * direction) > level;
    };
    double light = limit, dark = 0.0;
    for (int k = n_steps; k-- > 0;) {
        const double r = limit * k / n_steps;
        if (is_darker(r)) {
            dark = r;
            break;
        }
        light = r;
    }
    if (light <= 0.0) return 0.0;
    for (int k = 0; k < 24; ++k) {
        const double middle = 0.5 * (dark + light);
        (is_darker(middle) ? dark : light) = middle;
    }
    return dark;
}

// A smooth closed path through points on paper.
Path smooth_through(const Outline& places) {
    const auto at = [&](int k) -> const Eigen::Vector2d& {
        return places[static_cast<std::size_t>((k + n_spokes) % n_spokes)];
    };
    // Handles as long as those of a circle through the same number of points.
    constexpr double angle = 2.0 * std::numbers::pi / n_spokes;
    const double handle = 2.0 / 3.0 * std::tan(0.25 * angle) / std::sin(angle);
    Path path;
    path.move(at(0));
    for (int k = 0; k < n_spokes; ++k)
        path.cubic(at(k) + handle * (at(k + 1) - at(k - 1)),
                   at(k + 1) - handle * (at(k + 2) - at(k)), at(k + 1));
    path.close();
    return path;
}

// An ink that rises from nothing at one outline to its full opacity at the next one inside, so that
// the shadow has no visible steps.
Paint ramp(const Outline& outer, const Outline& inner, const PaperInk& ink) {
    const std::optional<PaperEllipse> rim = ellipse_through(outer), core = ellipse_through(inner);
    if (!rim) return ink;
    RadialFade fade;
    fade.paper_from_circle = rim->paper_from_circle();
    const Eigen::Affine2d to_circle = fade.paper_from_circle.inverse();
    const double share =
        core ? std::clamp(std::sqrt((to_circle * core->paper_from_circle()).linear().determinant()),
                          0.0, 0.98)
             : 0.0;
    // The circles in between shrink about one point.
    fade.focus = to_circle * (core ? core->centre : inner[0]) / (1.0 - share);
    constexpr double farthest = 0.95;
    if (fade.focus.norm() > farthest) fade.focus *= farthest / fade.focus.norm();
    fade.stops = {{0.0, ink}, {share, ink}, {1.0, {ink.colour, 0.0}}};
    return fade;
}

bool casts(const Ellipsoid& ellipsoid) {
    return ellipsoid.casts_shadow && ellipsoid.opacity > 0.0 && ellipsoid.presence > 0.0;
}

}  // namespace

Colour shadowed(const Canvas& canvas, const Plane& plane, const Eigen::Vector3d& point,
                const Colour& colour) {
    Eigen::Vector3d light = linear(colour);
    const Eigen::Vector3d tint = 0.06 * linear(plane.grid_colour);
    for (std::size_t k = 0; k < canvas.view.ellipsoids.size(); ++k) {
        if (!casts(canvas.view.ellipsoids[k])) continue;
        const SoftShadow shade(plane, canvas.occluders.spheres()[k],
                               canvas.view.ellipsoids[k].presence, canvas.view.light);
        const double darkness = shade.darkness(point);
        light = darkness * tint + (1.0 - darkness) * light;
    }
    return encoded(light);
}

void draw_shadow(const Canvas& canvas, const Plane& plane, std::size_t caster) {
    const Ellipsoid& ellipsoid = canvas.view.ellipsoids[caster];
    if (!canvas.has_fills() || !casts(ellipsoid)) return;
    const SoftShadow shade(plane, canvas.occluders.spheres()[caster], ellipsoid.presence,
                           canvas.view.light);
    const double deepest = shade.darkness(shade.hub());
    if (deepest <= 0.0) return;
    const Eigen::Vector3d across = plane.normal.cross(plane.along);
    // A dark shade of the plane's own colour looks calmer than black.
    const Colour tint = encoded(0.06 * linear(plane.grid_colour));
    // Some viewers round the result of each outline to whole levels of 255, so a dark plane gets
    // fewer outlines.
    const Colour darkest = over(as_shade(tint, deepest, plane.colour), plane.colour);
    const double change = 255.0 * std::max({plane.colour.r - darkest.r, plane.colour.g - darkest.g,
                                            plane.colour.b - darkest.b});
    constexpr double least_step = 7.0;
    const int n_levels = std::clamp(static_cast<int>(change / least_step), 4, most_levels);
    std::vector<Outline> outlines(static_cast<std::size_t>(n_levels) + 1);
    for (int level = 0; level <= n_levels; ++level) {
        for (std::size_t k = 0; k < n_spokes; ++k) {
            const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / n_spokes;
            const Eigen::Vector3d direction =
                std::cos(angle) * plane.along + std::sin(angle) * across;
            const Eigen::Vector3d point =
                shade.hub() + extent(shade, direction, deepest * level / n_levels) * direction;
            if (canvas.projection.perspective &&
                canvas.projection.depth(point) <= 2.0 * canvas.projection.near_depth)
                return;
            outlines[static_cast<std::size_t>(level)][k] = canvas.projection.place(point);
        }
    }
    double covered = 0.0;
    for (int level = 0; level < n_levels; ++level) {
        const Outline& outer = outlines[static_cast<std::size_t>(level)];
        const Outline& inner = outlines[static_cast<std::size_t>(level) + 1];
        // All fades over a point together give its darkness.
        const PaperInk wanted = as_shade(tint, deepest * (level + 1.0) / n_levels, plane.colour);
        // Few distinct opacities keep the file small; the next level compensates for the rounding.
        const double missing = 1.0 - (1.0 - wanted.alpha) / (1.0 - covered);
        const double alpha = std::round(250.0 * missing) / 250.0;
        covered = 1.0 - (1.0 - covered) * (1.0 - alpha);
        canvas.add(Fill{smooth_through(outer), ramp(outer, inner, {wanted.colour, alpha}), false});
    }
}

}  // namespace poinsot::vector
