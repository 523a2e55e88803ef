// Small drawings and measurements shared by the tests of render/.
#pragma once

#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <numbers>

#include "render/renderer.h"

namespace poinsot::testing {

// One context and renderer for the whole test program: making them for each test costs more than
// the tests.
struct SharedRenderer {
    OffscreenContext context;
    Renderer renderer{context};
};

inline std::unique_ptr<SharedRenderer>& kept_renderer() {
    static std::unique_ptr<SharedRenderer> kept;
    return kept;
}
// A test that makes its own context closes the shared one first: when its context ends, none is
// current, and the next test makes a new shared one.
inline void close_shared_renderer() { kept_renderer().reset(); }
inline SharedRenderer& shared_renderer() {
    if (!kept_renderer()) {
        kept_renderer() = std::make_unique<SharedRenderer>();
        // Registered after the OpenGL library is loaded, so that the context ends before it.
        [[maybe_unused]] static const int registered = std::atexit(close_shared_renderer);
    }
    return *kept_renderer();
}
inline Renderer& renderer() { return shared_renderer().renderer; }
inline const OffscreenContext& context() { return shared_renderer().context; }

// A transparent picture with one orthographic view along -z: x right, y up, centred on the origin.
inline Drawing flat_drawing(int width_px, int height_px, double units_high) {
    Drawing drawing;
    drawing.width_px = width_px;
    drawing.height_px = height_px;
    drawing.background.alpha = 0.0;
    View view;
    view.width_px = width_px;
    view.height_px = height_px;
    view.background.alpha = 0.0;
    view.camera.eye = {0.0, 0.0, 10.0};
    view.camera.target = Eigen::Vector3d::Zero();
    view.camera.up = Eigen::Vector3d::UnitY();
    view.camera.orthographic = true;
    view.camera.height_units = units_high;
    drawing.views.push_back(view);
    return drawing;
}

// The ellipsoid on its plane with curves, arrows and a dot, as in the lecture.
inline Drawing lecture_drawing(int width_px, int height_px, const CurveGeometry& on_surface,
                               const CurveGeometry& on_plane) {
    Drawing drawing;
    drawing.width_px = width_px;
    drawing.height_px = height_px;
    View view;
    view.width_px = width_px;
    view.height_px = height_px;
    view.camera.eye = {3.2, -4.6, 1.7};
    Plane plane;
    plane.centre = {0.0, 0.0, -0.8};
    view.planes.push_back(plane);
    Ellipsoid ellipsoid;
    ellipsoid.half_axes = Eigen::Vector3d(1.0, 0.7, 0.8).asDiagonal();
    view.ellipsoids.push_back(ellipsoid);
    Curve polhode;
    polhode.geometry = &on_surface;
    polhode.colour = {0.05, 0.25, 0.65};
    polhode.on_surface = 0;
    view.curves.push_back(polhode);
    Curve herpolhode;
    herpolhode.geometry = &on_plane;
    herpolhode.colour = {0.75, 0.10, 0.15};
    herpolhode.on_plane = 0;
    view.curves.push_back(herpolhode);
    for (const Eigen::Vector3d& tip :
         {Eigen::Vector3d(0.0, 0.0, 1.4), Eigen::Vector3d(1.3, 0.2, 0.1)}) {
        Arrow arrow;
        arrow.tip = tip;
        arrow.colour = {0.2, 0.2, 0.25};
        arrow.shaft_px = 4.0;
        arrow.head_px = 16.0;
        arrow.head_length_px = 26.0;
        view.arrows.push_back(arrow);
    }
    Dot dot;
    dot.at = {0.0, 0.0, -0.8};
    dot.colour = {0.3, 0.3, 0.3};
    view.dots.push_back(dot);
    drawing.views.push_back(view);
    return drawing;
}

// A curve with equal steps of its parameter, 0 to 1; closed curves omit the last point.
inline CurveGeometry curve_of(std::uint64_t id, int n_points, bool closed,
                              const std::function<Eigen::Vector3d(double)>& point) {
    CurveGeometry geometry;
    geometry.id = id;
    geometry.closed = closed;
    for (int k = 0; k < n_points; ++k)
        geometry.points.push_back(
            point(static_cast<double>(k) / (closed ? n_points : n_points - 1)));
    return geometry;
}

inline CurveGeometry circle(std::uint64_t id, double radius, double z, int n_points = 200) {
    return curve_of(id, n_points, true, [=](double t) {
        const double angle = 2.0 * std::numbers::pi * t;
        return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z);
    });
}

inline double alpha_at(const Image& image, int x, int y) { return image.at(x, y).a / 255.0; }

// Sum of the coverage of all pixels.
inline double covered_px(const Image& image) {
    double sum = 0.0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) sum += alpha_at(image, x, y);
    return sum;
}

// Centroid of the coverage, in pixels.
inline Eigen::Vector2d middle_of(const Image& image) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double weight = 0.0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            sum += alpha_at(image, x, y) * Eigen::Vector2d(x + 0.5, y + 0.5);
            weight += alpha_at(image, x, y);
        }
    }
    return sum / weight;
}

// An opaque ellipsoid without lines.
inline Ellipsoid plain_ellipsoid(const Eigen::Matrix3d& half_axes) {
    Ellipsoid ellipsoid;
    ellipsoid.half_axes = half_axes;
    ellipsoid.opacity = 1.0;
    ellipsoid.section_px = 0.0;
    ellipsoid.ruling_px = 0.0;
    ellipsoid.casts_shadow = false;
    return ellipsoid;
}

inline std::size_t n_different(const Image& a, const Image& b) {
    std::size_t n = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) n += a.at(x, y) == b.at(x, y) ? 0 : 1;
    return n;
}

}  // namespace poinsot::testing
