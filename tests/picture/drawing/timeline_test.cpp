// The film's timeline: moving cameras, fades, trails and direction marks.
#include "drawing/stage/timeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "drawing/stage/panel.h"
#include "scene/camera_views.h"
#include "scene/scene_error.h"
#include "scenes_by_hand.h"
#include "shapes/projection.h"

namespace poinsot::timeline_tests {

namespace {

const Eigen::Vector3d moments(1.0, 2.0, 2.9);
const Eigen::Vector3d spin(1.5, 0.3, 0.75);
constexpr double period_s = 9.27014978;  // of this polhode, as printed by `check`

Scene rolling_scene(std::vector<std::string> show = {}) {
    Scene scene = free_scene(moments, spin, "space");
    scene.show = std::move(show);
    return scene;
}

KeyframeSpec key_at(double at_s, double azimuth_deg, double distance) {
    KeyframeSpec key;
    key.at_s = at_s;
    key.azimuth_deg = azimuth_deg;
    key.distance = distance;
    key.easing = "linear";
    return key;
}

FadeSpec fade_at(double at_s, const std::string& name, double opacity = 1.0) {
    FadeSpec fade;
    fade.at_s = at_s;
    fade.elements = {name};
    fade.opacity = opacity;
    fade.easing = "linear";
    return fade;
}

View view_at(const StagedScene& staged, double film_s) {
    return staged.stage.at(FilmTime{film_s, film_s}).views.at(0);
}

TEST(Timeline, CameraPassesItsKeysAndIsStillOutsideThem) {
    Scene scene = rolling_scene();
    scene.keyframes = {key_at(2.0, 10.0, 4.0), key_at(4.0, 30.0, 9.0)};
    const Timeline timeline(scene, Eigen::Vector3d(0.0, 0.0, -0.7));
    EXPECT_EQ(timeline.camera_at(0.0).azimuth_deg, scene.camera.azimuth_deg);
    EXPECT_EQ(timeline.camera_at(2.0).azimuth_deg, 10.0);
    EXPECT_EQ(timeline.camera_at(3.0).azimuth_deg, 20.0);
    EXPECT_EQ(timeline.camera_at(99.0).azimuth_deg, 30.0);
    // Distances have a constant ratio per time: half-way from 4 to 9 is 6.
    EXPECT_NEAR(timeline.camera_at(3.0).distance, 6.0, 1e-14);
    // Values without keys are exactly the given numbers.
    EXPECT_EQ(timeline.camera_at(3.0).elevation_deg, scene.camera.elevation_deg);
    EXPECT_FALSE(Timeline(rolling_scene(), Eigen::Vector3d(0.0, 0.0, -0.7)).camera_moves());
}

TEST(Timeline, MovingCameraHasThePoseOfItsTimeline) {
    Scene scene = rolling_scene();
    scene.keyframes = {key_at(2.0, 10.0, 4.0), key_at(4.0, 30.0, 9.0)};
    scene.camera.target = Eigen::Vector3d(0.0, 0.0, 0.3);
    const StagedScene staged(scene, 10.0);
    for (const double film_s : {0.0, 1.0, 3.0, 8.0}) {
        const CameraPose pose = staged.stage.context().timeline.camera_at(film_s);
        const Camera camera = view_at(staged, film_s).camera;
        const Eigen::Vector3d from = camera.eye - camera.target;
        EXPECT_NEAR(from.norm(), pose.distance, 1e-12);
        EXPECT_NEAR(std::remainder(std::atan2(from.y(), from.x()) * 180.0 / std::numbers::pi -
                                       pose.azimuth_deg,
                                   360.0),
                    0.0, 1e-12);
    }
}

TEST(Timeline, CameraMovesContinuouslyFromFramingToATarget) {
    Scene scene = rolling_scene();
    KeyframeSpec key = key_at(4.0, 10.0, 3.0);
    key.look_at = "foot";
    scene.keyframes = {key};
    const StagedScene staged(scene, 10.0);
    Eigen::Vector3d before = view_at(staged, 0.0).camera.eye;
    double longest = 0.0;
    for (int k = 1; k <= 400; ++k) {
        const Eigen::Vector3d eye = view_at(staged, 0.01 * k).camera.eye;
        longest = std::max(longest, (eye - before).norm());
        before = eye;
    }
    // About 6 units in 400 even steps; half a unit would be a jump. Measured 0.02.
    EXPECT_LT(longest, 0.1);
    const Camera last = view_at(staged, 4.0).camera;
    EXPECT_NEAR((last.eye - last.target).norm(), 3.0, 1e-12);
}

TEST(Timeline, ViewFromTheTopSeesTheVerticalAsAPoint) {
    Scene scene = rolling_scene();
    const CameraView& top = camera_view_named("top");
    scene.camera.azimuth_deg = top.azimuth_deg;
    scene.camera.elevation_deg = top.elevation_deg;
    scene.camera.look_at = top.look_at;
    const StagedScene staged(scene, 1.0);
    const View view = view_at(staged, 0.0);
    const Eigen::Vector2d low = project(view, {0.0, 0.0, -0.5}).px;
    const Eigen::Vector2d high = project(view, {0.0, 0.0, 1.0}).px;
    EXPECT_LT((low - high).norm(), 1e-9);
    // The direction is continuous in the elevation: 89.9° looks nearly the same.
    scene.camera.elevation_deg = 88.9999;
    const StagedScene near(scene, 1.0);
    scene.camera.elevation_deg = 89.0001;
    const StagedScene nearer(scene, 1.0);
    const Eigen::Vector3d point(0.7, 0.4, 0.2);
    EXPECT_LT(
        (project(view_at(near, 0.0), point).px - project(view_at(nearer, 0.0), point).px).norm(),
        0.01);
}

TEST(Fades, ShowAndHideElements) {
    Scene scene = rolling_scene();
    scene.fades = {fade_at(1.0, "plane"), fade_at(2.0, "ellipsoid", 0.25),
                   fade_at(4.0, "plane", 0.0)};
    const StagedScene staged(scene, 10.0);
    const double whole = view_at(StagedScene(rolling_scene(), 10.0), 0.0).planes.at(0).opacity;
    EXPECT_TRUE(view_at(staged, 0.5).planes.empty());
    EXPECT_NEAR(view_at(staged, 1.5).planes.at(0).opacity, 0.5 * whole, 1e-14);
    EXPECT_EQ(view_at(staged, 3.0).planes.at(0).opacity, whole);
    EXPECT_TRUE(view_at(staged, 6.0).planes.empty());
    EXPECT_EQ(view_at(staged, 1.0).ellipsoids.at(0).presence, 1.0);
    EXPECT_EQ(view_at(staged, 9.0).ellipsoids.at(0).presence, 0.25);
}

TEST(Fades, IncludeTheLabels) {
    Scene scene = rolling_scene({"plane", "momentum"});
    scene.fades = {fade_at(0.0, "momentum")};
    const StagedScene staged(scene, 10.0);
    EXPECT_TRUE(view_at(staged, 0.0).labels.empty());
    ASSERT_EQ(view_at(staged, 0.5).labels.size(), 1u);
    EXPECT_NEAR(view_at(staged, 0.5).labels[0].opacity, 0.5, 1e-14);
    EXPECT_EQ(view_at(staged, 1.5).labels[0].opacity, 1.0);
}

TEST(Fades, OfElementsThatAreNotShownAreRejected) {
    Scene scene = rolling_scene();
    scene.fades = {fade_at(0.0, "planes")};
    try {
        const StagedScene staged(scene, 1.0);
        FAIL() << "accepted";
    } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what())
                      .find("no element shown is called \"planes\"; did you mean \"plane\"?"),
                  std::string::npos)
            << error.what();
    }
}

// The end of a curve's shown part, in its view's axes.
Eigen::Vector3d end_of(const Curve& curve) {
    const auto& points = curve.geometry->points;
    const double last = std::min(curve.last, static_cast<double>(points.size() - 1));
    const auto i = static_cast<std::size_t>(last);
    const Eigen::Vector3d a = points[i];
    const Eigen::Vector3d b = points[std::min(i + 1, points.size() - 1)];
    return curve.placement * Eigen::Vector3d(a + (last - std::floor(last)) * (b - a));
}

TEST(Trails, EndAtTheContactPoint) {
    for (const std::string kind : {"history", "fading"}) {
        Scene scene = rolling_scene({"polhode", "herpolhode", "contact"});
        scene.trail.polhode = scene.trail.herpolhode = kind;
        scene.trail.length_s = 3.0;
        const StagedScene staged(scene, 40.0);
        for (const double t : {0.5, 2.0, period_s - 1e-6, period_s + 1e-6, 15.0, 40.0}) {
            const View view = view_at(staged, t);
            ASSERT_EQ(view.curves.size(), 3u);  // the herpolhode has an edge
            const double px = staged.stage.panels().front().units_per_px;
            for (const Curve& curve : view.curves) {
                // The polyline is within half of accuracy_px = 0.1 of the path; between two points
                // the time is interpolated linearly, which adds a few times that. Measured 0.3.
                EXPECT_LT((end_of(curve) - view.dots.at(0).at).norm() / px, 1.0) << kind << t;
            }
        }
    }
}

TEST(Trails, ShowTheRequestedPart) {
    Scene scene = rolling_scene({"polhode"});
    scene.trail.polhode = "history";
    const StagedScene history(scene, 40.0);
    const auto shown = [](const View& view) {
        return view.curves.at(0).last - view.curves.at(0).first;
    };
    // It grows, and is complete after one period.
    EXPECT_LT(shown(view_at(history, 1.0)), shown(view_at(history, 2.0)));
    EXPECT_LT(shown(view_at(history, 5.0)), shown(view_at(history, 9.0)));
    EXPECT_NEAR(shown(view_at(history, 12.0)), shown(view_at(history, 21.3)), 0.5);

    scene.trail.polhode = "fading";
    scene.trail.length_s = 2.0;
    const StagedScene fading(scene, 40.0);
    EXPECT_LT(shown(view_at(fading, 20.0)), 0.5 * shown(view_at(history, 20.0)));
    const Curve old = view_at(fading, 20.0).curves.at(0);
    EXPECT_NEAR(old.fade_points, old.last - old.first, 1e-9);
}

TEST(DirectionMarks, PointInTheDirectionOfTheContactPoint) {
    for (const std::string kind : {"whole", "history"}) {
        Scene scene = rolling_scene({"polhode"});
        scene.trail.polhode = kind;
        scene.trail.direction_marks = true;
        const StagedScene staged(scene, 10.0);
        const double t = 7.0;
        const View view = view_at(staged, t);
        ASSERT_GT(view.curves.size(), 4u);
        // The contact point moves past the marks; the nearest one points along its velocity.
        const ConstructionPicture& picture = *staged.stage.context().rolling;
        double least = 1e9;
        double along = 0.0;
        for (int k = 0; k < 4000; ++k) {
            const double instant_s = 7.0 * k / 4000.0;
            const auto on_body = [&](double s) -> Eigen::Vector3d {
                return picture.construction.contact_body(staged.motion.at(s).omega_body) *
                       picture.picture_per_rho;
            };
            const Eigen::Affine3d placement = view.curves.at(0).placement;
            const Eigen::Vector3d at = placement * on_body(instant_s);
            const Eigen::Vector3d run =
                placement.linear() * (on_body(instant_s + 1e-4) - on_body(instant_s));
            const Curve& mark = view.curves.at(2);
            const double distance = (mark.placement.translation() - at).norm();
            if (distance >= least) continue;
            least = distance;
            along = run.dot(mark.placement.linear().col(0));
        }
        EXPECT_LT(least, 0.01) << kind;
        EXPECT_GT(along, 0.0) << kind;
    }
}

TEST(DirectionMarks, HaveAConstantSizeInPixels) {
    for (const double distance : {3.0, 12.0}) {
        Scene scene = rolling_scene({"herpolhode"});
        scene.camera.distance = distance;
        scene.trail.direction_marks = true;
        const StagedScene staged(scene, 10.0);
        const View view = view_at(staged, 10.0);
        ASSERT_GT(view.curves.size(), 2u);
        // After the herpolhode and its edge.
        for (std::size_t i = 2; i < view.curves.size(); ++i) {
            const Curve& mark = view.curves[i];
            const Eigen::Vector2d tip = project(view, mark.placement * Eigen::Vector3d::Zero()).px;
            const Eigen::Vector2d foot =
                project(view, mark.placement * Eigen::Vector3d(-1.0, 0.0, 0.0)).px;
            // 9 px at 1080 rows; they are in the picture plane, so that perspective has no effect.
            EXPECT_NEAR((tip - foot).norm(), 9.0 * 360.0 / 1080.0, 1e-6);
        }
    }
}

TEST(DirectionMarks, OfALongHistoryAreAsFewAsOfAShortOne) {
    Scene scene = rolling_scene({"herpolhode"});
    scene.trail.direction_marks = true;
    const StagedScene staged(scene, 2000.0);
    EXPECT_LE(view_at(staged, 2000.0).curves.size(), 18u);
}

TEST(CoPrecessing, SeesAClosedHerpolhode) {
    Scene scene = rolling_scene({"herpolhode"});
    scene.camera.motion = "co-precessing";
    const StagedScene staged(scene, period_s);
    const auto& points = view_at(staged, period_s).curves.at(0).geometry->points;
    // After one period it is back at its start; in fixed axes it is not.
    const Curve whole = view_at(staged, period_s).curves.at(0);
    // To accuracy_px, the polyline's bound; measured 0.03 px.
    const double px = staged.stage.panels().front().units_per_px;
    EXPECT_LT((end_of(whole) - points.front()).norm() / px, 0.1);
    scene.camera.motion = "fixed";
    const StagedScene fixed(scene, period_s);
    const Curve open = view_at(fixed, period_s).curves.at(0);
    EXPECT_GT((end_of(open) - open.geometry->points.front()).norm(), 0.1);
}

}  // namespace

}  // namespace poinsot::timeline_tests
