#include "vector/light.h"

#include <algorithm>
#include <cmath>

#include "numerics/srgb.h"

namespace poinsot::vector {

namespace {

using real = double;
#include "shaders/light.glsl"

double encoded_component(double light) { return srgb_from_linear(std::clamp(light, 0.0, 1.0)); }

double cube(double x) { return x * x * x; }

}  // namespace

Eigen::Vector3d linear(const Colour& c) {
    return {linear_from_srgb(c.r), linear_from_srgb(c.g), linear_from_srgb(c.b)};
}

Colour encoded(const Eigen::Vector3d& l) {
    return {encoded_component(l.x()), encoded_component(l.y()), encoded_component(l.z())};
}

namespace {

// The least opacity, at least `alpha`, of an ink that gives `wanted` over `behind`.
double least_opacity(double alpha, const Colour& wanted, const Colour& behind) {
    const auto raise = [&alpha](double is, double was) {
        if (is > was && was < 1.0) alpha = std::max(alpha, (is - was) / (1.0 - was));
        if (is < was && was > 0.0) alpha = std::max(alpha, (was - is) / was);
    };
    raise(wanted.r, behind.r);
    raise(wanted.g, behind.g);
    raise(wanted.b, behind.b);
    return std::min(alpha, 1.0);
}

PaperInk making(const Colour& colour, double opacity, const Colour& behind, double least_alpha) {
    if (opacity <= 0.0) return {colour, 0.0};
    const Colour wanted = vector::encoded(opacity * vector::linear(colour) +
                                          (1.0 - opacity) * vector::linear(behind));
    const double alpha = least_opacity(least_alpha, wanted, behind);
    if (alpha <= 0.0) return {colour, 0.0};
    return {colour_making(wanted, alpha, behind), alpha};
}

}  // namespace

PaperInk as_in_light(const Colour& colour, double opacity, const Colour& behind) {
    if (opacity >= 1.0) return {colour, 1.0};
    return making(colour, opacity, behind, opacity);
}

PaperInk as_shade(const Colour& colour, double opacity, const Colour& behind) {
    return making(colour, opacity, behind, 0.0);
}

Colour colour_making(const Colour& wanted, double alpha, const Colour& behind) {
    const auto component = [alpha](double is, double was) {
        return std::clamp((is - (1.0 - alpha) * was) / alpha, 0.0, 1.0);
    };
    return {component(wanted.r, behind.r), component(wanted.g, behind.g),
            component(wanted.b, behind.b)};
}

Colour over(const PaperInk& ink, const Colour& behind) {
    const double keep = 1.0 - ink.alpha;
    return {ink.alpha * ink.colour.r + keep * behind.r, ink.alpha * ink.colour.g + keep * behind.g,
            ink.alpha * ink.colour.b + keep * behind.b};
}

PaperInk ink_for(std::span<const ColourOver> places) {
    const auto of = [](const Colour& c) { return Eigen::Vector3d(c.r, c.g, c.b); };
    Eigen::Vector3d wanted = Eigen::Vector3d::Zero(), behind = Eigen::Vector3d::Zero();
    for (const ColourOver& place : places) {
        wanted += of(place.wanted);
        behind += of(place.behind);
    }
    wanted /= static_cast<double>(places.size());
    behind /= static_cast<double>(places.size());
    // The slope of `wanted` over `behind` is the share of the background that stays visible.
    double both = 0.0, square = 0.0;
    for (const ColourOver& place : places) {
        const Eigen::Vector3d apart = of(place.behind) - behind;
        both += apart.dot(of(place.wanted) - wanted);
        square += apart.squaredNorm();
    }
    constexpr double least_square = 1e-4;  // below this, the slope is undetermined
    const double keep = square > least_square ? std::clamp(both / square, 0.0, 1.0) : 0.5;
    const Colour mean{wanted.x(), wanted.y(), wanted.z()};
    const Colour under{behind.x(), behind.y(), behind.z()};
    const double alpha = least_opacity(1.0 - keep, mean, under);
    if (alpha <= 0.0) return {mean, 0.0};
    return {colour_making(mean, alpha, under), alpha};
}

Lights::Lights(const View& view)
    : towards(view.light.towards.normalized()),
      up(view.planes.empty() ? view.camera.up.normalized() : view.planes.front().normal),
      key(view.light.key),
      sky(view.light.sky) {}

Layer outer_surface(const Ellipsoid& ellipsoid, const Lights& lights, const SurfacePoint& point,
                    double lines) {
    const double facing = std::clamp(point.normal.dot(point.to_eye), 0.0, 1.0);
    const double limb = cube(1.0 - facing);
    const double to_key = point.normal.dot(lights.towards);
    const double up = 0.5 + 0.5 * point.normal.dot(lights.up);
    const double lit = ellipsoid_lit(lights.key, lights.sky, to_key, up);
    const double glint = std::max(to_key + facing, 0.0);
    const double per_halfway = 1.0 / std::max(2.0 + 2.0 * point.to_eye.dot(lights.towards), 1e-6);
    const double gloss = ellipsoid_gloss(glint * glint * per_halfway);
    const Eigen::Vector3d tone =
        (1.0 - lines) * linear(ellipsoid.colour) + lines * linear(ellipsoid.line_colour);
    const double white = ellipsoid_white(lights.key, lights.sky, gloss, lines, limb, up);
    double alpha = ellipsoid_outer_opacity(ellipsoid.opacity, limb);
    alpha += lines * (std::max(alpha, ellipsoid_outer_lines()) - alpha);
    return {tone * lit + Eigen::Vector3d::Constant(white), alpha * ellipsoid.presence};
}

Layer inner_surface(const Ellipsoid& ellipsoid, const Lights& lights, const SurfacePoint& point,
                    double lines) {
    const double limb = cube(1.0 - std::clamp(point.normal.dot(point.to_eye), 0.0, 1.0));
    const double up = 0.5 + 0.5 * point.normal.dot(lights.up);
    const double lit = ellipsoid_lit(lights.key, lights.sky, point.normal.dot(lights.towards), up);
    const Eigen::Vector3d tone =
        (1.0 - lines) * linear(ellipsoid.colour) + lines * linear(ellipsoid.line_colour);
    double alpha = ellipsoid_inner_opacity(ellipsoid.opacity, limb);
    alpha += lines * (std::max(alpha, ellipsoid_inner_lines()) - alpha);
    return {tone * ellipsoid_inner_lit(lit), alpha * ellipsoid.presence};
}

Colour contour_colour(const Colour& surface, const Colour& behind) {
    // WCAG 2.1, 1.4.11: a contrast of 3 for graphical objects.
    constexpr double least_contrast = 3.0, flare = 0.05;
    const Eigen::Vector3d weights(0.2126, 0.7152, 0.0722);
    const double ground = weights.dot(linear(behind)) + flare;
    const double middle = std::sqrt(flare * (1.0 + flare));
    const Eigen::Vector3d light = linear(surface);
    const double own = weights.dot(light) + flare;
    if (std::max(own / ground, ground / own) >= least_contrast) return surface;
    if (ground > middle) {
        const double wanted = ground / least_contrast - flare;
        return encoded(Eigen::Vector3d(std::max(wanted, 0.0) / (own - flare) * light));
    }
    const double wanted = least_contrast * ground - flare;
    const double white = (wanted - (own - flare)) / (1.0 - (own - flare));
    return encoded(Eigen::Vector3d(light + white * (Eigen::Vector3d::Ones() - light)));
}

ConeLines cone_lines() {
    return {cone_line_tone(), cone_rim_opacity(), cone_generator_opacity() * cone_generator_ink()};
}

Layer cone_surface(const Cone& cone, const Lights& lights, const SurfacePoint& point) {
    const double limb = cube(1.0 - std::abs(point.normal.dot(point.to_eye)));
    const double up = 0.5 + 0.5 * point.normal.dot(lights.up);
    const double lit = cone_lit(lights.key, lights.sky, point.normal.dot(lights.towards), up);
    return {linear(cone.colour) * lit, cone_opacity(cone.opacity, limb) * cone.presence};
}

Eigen::Vector3d arrow_surface(const Colour& colour, const Lights& lights,
                              const SurfacePoint& point) {
    const double up = 0.5 + 0.5 * point.normal.dot(lights.up);
    const double lit = arrow_lit(lights.key, lights.sky, point.normal.dot(lights.towards), up);
    const Eigen::Vector3d halfway = lights.towards + point.to_eye;
    const double glint = std::max(point.normal.dot(halfway) / std::max(halfway.norm(), 1e-6), 0.0);
    return linear(colour) * lit + Eigen::Vector3d::Constant(arrow_white(lights.key, glint));
}

Eigen::Vector3d mesh_surface(const Colour& colour, const Lights& lights,
                             const SurfacePoint& point) {
    const double up = 0.5 + 0.5 * point.normal.dot(lights.up);
    const double lit = mesh_lit(lights.key, lights.sky, point.normal.dot(lights.towards), up);
    const Eigen::Vector3d halfway = lights.towards + point.to_eye;
    const double glint = std::max(point.normal.dot(halfway) / std::max(halfway.norm(), 1e-6), 0.0);
    const double limb = cube(1.0 - std::max(point.normal.dot(point.to_eye), 0.0));
    return linear(colour) * lit + Eigen::Vector3d::Constant(mesh_gloss(lights.key, glint) +
                                                            mesh_rim(lights.sky, limb, up));
}

}  // namespace poinsot::vector
