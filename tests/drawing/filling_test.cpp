// Figures fill their panels: everything drawn, including arrows with their labels and the plane's
// rim, measured with a projection that is independent of the program's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <utility>
#include <vector>

#include "places.h"
#include "scene/files/load_scene.h"
#include "scenes_by_hand.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

// The bounding box of the projected points within the panel.
class Extent {
 public:
    explicit Extent(const View& view) : view_(view) {
        forward_ = (view.camera.target - view.camera.eye).normalized();
        right_ = forward_.cross(view.camera.up).normalized();
        up_ = right_.cross(forward_);
    }

    // Pixels from the view's upper left corner, y down.
    Eigen::Vector2d seen_at(const Eigen::Vector3d& point) const {
        const Camera& camera = view_.camera;
        const Eigen::Vector3d ray = point - camera.eye;
        const double height = camera.orthographic ? camera.height_units
                                                  : 2.0 * ray.dot(forward_) *
                                                        std::tan(0.5 * camera.vertical_field_rad);
        const double px = view_.height_px / height;
        return {0.5 * view_.width_px + px * ray.dot(right_),
                0.5 * view_.height_px - px * ray.dot(up_)};
    }
    void see(const Eigen::Vector3d& point) {
        if ((point - view_.camera.eye).dot(forward_) > 0.0) see_px(seen_at(point));
    }
    void see_px(const Eigen::Vector2d& px) {
        box_.extend(Eigen::Vector2d(std::clamp(px.x() / view_.width_px, 0.0, 1.0),
                                    std::clamp(px.y() / view_.height_px, 0.0, 1.0)));
    }
    void see_circle(const Eigen::Vector3d& centre, const Eigen::Vector3d& a,
                    const Eigen::Vector3d& b) {
        constexpr int n = 36;
        for (int k = 0; k < n; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / n;
            see(centre + std::cos(angle) * a + std::sin(angle) * b);
        }
    }

    void see_all() {
        for (const Curve& curve : view_.curves) {
            const auto n = static_cast<double>(curve.geometry->points.size());
            for (double k = std::max(0.0, std::ceil(curve.first));
                 k <= std::min(n - 1.0, curve.last); ++k)
                if (curve.opacity > 0.0)
                    see(curve.placement * curve.geometry->points[static_cast<std::size_t>(k)]);
        }
        for (const Arrow& arrow : view_.arrows) {
            see(arrow.tail);
            see(arrow.tip);
        }
        for (const Dot& dot : view_.dots) see(dot.at);
        for (const Ellipsoid& ellipsoid : view_.ellipsoids)
            for (int k = 0; k <= 24; ++k) {
                const double polar = std::numbers::pi * k / 24.0;
                const Eigen::Matrix3d& axes = ellipsoid.half_axes;
                see_circle(ellipsoid.centre + std::cos(polar) * axes.col(2),
                           std::sin(polar) * axes.col(0), std::sin(polar) * axes.col(1));
            }
        for (const Plane& plane : view_.planes) {
            const double seen = plane.radius;
            see_circle(plane.centre, seen * plane.along, seen * plane.normal.cross(plane.along));
        }
        for (const Cone& cone : view_.cones) {
            const double radius = cone.length * std::tan(cone.half_angle_rad);
            const Eigen::Vector3d across = cone.axis.unitOrthogonal();
            see_circle(cone.apex + cone.length * cone.axis, radius * across,
                       radius * cone.axis.cross(across));
        }
        for (const Mesh& mesh : view_.meshes)
            // One corner of each triangle; neighbours have the others.
            for (std::size_t k = 0; k < mesh.geometry->positions.size(); k += 3)
                see(mesh.placement * mesh.geometry->positions[k].cast<double>());
    }
    // The labels at the tips of arrows.
    void see_names() {
        for (const Label& label : view_.labels) {
            const Eigen::Vector2d corner =
                label.top_left_px - Eigen::Vector2d(view_.x_px, view_.y_px);
            const Eigen::Vector2d size(label.mask->width_px(), label.mask->height_px());
            const Eigen::AlignedBox2d box(corner, corner + size);
            const bool is_name =
                std::any_of(view_.arrows.begin(), view_.arrows.end(), [&](const Arrow& arrow) {
                    return box.exteriorDistance(seen_at(arrow.tip)) < size.y();
                });
            if (!is_name || !(label.opacity > 0.0)) continue;
            see_px(box.min());
            see_px(box.max());
        }
    }
    const Eigen::AlignedBox2d& box() const { return box_; }

 private:
    const View& view_;
    Eigen::Vector3d forward_, right_, up_;
    Eigen::AlignedBox2d box_;
};

bool is_chart(const PanelSpec& panel) { return panel.kind == "plot" || panel.kind == "potential"; }

TEST(Filling, FigureSpansFourFifthsOfItsPanel) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() / "scenes"))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    ASSERT_GE(files.size(), 30u);
    for (const auto& file : files) {
        for (const auto& [width, height] :
             {std::pair{1920, 1080}, std::pair{640, 360}, std::pair{1004, 565}}) {
            Scene scene = load_scene(file, {});
            scene.film.width_px = width;
            scene.film.height_px = height;
            const double last_s = scene.film.start_s + scene.film.duration_s.value_or(10.0);
            const Motion motion(problem_of(scene));
            const Stage stage(scene, motion,
                              {.width_px = width,
                               .height_px = height,
                               .first_time_s = scene.film.start_s,
                               .last_time_s = last_s,
                               .fonts = installed_fonts()});
            std::vector<Eigen::AlignedBox2d> boxes;
            constexpr int n_instants = 24;
            for (int k = 0; k <= n_instants; ++k) {
                const Drawing drawing =
                    stage.at(scene.film.start_s + (last_s - scene.film.start_s) * k / n_instants);
                boxes.resize(drawing.views.size());
                for (std::size_t i = 0; i < drawing.views.size(); ++i) {
                    Extent extent(drawing.views[i]);
                    extent.see_all();
                    extent.see_names();
                    boxes[i].extend(extent.box());
                }
            }
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                // The last view is that of the overlays.
                if (boxes[i].isEmpty() || (i < scene.panels.size() && is_chart(scene.panels[i])))
                    continue;
                const double spanned = boxes[i].sizes().maxCoeff();
                EXPECT_GE(spanned, 0.8) << file.stem() << " " << width << " panel " << i;
            }
        }
    }
}

}  // namespace
}  // namespace poinsot
