// Cameras of single panels, and orthographic views.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "drawing/framing.h"
#include "drawing/panel.h"
#include "error/error.h"
#include "scene/files/load_scene.h"
#include "scene/write_scene.h"
#include "scenes_by_hand.h"
#include "shapes/projection.h"

namespace poinsot {
namespace {

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
    try {
        const StagedScene staged(scene_of(more), 8.0);
        return "";
    } catch (const InputError& error) {
        return error.what();
    }
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
    const auto idle = [](const std::string& more) { return idle_camera_keys(scene_of(more)); };
    using Keys = std::vector<std::string>;
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

}  // namespace
}  // namespace poinsot
