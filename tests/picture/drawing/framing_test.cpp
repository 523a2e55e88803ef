// Framing: figures fill their panels, with cameras of single panels and in orthographic views,
// measured with a projection that is independent of the program's.
#include "drawing/stage/framing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "drawing/figures/panels/idle_keys.h"
#include "drawing/stage/panel.h"
#include "error/error.h"
#include "places.h"
#include "refusal.h"
#include "scene/files/load_scene.h"
#include "scene/parse_scene.h"
#include "scene/write_scene.h"
#include "scenes_by_hand.h"
#include "shapes/projection.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

View view_of(const PanelBox& box, const Camera& camera) {
    View view;
    view.x_px = box.x_px;
    view.y_px = box.y_px;
    view.width_px = box.width_px;
    view.height_px = box.height_px;
    view.camera = camera;
    return view;
}

// Least distance of the points from the sides of the box.
double least_margin(const View& view, const std::vector<Eigen::Vector3d>& points) {
    double least = 1e300;
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector2d px = project(view, point).px - Eigen::Vector2d(view.x_px, view.y_px);
        least = std::min({least, px.x(), px.y(), view.width_px - px.x(), view.height_px - px.y()});
    }
    return least;
}

TEST(Framing, ContainsAllPointsAndTouchesTheMargin) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 200; ++k) {
        std::vector<Eigen::Vector3d> points;
        for (int i = 0; i < 20; ++i) {
            points.emplace_back(normal(random), normal(random), 0.3 * normal(random));
        }
        const PanelBox box{37, 11, k % 2 == 0 ? 800 : 300, k % 3 == 0 ? 600 : 300};
        const Camera camera =
            framed(box, direction_of(7.0 * k, 20.0), Eigen::Vector3d::UnitZ(), 0.5, points, 25.0);
        // The outermost point is on the margin. Measured 2e-12.
        EXPECT_NEAR(least_margin(view_of(box, camera), points), 25.0, 1e-9);
    }
}

// The sight lines of each camera's corners, at two depths, are seen by the common one; moved
// nearer, it would not see all.
TEST(Framing, CommonViewSeesWhatEachCameraSeesAndNoMore) {
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    for (int round = 0; round < 50; ++round) {
        const PanelBox box{0, 0, round % 2 == 0 ? 800 : 300, 400};
        const bool orthographic = round % 3 == 0;
        const Eigen::Vector3d towards_eye = direction_of(11.0 * round, 25.0);
        std::vector<Camera> cameras;
        for (int k = 0; k < 4; ++k) {
            Camera& camera = cameras.emplace_back();
            camera.vertical_field_rad = 0.5;
            camera.target = {normal(random), normal(random), normal(random)};
            camera.eye = camera.target + (8.0 + normal(random)) * towards_eye;
            camera.orthographic = orthographic;
            camera.height_units = 2.0 + std::abs(normal(random));
        }
        const auto common = common_view(box, cameras);
        ASSERT_TRUE(common);
        std::vector<Eigen::Vector3d> corners;
        for (const Camera& camera : cameras) {
            const Eigen::Matrix3d axes = camera_axes(camera);
            for (const double depth : {3.0, 9.0})
                for (const double x : {-1.0, 1.0})
                    for (const double y : {-1.0, 1.0}) {
                        const double half =
                            orthographic ? 0.5 * camera.height_units : std::tan(0.25) * depth;
                        corners.push_back(
                            camera.eye +
                            axes * Eigen::Vector3d(x * half * box.width_px / box.height_px,
                                                   y * half, -depth));
                    }
        }
        // Measured 3e-12 px.
        EXPECT_NEAR(least_margin(view_of(box, *common), corners), 0.0, 1e-6) << round;
    }
    Camera one, other;
    EXPECT_EQ(common_view({0, 0, 100, 100}, std::vector<Camera>{one, one}), one);
    other.eye = -one.eye;
    EXPECT_FALSE(common_view({0, 0, 100, 100}, std::vector<Camera>{one, other}));
}

TEST(Framing, OnePointIsViewedFromADistance) {
    const std::vector<Eigen::Vector3d> points(3, Eigen::Vector3d(1.0, 2.0, 3.0));
    const Camera camera = framed({0, 0, 100, 100}, direction_of(10.0, 20.0),
                                 Eigen::Vector3d::UnitZ(), 0.5, points, 10.0);
    EXPECT_NEAR((camera.eye - camera.target).norm(), 1.0, 1e-12);
    EXPECT_LT((camera.target - points[0]).norm(), 1e-12);
}

TEST(Framing, PointsOfAnEllipsoidLieOnIt) {
    const Eigen::Matrix3d half_axes = Eigen::Vector3d(1.0, 0.5, 1e-6).asDiagonal();
    for (const Eigen::Vector3d& point : points_of_ellipsoid(half_axes)) {
        EXPECT_NEAR((half_axes.inverse() * point).norm(), 1.0, 1e-12);
    }
}

const std::string a_body = R"(
[body]
moments_kg_m2 = [1.0, 2.0, 2.9]
[start]
omega_rad_s = [1.4, 0.5, 1.6]
[film]
size = [640, 360]
duration_s = 8.0
)";

Scene scene_of(const std::string& more) { return parse_scene(a_body + more, "a.toml", {}); }

std::string refusal(const std::string& more) {
    return refusal_message([&] { const StagedScene staged(scene_of(more), 8.0); });
}

Eigen::Vector3d sight(const View& view) {
    return (view.camera.eye - view.camera.target).normalized();
}

const std::string three_panels = R"(
[camera]
azimuth_deg = 10.0
elevation_deg = 5.0
[grid]
columns = [1.0, 1.0, 1.0]
[[panels]]
kind = "body"
[panels.camera]
azimuth_deg = -70.0
elevation_deg = 35.0
[[panels]]
kind = "space"
column = 1
[[panels]]
kind = "momentum"
column = 2
)";

TEST(PanelCamera, AffectsItsPanelOnly) {
    const Drawing with = StagedScene(scene_of(three_panels), 8.0).stage.at(1.0);
    EXPECT_LT((sight(with.views[0]) - direction_of(-70.0, 35.0)).norm(), 1e-12);
    EXPECT_LT((sight(with.views[1]) - direction_of(10.0, 5.0)).norm(), 1e-12);
    // Without their own cameras, panels in body axes have their default direction.
    std::string without = three_panels;
    without.erase(without.find("[panels.camera]"),
                  without.find("[[panels]]\nkind = \"space\"") - without.find("[panels.camera]"));
    const Drawing usual = StagedScene(scene_of(without), 8.0).stage.at(1.0);
    EXPECT_GT((sight(usual.views[0]) - direction_of(-70.0, 35.0)).norm(), 0.1);
    EXPECT_LT((sight(usual.views[2]) - sight(with.views[2])).norm(), 1e-12);
}

TEST(PanelCamera, MissingKeysHaveThePanelsDefaults) {
    const auto body = [](const std::string& camera) {
        const std::string panel = "[[panels]]\nkind = \"body\"\n";
        return StagedScene(scene_of(panel + camera), 8.0).stage.at(1.0).views[0];
    };
    const Eigen::Vector3d usual = sight(body(""));
    const Eigen::Vector3d turned = sight(body("[panels.camera]\nazimuth_deg = 100.0\n"));
    EXPECT_NEAR(turned.z(), usual.z(), 1e-12);
    EXPECT_NEAR(std::atan2(turned.y(), turned.x()), 100.0 * std::numbers::pi / 180.0, 1e-12);
}

TEST(PanelCamera, KeyframesMoveThePanelThatTheyName) {
    const Scene scene = scene_of(three_panels +
                                 "[[keyframes]]\nat_s = 4.0\npanel = 2\nazimuth_deg = 120.0\n"
                                 "elevation_deg = 60.0\n"
                                 "[[keyframes]]\nat_s = 6.0\nazimuth_deg = 50.0\n");
    const StagedScene staged(scene, 8.0);
    const auto seen = [&](double film_s, std::size_t panel) {
        return sight(staged.stage.at(FilmTime{film_s, film_s}).views[panel]);
    };
    EXPECT_LT((seen(4.0, 2) - direction_of(120.0, 60.0)).norm(), 1e-12);
    EXPECT_LT((seen(8.0, 2) - direction_of(120.0, 60.0)).norm(), 1e-12);
    EXPECT_LT((seen(8.0, 0) - direction_of(-70.0, 35.0)).norm(), 1e-12);
    EXPECT_LT((seen(6.0, 1) - direction_of(50.0, 5.0)).norm(), 1e-12);
    EXPECT_GT((seen(2.0, 2) - seen(0.0, 2)).norm(), 0.05);
}

TEST(PanelCamera, IsPreservedByWriting) {
    const std::string keys = "[[keyframes]]\nat_s = 4.0\npanel = 0\nazimuth_deg = 120.0\n";
    const std::string once = to_toml(scene_of(three_panels + keys));
    EXPECT_EQ(to_toml(parse_scene(once, "b.toml", {})), once);
    EXPECT_NE(once.find("\n[panels.camera]\nazimuth_deg = -70"), std::string::npos) << once;
}

TEST(PanelCamera, KeysWithoutEffectAreRejected) {
    const std::string body = "[[panels]]\nkind = \"body\"\n";
    EXPECT_NE(refusal(body + "[panels.camera]\ndistance = 3.0\n")
                  .find("a.toml:12:1: panels[0].camera.distance changes nothing: panel \"body\" "
                        "fits all of its content into its frame"),
              std::string::npos)
        << refusal(body + "[panels.camera]\ndistance = 3.0\n");
    EXPECT_NE(refusal("[[panels]]\nkind = \"plot\"\n[panels.camera]\nazimuth_deg = 3.0\n")
                  .find("is flat and has no camera"),
              std::string::npos);
    EXPECT_NE(refusal(body + "[[keyframes]]\nat_s = 1\npanel = 0\nlook_at = \"foot\"\n")
                  .find("keyframes[0].look_at changes nothing"),
              std::string::npos);
    EXPECT_NE(refusal(body + "[[keyframes]]\nat_s = 1\npanel = 3\nazimuth_deg = 3\n")
                  .find("keyframes[0].panel is 3, but the scene has one panel"),
              std::string::npos);
    // A keyframe that moves no panel's camera.
    EXPECT_NE(refusal(body + "[[keyframes]]\nat_s = 1\nazimuth_deg = 3\n").find("keyframes[0]"),
              std::string::npos);
}

TEST(PanelCamera, IdleCameraKeysAreListed) {
    using Keys = std::vector<std::string>;
    const auto idle = [](const std::string& more) {
        Keys keys;
        for (const IdleKey& idle_key : idle_keys(scene_of(more)))
            if (idle_key.key.starts_with("camera.")) keys.push_back(idle_key.key);
        return keys;
    };
    const std::string camera = "[camera]\nazimuth_deg = 3.0\ndistance = 3.0\nfield_deg = 20.0\n";
    EXPECT_EQ(idle(camera), Keys{});
    EXPECT_EQ(idle(camera + "[[panels]]\nkind = \"body\"\n"),
              (Keys{"camera.azimuth_deg", "camera.distance"}));
    EXPECT_EQ(idle(camera + "[[panels]]\nkind = \"object\"\n"), Keys{"camera.distance"});
    EXPECT_EQ(idle(camera + "[[panels]]\nkind = \"plot\"\n"),
              (Keys{"camera.field_deg", "camera.azimuth_deg", "camera.distance"}));
}

// Equal lengths are equal at all depths, and parallel lines stay parallel.
TEST(Orthographic, LengthsDoNotDependOnDepth) {
    for (const char* kind : {"space", "body", "object", "momentum"}) {
        const Drawing drawing =
            StagedScene(scene_of("[camera]\nprojection = \"orthographic\"\n[[panels]]\nkind = \"" +
                                 std::string(kind) + "\"\n"),
                        8.0)
                .stage.at(1.0);
        const View& view = drawing.views[0];
        const auto length = [&view](const Eigen::Vector3d& at) {
            return Eigen::Vector2d(project(view, at + 0.5 * Eigen::Vector3d::UnitX()).px -
                                   project(view, at).px);
        };
        const Eigen::Vector3d near = sight(view), far = -sight(view);
        EXPECT_LT((length(near) - length(far)).norm(), 1e-9) << kind;
        EXPECT_GT(length(near).norm(), 5.0) << kind;
    }
}

// In an orthographic frame, the outermost points are on both margins of one direction.
TEST(Orthographic, FigureFillsItsFrame) {
    const StagedScene staged(scene_of("[camera]\nprojection = \"orthographic\"\n"
                                      "[[panels]]\nkind = \"object\"\n"),
                             8.0);
    Panel panel;
    panel.box = {0, 0, 640, 360};
    panel.orthographic = true;
    const std::vector<Eigen::Vector3d> points =
        points_of_ellipsoid(Eigen::Vector3d(1.0, 0.6, 0.4).asDiagonal().toDenseMatrix());
    const Margins margins{40.0, 20.0, 10.0, 30.0};
    View view;
    view.width_px = 640, view.height_px = 360;
    view.camera = projected(panel, framed(panel, direction_of(-40.0, 14.0),
                                          Eigen::Vector3d::UnitZ(), 0.5, points, margins));
    Eigen::AlignedBox2d seen;
    for (const Eigen::Vector3d& point : points) seen.extend(project(view, point).px);
    EXPECT_GE(seen.min().x(), 40.0 - 1e-9);
    EXPECT_LE(seen.max().x(), 620.0 + 1e-9);
    EXPECT_NEAR(seen.min().y(), 10.0, 1e-9);
    EXPECT_NEAR(seen.max().y(), 330.0, 1e-9);
    EXPECT_NEAR(seen.center().x(), 330.0, 1e-9);
}

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

// A roll turns the whole picture about its middle, counterclockwise, and nothing else: at 90° what
// was up is at the left.
TEST(Roll, TurnsThePictureCounterclockwise) {
    for (const std::string kind : {"space", "object"}) {
        const auto drawn = [&](double roll_deg) {
            const Scene scene = parse_scene(
                "[body]\nmoments_kg_m2 = [3.0, 2.0, 1.0]\n[start]\nomega_rad_s = [0.3, 1.0, 0.4]\n"
                "[film]\nsize = [400, 400]\n[camera]\ntarget = [0.0, 0.0, 0.0]\n"
                "distance = 8.0\nroll_deg = " +
                    fmt::format("{}", roll_deg) + "\n[[panels]]\nkind = \"" + kind + "\"\n",
                "a.toml");
            const Motion motion(problem_of(scene));
            const Stage stage(scene, theme_of(scene), motion,
                              {.width_px = 400,
                               .height_px = 400,
                               .first_time_s = 0.0,
                               .last_time_s = 10.0,
                               .fonts = installed_fonts()});
            return stage.at(2.0).views.front();
        };
        // Where the vertical points in the picture: to the right, and up.
        const auto vertical_of = [](const View& view) {
            const Eigen::Matrix3d axes = camera_axes(view.camera);
            return Eigen::Vector2d(axes.col(0).z(), axes.col(1).z());
        };
        const Eigen::Vector2d upright = vertical_of(drawn(0.0));
        EXPECT_NEAR(upright.x(), 0.0, 1e-15);
        EXPECT_GT(upright.y(), 0.5);
        for (const double roll_deg : {90.0, -90.0, 30.0}) {
            const View view = drawn(roll_deg);
            const double roll = roll_deg * std::numbers::pi / 180.0;
            const Eigen::Vector2d expected =
                upright.y() * Eigen::Vector2d(-std::sin(roll), std::cos(roll));
            EXPECT_LT((vertical_of(view) - expected).norm(), 1e-14) << kind << roll_deg;
            for (const Curve& curve : view.curves) EXPECT_FALSE(curve.placement.matrix().hasNaN());
        }
    }
}

TEST(Filling, FigureSpansFourFifthsOfItsPanel) {
    const std::vector<std::filesystem::path> files = supplied_scenes();
    ASSERT_GE(files.size(), 30u);
    for (const auto& file : files) {
        for (const auto& [width, height] :
             {std::pair{1920, 1080}, std::pair{640, 360}, std::pair{1004, 565}}) {
            Scene scene = load_scene(file, {});
            scene.film.width_px = width;
            scene.film.height_px = height;
            const double last_s = scene.film.start_s + scene.film.duration_s.value_or(10.0);
            const Motion motion(problem_of(scene));
            const Stage stage(scene, theme_of(scene), motion,
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
                // Matrices of three rows stand below `tensor`; in panels of 270 pixels and less,
                // names of the least legible size take their room.
                const bool is_cramped = width == 640 && scene.panels.size() > 1;
                const double least = is_cramped ? 0.74 : file.stem() == "tensor" ? 0.78 : 0.8;
                EXPECT_GE(spanned, least) << file.stem() << " " << width << " panel " << i;
            }
        }
    }
}

}  // namespace
}  // namespace poinsot
