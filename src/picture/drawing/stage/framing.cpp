#include "drawing/stage/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "shapes/projection.h"

namespace poinsot {

namespace {

Camera about_the_origin(const Eigen::Vector3d& towards_eye, const Eigen::Vector3d& up,
                        double vertical_field_rad) {
    Camera camera;
    camera.eye = towards_eye.normalized();
    camera.target = Eigen::Vector3d::Zero();
    camera.up = up;
    camera.vertical_field_rad = vertical_field_rad;
    return camera;
}

}  // namespace

std::optional<Camera> common_view(const PanelBox& box, std::span<const Camera> cameras) {
    if (cameras.empty()) return std::nullopt;
    const Camera& first = cameras.front();
    const Eigen::Matrix3d axes = camera_axes(first);
    const auto looks_alike = [&](const Camera& camera) {
        constexpr double rounding = 1e-9;
        return camera.orthographic == first.orthographic &&
               std::abs(camera.vertical_field_rad - first.vertical_field_rad) < rounding &&
               (camera_axes(camera) - axes).norm() < rounding;
    };
    if (!std::all_of(cameras.begin(), cameras.end(), looks_alike)) return std::nullopt;
    if (std::all_of(cameras.begin(), cameras.end(),
                    [&](const Camera& camera) { return camera == first; }))
        return first;

    // In the camera's axes, a perspective camera sees all that another one sees if that one's eye
    // is in its field: |x − X| ≤ slope (Z − z). A parallel one sees a rectangle.
    const double height_slope = std::tan(0.5 * first.vertical_field_rad);
    const Eigen::Vector2d slope =
        height_slope * Eigen::Vector2d(1.0 * box.width_px / box.height_px, 1.0);
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Eigen::Vector2d least = Eigen::Vector2d::Constant(infinite), most = -least;
    double target_depth = 0.0, eye_depth = -infinite;
    for (const Camera& camera : cameras) {
        const Eigen::Vector3d eye = axes.transpose() * camera.eye;
        const double reach =
            camera.orthographic ? 0.5 * camera.height_units / height_slope : eye.z();
        least = least.cwiseMin(eye.head<2>() - reach * slope);
        most = most.cwiseMax(eye.head<2>() + reach * slope);
        eye_depth = std::max(eye_depth, eye.z());
        target_depth +=
            (axes.transpose() * camera.target).z() / static_cast<double>(cameras.size());
    }
    const double reach = 0.5 * (most - least).cwiseQuotient(slope).maxCoeff();
    Camera common = first;
    if (first.orthographic)
        common.height_units = 2.0 * reach * height_slope;
    else
        eye_depth = reach;
    const Eigen::Vector2d centre = 0.5 * (least + most);
    common.eye = axes * Eigen::Vector3d(centre.x(), centre.y(), eye_depth);
    common.target = axes * Eigen::Vector3d(centre.x(), centre.y(), target_depth);
    return common;
}

Camera framed(const PanelBox& box, const Eigen::Vector3d& towards_eye, const Eigen::Vector3d& up,
              double vertical_field_rad, std::span<const Eigen::Vector3d> points,
              double margin_px) {
    return framed(box, towards_eye, up, vertical_field_rad, points, even_margins(box, margin_px));
}

Camera framed(const PanelBox& box, const Eigen::Vector3d& towards_eye, const Eigen::Vector3d& up,
              double vertical_field_rad, std::span<const Eigen::Vector3d> points,
              const Margins& margins) {
    Camera camera = about_the_origin(towards_eye, up, vertical_field_rad);
    const Eigen::Matrix3d axes = camera_axes(camera);

    // Slopes of the sight lines at the margins, to the left and down, to the right and up.
    const double per_px = 2.0 * std::tan(0.5 * vertical_field_rad) / box.height_px;
    const Eigen::Vector2d half(0.5 * box.width_px, 0.5 * box.height_px);
    const Eigen::Vector2d below =
        per_px * (half - Eigen::Vector2d(margins.left_px, margins.bottom_px));
    const Eigen::Vector2d above =
        per_px * (half - Eigen::Vector2d(margins.right_px, margins.top_px));

    // In the camera's axes a point (x, z) is within the sight lines of an eye (X, Z) if X − bZ ≤ x
    // − bz and X + aZ ≥ x + az. The nearest eye that sees all points is where the extreme lines of
    // the tighter direction meet.
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Eigen::Vector2d least = Eigen::Vector2d::Constant(infinite);
    Eigen::Vector2d most = -least;
    double middle_depth = 0.0;
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector3d seen = axes.transpose() * point;
        least = least.cwiseMin(seen.head<2>() - below * seen.z());
        most = most.cwiseMax(seen.head<2>() + above * seen.z());
        middle_depth += seen.z() / static_cast<double>(points.size());
    }
    if (points.empty()) least = most = Eigen::Vector2d::Zero();
    const Eigen::Vector2d needed = (most - least).cwiseQuotient(below + above);
    double eye_depth = needed.maxCoeff();
    if (!(eye_depth - middle_depth > 1e-9)) eye_depth = middle_depth + 1.0;

    // The middle between the two bounds at the eye's depth.
    const Eigen::Vector2d centre = 0.5 * (least + most + (below - above) * eye_depth);
    camera.eye = axes * Eigen::Vector3d(centre.x(), centre.y(), eye_depth);
    camera.target = axes * Eigen::Vector3d(centre.x(), centre.y(), middle_depth);
    return camera;
}

Margins even_margins(const PanelBox& box, double margin_px) {
    const double margin = std::min(margin_px, std::min(box.width_px, box.height_px) / 3.0);
    return {margin, margin, margin, margin};
}

namespace {

// With parallel lines of sight nothing depends on the eye's depth: the frame is the bounding
// rectangle of the points.
Camera framed_flat(const PanelBox& box, const Eigen::Vector3d& towards_eye,
                   const Eigen::Vector3d& up, double vertical_field_rad,
                   std::span<const Eigen::Vector3d> points, const Margins& margins) {
    Camera camera = about_the_origin(towards_eye, up, vertical_field_rad);
    const Eigen::Matrix3d axes = camera_axes(camera);
    Eigen::AlignedBox3d seen;
    for (const Eigen::Vector3d& point : points) seen.extend(axes.transpose() * point);
    if (points.empty()) seen.extend(Eigen::Vector3d::Zero());

    const Eigen::Vector2d room(box.width_px - margins.left_px - margins.right_px,
                               box.height_px - margins.top_px - margins.bottom_px);
    double units_per_px = seen.sizes().head<2>().cwiseQuotient(room).maxCoeff();
    if (!(units_per_px > 1e-9)) units_per_px = 1.0 / box.height_px;
    const Eigen::Vector2d aside(0.5 * (margins.left_px - margins.right_px),
                                0.5 * (margins.bottom_px - margins.top_px));
    Eigen::Vector3d target = seen.center();
    target.head<2>() -= units_per_px * aside;
    camera.target = axes * target;
    camera.eye = camera.target + 0.5 * units_per_px * box.height_px /
                                     std::tan(0.5 * vertical_field_rad) * towards_eye.normalized();
    return camera;
}

}  // namespace

Camera framed(const Panel& panel, const Eigen::Vector3d& towards_eye, const Eigen::Vector3d& up,
              double vertical_field_rad, std::span<const Eigen::Vector3d> points,
              const Margins& margins) {
    return panel.orthographic
               ? framed_flat(panel.box, towards_eye, up, vertical_field_rad, points, margins)
               : framed(panel.box, towards_eye, up, vertical_field_rad, points, margins);
}

void aim_around(Panel& panel, std::vector<Eigen::Vector3d> points, double margin_px) {
    aim_around(panel, std::move(points), even_margins(panel.box, margin_px));
}

void aim_around(Panel& panel, std::vector<Eigen::Vector3d> points, const Margins& margins) {
    const auto camera_at = [&panel, points = std::move(points), margins](double film_s) {
        const CameraPose pose = timeline_of(panel).camera_at(film_s);
        return framed(panel, direction_of(pose.azimuth_deg, pose.elevation_deg), up_of(pose),
                      pose.field_deg * std::numbers::pi / 180.0, points, margins);
    };
    aim(panel, camera_at(0.0));
    if (timeline_of(panel).camera_moves())
        panel.camera_at = [&panel, camera_at](double film_s) {
            return projected(panel, camera_at(film_s));
        };
}

std::vector<Eigen::Vector3d> points_of_ellipsoid(const Eigen::Matrix3d& half_axes) {
    std::vector<Eigen::Vector3d> points;
    constexpr int n_around = 24;
    constexpr int n_up = 12;
    for (int i = 0; i <= n_up; ++i) {
        const double latitude = std::numbers::pi * (static_cast<double>(i) / n_up - 0.5);
        for (int k = 0; k < n_around; ++k) {
            const double longitude = 2.0 * std::numbers::pi * k / n_around;
            points.emplace_back(half_axes *
                                Eigen::Vector3d(std::cos(latitude) * std::cos(longitude),
                                                std::cos(latitude) * std::sin(longitude),
                                                std::sin(latitude)));
        }
    }
    return points;
}

std::vector<Eigen::Vector3d> outermost(std::span<const Eigen::Vector3d> points) {
    std::vector<Eigen::Vector3d> found;
    if (points.empty()) return found;
    for (const Eigen::Vector3d& direction : points_of_ellipsoid(Eigen::Matrix3d::Identity())) {
        std::size_t farthest_at = 0;
        double reach = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double along = points[i].dot(direction);
            if (along <= reach) continue;
            reach = along;
            farthest_at = i;
        }
        const Eigen::Vector3d& farthest = points[farthest_at];
        if (std::find(found.begin(), found.end(), farthest) == found.end())
            found.push_back(farthest);
    }
    return found;
}

Eigen::Vector3d direction_of(double azimuth_deg, double elevation_deg) {
    const double azimuth = azimuth_deg * std::numbers::pi / 180.0;
    const double elevation = elevation_deg * std::numbers::pi / 180.0;
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
            std::sin(elevation)};
}

Eigen::Vector3d up_of(const CameraPose& pose) {
    const Eigen::Vector3d up = direction_of(pose.azimuth_deg, pose.elevation_deg + 90.0);
    if (pose.roll_deg != 0.0) {
        const double roll = pose.roll_deg * std::numbers::pi / 180.0;
        const Eigen::Vector3d right = up.cross(direction_of(pose.azimuth_deg, pose.elevation_deg));
        return std::cos(roll) * up + std::sin(roll) * right;
    }
    // Both give the same camera; near the vertical z would lose digits.
    return std::abs(pose.elevation_deg) < 89.0 ? Eigen::Vector3d(Eigen::Vector3d::UnitZ()) : up;
}

}  // namespace poinsot
