// Pictures of single elements of a scene, drawn as by `still` but in this process, and a pinhole
// camera that is computed independently of the program's geometry.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "image/image.h"
#include "production/session/session.h"
#include "production/stills/picture.h"
#include "production/stills/prepared_still.h"
#include "scene/files/load_scene.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot::testing {

// The camera of a picture of 1920 × 1080 pixels, or of `scale` times as many per side.
struct Pinhole {
    double azimuth_deg = 0.0, elevation_deg = 0.0;
    Eigen::Vector3d target = Eigen::Vector3d::Zero();
    double distance = 5.0, field_deg = 28.0;
    double scale = 1.0;

    Eigen::Vector3d towards_eye() const {
        const double a = azimuth_deg * std::numbers::pi / 180.0;
        const double h = elevation_deg * std::numbers::pi / 180.0;
        return {std::cos(h) * std::cos(a), std::cos(h) * std::sin(a), std::sin(h)};
    }
    Eigen::Vector3d eye() const { return target + distance * towards_eye(); }
    // x to the right, y down, pixel centres at half-integers.
    Eigen::Vector2d pixel_of(const Eigen::Vector3d& point) const {
        const Eigen::Vector3d forward = -towards_eye();
        const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
        const Eigen::Vector3d down = forward.cross(right);
        const Eigen::Vector3d from_eye = point - eye();
        const double focal_px =
            540.0 * scale / std::tan(0.5 * field_deg * std::numbers::pi / 180.0);
        return scale * Eigen::Vector2d(960.0, 540.0) +
               focal_px / from_eye.dot(forward) *
                   Eigen::Vector2d(from_eye.dot(right), from_eye.dot(down));
    }
    std::vector<std::string> settings() const {
        return {fmt::format("film.size=[{:g}, {:g}]", 1920.0 * scale, 1080.0 * scale),
                fmt::format("camera.azimuth_deg={}", azimuth_deg),
                fmt::format("camera.elevation_deg={}", elevation_deg),
                fmt::format("camera.distance={}", distance),
                fmt::format("camera.field_deg={}", field_deg),
                fmt::format("camera.target=[{}, {}, {}]", target.x(), target.y(), target.z())};
    }
};

// Elements of a scene, such as "contact", "omega" in quotes, at an instant and with a transparent
// background. `plane` is "below" or "above".
inline Image seen_alone(LazyRenderer& renderer, const std::string& scene,
                        const std::string& elements, double time_s, const std::string& plane,
                        const Pinhole& camera) {
    std::vector<std::string> settings = camera.settings();
    settings.push_back("theme=\"transparent\"");
    settings.push_back("construction.plane=\"" + plane + "\"");
    settings.push_back("show=[" + elements + "]");
    settings.push_back("names=false");  // they would cover what is measured
    SessionRequest request{installed_fonts()};
    request.times_s = {time_s};
    Image image;
    draw_into(
        prepare_still(session_of(parse_scene(scene, "scene.toml", overrides_of(settings)), request),
                      {.time_s = time_s}),
        renderer, image);
    return image;
}

inline double alpha(const Rgba8& pixel) { return pixel.a / 255.0; }

// Bilinear interpolation between pixel centres; constant beyond the outermost.
template <typename Level>
double level_at(const Image& image, const Eigen::Vector2d& px, const Level& level) {
    const Eigen::Vector2d from = px - Eigen::Vector2d(0.5, 0.5);
    const int x = std::clamp(static_cast<int>(std::floor(from.x())), 0, image.width() - 2);
    const int y = std::clamp(static_cast<int>(std::floor(from.y())), 0, image.height() - 2);
    const double u = from.x() - x;
    const double v = from.y() - y;
    return (1.0 - v) * ((1.0 - u) * level(image.at(x, y)) + u * level(image.at(x + 1, y))) +
           v * ((1.0 - u) * level(image.at(x, y + 1)) + u * level(image.at(x + 1, y + 1)));
}

// The centroid of all that is drawn, which must have at least `least_px` pixels.
inline Eigen::Vector2d centroid(const Image& image, double least_px) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double weight = 0.0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const double covered = alpha(image.at(x, y));
            sum += covered * Eigen::Vector2d(x + 0.5, y + 0.5);
            weight += covered;
        }
    }
    EXPECT_GT(weight, least_px);
    return sum / weight;
}

}  // namespace poinsot::testing
