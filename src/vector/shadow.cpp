// The soft shadow of an ellipsoid on a plane: the same light as in render/shadow_web.h, drawn as
// outlines of equal darkness, one within the other.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "vector/canvas.h"

namespace poinsot::vector {

namespace {

constexpr int n_levels = 16, n_spokes = 14;
constexpr double unseen = 1.0 / 256.0;

double smoothstep(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// What an ellipsoid takes from a plane's light.
class Shade {
 public:
    Shade(const Plane& plane, const SphereSight& caster, double presence, const Lights& lights)
        : plane_(plane), caster_(caster), presence_(presence), lights_(lights) {
        const double height = plane.normal.dot(caster.centre - plane.centre);
        const Eigen::Vector3d up = (height < 0.0 ? -1.0 : 1.0) * plane.normal;
        const Eigen::Vector3d lean = caster.axes.transpose() * up;
        const Eigen::Vector3d lowest =
            caster.centre - caster.axes * lean / std::max(lean.norm(), 1e-12);
        hub_ = lowest - plane.normal.dot(lowest - plane.centre) * plane.normal;
        // The lamp stands higher than the key light.
        constexpr double raised = 0.8;
        const Eigen::Vector3d towards =
            (lights.towards + (raised + std::max(0.0, -lights.towards.dot(up))) * up).normalized();
        normal_u_ = lean.normalized();
        lamp_u_ = (caster.to_u * towards).normalized();
        reach_ = 3.0 * caster.axes.colwise().norm().maxCoeff() + std::abs(height);
    }

    // Share of the light that is taken at a point of the plane, times the plane's opacity there.
    double darkness(const Eigen::Vector3d& point) const {
        constexpr double lamp = 0.33;  // sine of half the angle that the key light fills
        constexpr double far_sky = 0.07;
        const Eigen::Vector3d u = caster_.u(point);
        const double nearness = std::min(1.0 / u.norm(), 1.0);
        const Eigen::Vector3d towards = -nearness * u;
        const double hidden = std::max(normal_u_.dot(towards), 0.0) * nearness * nearness;
        const double sky_taken = std::max(hidden - far_sky, 0.0) / (1.0 - far_sky);
        const double towards_lamp = lamp_u_.dot(towards);
        double beside_lamp = std::sqrt(std::max(1.0 - towards_lamp * towards_lamp, 0.0));
        if (towards_lamp < 0.0) beside_lamp = 2.0 - beside_lamp;
        const double cosine = std::sqrt(1.0 - nearness * nearness);
        const double overlap = nearness * towards_lamp - cosine * beside_lamp;
        const double largest = std::min(nearness / lamp, 1.0);
        const double key_taken = 0.75 * smoothstep(-lamp, lamp, overlap) * largest * largest;
        const double taken = (lights_.key * key_taken + lights_.sky * sky_taken) /
                             std::max(lights_.key + lights_.sky, 1e-6);
        return presence_ * taken * plane_opacity(plane_, (point - plane_.centre).norm()) - unseen;
    }

    // How far along a direction from the hub it is at least so dark: found from outside inwards.
    double extent(const Eigen::Vector3d& direction, double level) const {
        constexpr int n_steps = 48;
        double light = reach_, dark = 0.0;
        for (int k = n_steps; k-- > 0;) {
            const double r = reach_ * k / n_steps;
            if (darkness(hub_ + r * direction) >= level) {
                dark = r;
                break;
            }
            light = r;
        }
        if (light <= 0.0) return 0.0;
        for (int k = 0; k < 24; ++k) {
            const double middle = 0.5 * (dark + light);
            (darkness(hub_ + middle * direction) >= level ? dark : light) = middle;
        }
        return dark;
    }

    const Eigen::Vector3d& hub() const { return hub_; }

 private:
    const Plane& plane_;
    const SphereSight& caster_;
    double presence_;
    const Lights& lights_;
    Eigen::Vector3d hub_, normal_u_, lamp_u_;
    double reach_ = 1.0;
};

// A smooth closed path through places on paper.
Path smooth_through(const std::array<Eigen::Vector2d, n_spokes>& places) {
    const auto at = [&](int k) -> const Eigen::Vector2d& {
        return places[static_cast<std::size_t>((k + n_spokes) % n_spokes)];
    };
    Path path;
    path.move(at(0));
    for (int k = 0; k < n_spokes; ++k)
        path.cubic(at(k) + (at(k + 1) - at(k - 1)) / 6.0, at(k + 1) - (at(k + 2) - at(k)) / 6.0,
                   at(k + 1));
    path.close();
    return path;
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
        const Shade shade(plane, canvas.occluders.spheres()[k], canvas.view.ellipsoids[k].presence,
                          canvas.lights);
        const double darkness = std::max(shade.darkness(point), 0.0);
        light = darkness * tint + (1.0 - darkness) * light;
    }
    return encoded(light);
}

void draw_shadow(const Canvas& canvas, const Plane& plane, std::size_t caster) {
    const Ellipsoid& ellipsoid = canvas.view.ellipsoids[caster];
    if (canvas.shading == Shading::none || !casts(ellipsoid)) return;
    const Shade shade(plane, canvas.occluders.spheres()[caster], ellipsoid.presence, canvas.lights);
    const double deepest = shade.darkness(shade.hub());
    if (deepest <= 0.0) return;
    const Eigen::Vector3d across = plane.normal.cross(plane.along);
    // A deep shade of the plane's own colour is calmer than black.
    const Colour tint = encoded(0.06 * linear(plane.grid_colour));
    double covered = 0.0;
    for (int level = 0; level < n_levels; ++level) {
        std::array<Eigen::Vector2d, n_spokes> places;
        for (std::size_t k = 0; k < n_spokes; ++k) {
            const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / n_spokes;
            const Eigen::Vector3d direction =
                std::cos(angle) * plane.along + std::sin(angle) * across;
            const Eigen::Vector3d point =
                shade.hub() + shade.extent(direction, deepest * level / n_levels) * direction;
            if (canvas.sight.perspective &&
                canvas.sight.depth(point) <= 2.0 * canvas.sight.near_depth)
                return;
            places[k] = canvas.sight.paper(point);
        }
        // All outlines about a place together are as dark as it is.
        const double wanted =
            as_in_light(tint, deepest * (level + 0.5) / n_levels, plane.colour).alpha;
        const double alpha = 1.0 - (1.0 - wanted) / (1.0 - covered);
        covered = wanted;
        const Colour dark =
            as_in_light(tint, deepest * (level + 0.5) / n_levels, plane.colour).colour;
        canvas.add(Fill{smooth_through(places), Ink{dark, alpha}, false, 0.0});
    }
}

}  // namespace poinsot::vector
