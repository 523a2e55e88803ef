#include "render/shadow_web.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace poinsot {
namespace {

constexpr int n_rings = ShadowWeb::n_rings;
constexpr int n_spokes = ShadowWeb::n_spokes;

// Taken from everywhere, so that the web's rim is not seen: 0.4 levels of white.
constexpr double unseen = 1.0 / 256.0;

double smoothstep(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// The part of a plane that an ellipsoid shades.
struct Shade {
    Shade(const Plane& on, const Quadric& caster, const Light& light);

    // Share of the light that is taken at a point of the plane, times the plane's opacity there.
    double darkness(const Eigen::Vector3d& point) const;
    // How far along a direction in the plane, from the hub, the darkness can be seen.
    double reach(const Eigen::Vector3d& direction) const;

    const Plane& plane;
    double presence = 1.0;        // of the ellipsoid
    Eigen::Matrix3d to_u;         // u = to_u (X - centre), where the ellipsoid is the unit sphere
    Eigen::Vector3d centre;       // of the ellipsoid
    Eigen::Vector3d hub;          // the point of the plane nearest to it
    Eigen::Vector3d middle;       // of a circle in the plane beyond which nothing is seen
    double radius = 0.0;          // of the circle
    Eigen::Vector3d normal_u;     // of the plane, towards the ellipsoid, in the sphere's axes, unit
    Eigen::Vector3d lamp_u;       // towards the middle of the lamp, likewise
    double key = 0.0, sky = 0.0;  // strengths
};

Shade::Shade(const Plane& on, const Quadric& caster, const Light& light)
    : plane(on),
      presence(caster.presence),
      to_u(caster.to_u),
      centre(caster.centre),
      key(light.key),
      sky(light.sky) {
    const double height = plane.normal.dot(centre - plane.centre);
    const Eigen::Vector3d up = (height < 0.0 ? -1.0 : 1.0) * plane.normal;
    const Eigen::Vector3d lean = caster.axes.transpose() * up;
    const Eigen::Vector3d lowest = centre - caster.axes * lean / std::max(lean.norm(), 1e-12);
    const auto foot = [&](const Eigen::Vector3d& x) {
        return (x - plane.normal.dot(x - plane.centre) * plane.normal).eval();
    };
    hub = foot(lowest);
    // The lamp stands higher than the key light: a shadow near the touch is calmer than a long one.
    constexpr double raised = 0.8;
    const Eigen::Vector3d towards_key = light.towards.normalized();
    const Eigen::Vector3d towards =
        (towards_key + (raised + std::max(0.0, -towards_key.dot(up))) * up).normalized();
    const Eigen::Vector3d lee =
        foot(centre - towards * (std::abs(height) / std::max(towards.dot(up), 0.3)));
    // Beyond two of its radii a sphere on the plane takes no more than a level.
    middle = 0.5 * (foot(centre) + lee);
    radius = std::max(2.0 * caster.axes.colwise().norm().maxCoeff(), 1.2 * (middle - hub).norm());
    normal_u = lean.normalized();
    lamp_u = (to_u * towards).normalized();
}

double Shade::darkness(const Eigen::Vector3d& point) const {
    constexpr double lamp = 0.33;  // sine of half the angle that the key light fills
    constexpr double far_sky = 0.07;
    const Eigen::Vector3d u = to_u * (point - centre);
    const double nearness = std::min(1.0 / u.norm(), 1.0);
    const Eigen::Vector3d towards = -nearness * u;
    // Cosine-weighted share of the sky behind a sphere, brought to zero a few radii away.
    const double hidden = std::max(normal_u.dot(towards), 0.0) * nearness * nearness;
    const double sky_taken = std::max(hidden - far_sky, 0.0) / (1.0 - far_sky);
    // Overlap of the lamp's disc with the sphere's: by the sine of the sphere's angular radius less
    // the angle to the lamp, continued past a right angle.
    const double towards_lamp = lamp_u.dot(towards);
    double beside_lamp = std::sqrt(std::max(1.0 - towards_lamp * towards_lamp, 0.0));
    if (towards_lamp < 0.0) beside_lamp = 2.0 - beside_lamp;
    const double cosine = std::sqrt(1.0 - nearness * nearness);
    const double overlap = nearness * towards_lamp - cosine * beside_lamp;
    const double largest = std::min(nearness / lamp, 1.0);
    const double key_taken = 0.75 * smoothstep(-lamp, lamp, overlap) * largest * largest;
    const double taken = (key * key_taken + sky * sky_taken) / std::max(key + sky, 1e-6);

    const double r = (point - plane.centre).norm() / plane.radius;
    return std::max(
        presence * taken * plane.opacity * (1.0 - smoothstep(plane.fade_from, 1.0, r)) - unseen,
        0.0);
}

double Shade::reach(const Eigen::Vector3d& direction) const {
    // To the circle at most.
    const Eigen::Vector3d off = middle - hub;
    const double inward = direction.dot(off);
    const double beside_square = off.squaredNorm() - inward * inward;
    double light = inward + std::sqrt(std::max(radius * radius - beside_square, 0.0));
    if (light <= 0.0) return 0.0;
    // Steps inwards to the first place that is dark, then halves the last step.
    constexpr int n_steps = 16, n_halvings = 5;
    const double step = light / n_steps;
    while (light > 0.0 && darkness(hub + (light - step) * direction) <= 0.0) light -= step;
    double dark = std::max(light - step, 0.0);
    for (int k = 0; k < n_halvings; ++k) {
        const double between = 0.5 * (dark + light);
        (darkness(hub + between * direction) > 0.0 ? dark : light) = between;
    }
    return std::max(light, 0.0);
}

}  // namespace

ShadowWeb shadow_web(const Plane& plane, const Quadric& caster, const Light& light,
                     const Projection& projection) {
    const Shade shade(plane, caster, light);
    const Eigen::Vector3d across = plane.normal.cross(plane.along);
    std::array<Eigen::Vector3d, n_spokes> spokes;
    bool any = false;
    for (int k = 0; k < n_spokes; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / n_spokes;
        const Eigen::Vector3d direction = std::cos(angle) * plane.along + std::sin(angle) * across;
        const double reach = shade.reach(direction);
        any = any || reach > 0.0;
        spokes[static_cast<std::size_t>(k)] = reach * direction;
    }
    ShadowWeb web;
    if (!any) return web;
    web.corners.reserve(std::size_t{n_rings + 1} * n_spokes);
    for (int ring = 0; ring <= n_rings; ++ring) {
        const double share = static_cast<double>(ring) / n_rings;
        for (const Eigen::Vector3d& spoke : spokes) {
            const Eigen::Vector3d point = shade.hub + share * share * spoke;
            const Eigen::Vector3d from_eye = point - projection.eye;
            const double depth = projection.perspective ? projection.depth(point) : 1.0;
            const double x = projection.centre_px.x() * depth +
                             projection.focal_px * projection.right.dot(from_eye);
            const double y = projection.centre_px.y() * depth +
                             projection.focal_px * projection.down.dot(from_eye);
            // It ends at nothing, whatever the search for its rim has left.
            const double darkness = ring == n_rings ? 0.0 : shade.darkness(point);
            web.corners.push_back(Eigen::Vector4d(x, y, depth, darkness).cast<float>());
        }
    }
    return web;
}

void ShadowWeb::mark(const Projection& projection, TileMask& marks) const {
    if (corners.empty()) return;
    const auto pixel = [](const Eigen::Vector4f& corner) {
        return (corner.head<2>() / corner.z()).cast<double>().eval();
    };
    const auto at = [&](int ring, int spoke) -> const Eigen::Vector4f& {
        const int corner = ring * n_spokes + spoke % n_spokes;
        return corners[static_cast<std::size_t>(corner)];
    };
    for (int spoke = 0; spoke < n_spokes; ++spoke) {
        if (projection.perspective && std::min(at(0, 0).z(), at(n_rings, spoke).z()) <=
                                          static_cast<float>(projection.near_depth)) {
            marks.mark(projection.box);
            return;
        }
    }
    for (int spoke = 0; spoke < n_spokes; ++spoke) {
        PixelPolygon sector;
        sector.add(pixel(at(0, 0)));
        sector.add(pixel(at(n_rings, spoke)));
        sector.add(pixel(at(n_rings, spoke + 1)));
        marks.mark(sector, projection.box);
    }
}

}  // namespace poinsot
