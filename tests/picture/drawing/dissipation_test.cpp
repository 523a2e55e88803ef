// Poinsot's construction of a body with internal friction: L is conserved, the plane approaches,
// the polhode is a spiral. And of a body that the air slows: L falls and turns, the picture with
// it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawing/stage/panel.h"
#include "error/error.h"
#include "mechanics/half_life.h"
#include "scenes_by_hand.h"

namespace poinsot {
namespace {

const Eigen::Vector3d moments{3.0, 2.0, 1.0};
const Eigen::Vector3d omega{0.05, 0.02, 2.0};
constexpr double stepping_tolerance = 1e-11;

Scene burning(const std::string& panel) {
    Scene scene = free_scene(moments, omega, panel);
    scene.torque = InternalFriction{friction_rate_of_half_life(scene.body.inertia, omega, 10.0)};
    scene.method = {.name = "dopri5", .step_s = {}, .tolerance = stepping_tolerance, .order = {}};
    scene.film.duration_s = 30.0;
    scene.trail.polhode = "history";
    return scene;
}

// T relative to its value at the start, from the motion itself.
double energy_share(const StagedScene& staged, double time_s) {
    const Eigen::Vector3d w = staged.motion.at(time_s).omega_body;
    return w.dot(moments.cwiseProduct(w)) / omega.dot(moments.cwiseProduct(omega));
}

// |L| of a body with this ω, kg m²/s.
double momentum(const Eigen::Vector3d& omega_body) {
    return moments.cwiseProduct(omega_body).norm();
}

// Whether a dot is on both the plane, which is normal to z, and the ellipsoid.
bool has_contact(const View& view) {
    const Eigen::Matrix3d inverse = view.ellipsoids[0].half_axes.inverse();
    return std::any_of(view.dots.begin(), view.dots.end(), [&](const Dot& dot) {
        return std::abs(dot.at.z() - view.planes[0].centre.z()) < 1e-9 &&
               std::abs((inverse * dot.at).norm() - 1.0) < 1e-9;
    });
}

TEST(Dissipation, PlaneDistanceIsTheRootOfTheRemainingEnergy) {
    for (const char* side : {"below", "above"}) {
        Scene scene = burning("space");
        scene.construction.plane = side;
        const StagedScene staged(scene, 30.0);
        const Drawing first = staged.stage.at(0.0);
        ASSERT_EQ(first.views[0].planes.size(), 1u);
        const double start = first.views[0].planes[0].centre.z();
        EXPECT_EQ(start > 0.0, std::string(side) == "above");
        for (int k = 0; k <= 10; ++k) {
            const double time_s = 3.0 * k;
            const Drawing drawing = staged.stage.at(time_s);
            const View& view = drawing.views[0];
            const Plane& plane = view.planes[0];
            EXPECT_NEAR(plane.centre.z(), start * std::sqrt(energy_share(staged, time_s)), 1e-12);
            // The plane touches the ellipsoid: F at the plane's point with the same normal is 1.
            const Eigen::Matrix3d axes = view.ellipsoids[0].half_axes;
            const Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
            EXPECT_NEAR((axes.transpose() * normal).norm(), std::abs(plane.centre.z()), 1e-9);
            EXPECT_TRUE(has_contact(view)) << time_s;
        }
    }
}

// The path goes from near the axis of the least moment to near that of the largest, always on the
// ellipsoid.
TEST(Dissipation, PolhodeIsASpiralOnTheEllipsoid) {
    for (const char* kind : {"space", "body"}) {
        const StagedScene staged(burning(kind), 30.0);
        const Drawing drawing = staged.stage.at(30.0);
        const View& view = drawing.views[0];
        const Curve* spiral = nullptr;
        for (const Curve& curve : view.curves)
            if (curve.on_surface == 0 && !curve.geometry->closed &&
                (spiral == nullptr ||
                 curve.geometry->points.size() > spiral->geometry->points.size()))
                spiral = &curve;
        ASSERT_NE(spiral, nullptr) << kind;
        const auto& points = spiral->geometry->points;
        const Eigen::Vector3d half_axes = moments.cwiseSqrt().cwiseInverse();
        for (const Eigen::Vector3d& point : points)
            EXPECT_NEAR(point.cwiseQuotient(half_axes).norm() * half_axes.maxCoeff(), 1.0, 1e-12);
        EXPECT_GT(points.front().z(), 0.9);
        EXPECT_GT(points.back().normalized().cwiseAbs().x(), 0.9);
        // The end of the path is shown, its start is not.
        EXPECT_NEAR(spiral->last, static_cast<double>(points.size() - 1), 1.0);
        EXPECT_LT(staged.stage.at(0.0).views[0].curves.size(), 1000u);
    }
}

TEST(Dissipation, EnergyEllipsoidShrinksOnTheMomentumSphere) {
    const StagedScene staged(burning("momentum"), 30.0);
    const Drawing start = staged.stage.at(0.0);
    const double before = start.views[0].ellipsoids[1].half_axes(0, 0);
    for (const double time_s : {0.0, 7.0, 15.0, 30.0}) {
        const Drawing drawing = staged.stage.at(time_s);
        const View& view = drawing.views[0];
        EXPECT_NEAR(view.ellipsoids[1].half_axes(0, 0) / before,
                    std::sqrt(energy_share(staged, time_s)), 1e-12);
        EXPECT_EQ(view.ellipsoids[0].half_axes.diagonal(), Eigen::Vector3d::Ones());
        // L's tip is on both surfaces.
        const Eigen::Vector3d tip = view.arrows.back().tip;
        EXPECT_NEAR(tip.norm(), 1.0, 1e-14);
        // The drawing assumes a constant L, which stepping conserves only to its tolerance.
        const double drift = momentum(omega) / momentum(staged.motion.at(time_s).omega_body);
        EXPECT_NEAR(drift, 1.0, 10.0 * stepping_tolerance);
        EXPECT_NEAR((view.ellipsoids[1].half_axes.inverse() * tip).norm(), drift, 1e-12);
    }
}

TEST(Dissipation, IsShownByPanelsThatAllowIt) {
    Scene scene = burning("space");
    for (const char* kind : {"space", "body", "momentum", "object", "plot"}) {
        scene.panels[0].kind = kind;
        EXPECT_NO_THROW(StagedScene(scene, 5.0)) << kind;
    }
    // A herpolhode in one plane, and residuals, need a conserved T.
    scene.panels[0].kind = "plan";
    EXPECT_THROW(StagedScene(scene, 5.0), InputError);
    scene.panels[0].kind = "plot";
    scene.panels[0].quantity = "residuals";
    EXPECT_THROW(StagedScene(scene, 5.0), InputError);
    for (const char* quantity : {"omega", "energy", "momentum", "tilt"}) {
        scene.panels[0].quantity = quantity;
        EXPECT_NO_THROW(StagedScene(scene, 5.0)) << quantity;
    }
    scene.panels.clear();
    const StagedScene staged(scene, 5.0);
    EXPECT_EQ(staged.stage.at(1.0).views[0].planes.size(), 1u);  // the space panel by default
}

// A body that the air slows most about its longest axis.
Scene slowed(const std::string& panel) {
    Scene scene = free_scene(moments, Eigen::Vector3d(0.6, 1.5, 2.0), panel);
    scene.torque = Drag{{0.02, 0.05, 0.1}, {0.0, 0.0, 0.02}, 0.03};
    scene.method = {.name = "dopri5", .step_s = {}, .tolerance = stepping_tolerance, .order = {}};
    scene.film.duration_s = 20.0;
    scene.trail.polhode = "history";
    return scene;
}

// √(2T)/L from the motion itself.
double distance_at(const StagedScene& staged, double time_s) {
    const Eigen::Vector3d w = staged.motion.at(time_s).omega_body;
    return std::sqrt(w.dot(moments.cwiseProduct(w))) / momentum(w);
}

// The plane stays level, while L turns in space: the picture turns with L.
TEST(Drag, ThePlaneFollowsTheMomentum) {
    const StagedScene staged(slowed("space"), 20.0);
    const auto direction = [&staged](double time_s) -> Eigen::Vector3d {
        const RotationState state = staged.motion.at(time_s);
        return (state.space_from_body * moments.cwiseProduct(state.omega_body)).normalized();
    };
    EXPECT_GT(direction(0.0).cross(direction(20.0)).norm(), 1e-3);
    const double start = staged.stage.at(0.0).views[0].planes[0].centre.norm();
    for (int k = 0; k <= 10; ++k) {
        const double time_s = 2.0 * k;
        const Drawing drawing = staged.stage.at(time_s);
        const View& view = drawing.views[0];
        const Plane& plane = view.planes[0];
        const double distance = distance_at(staged, time_s) / distance_at(staged, 0.0);
        EXPECT_NEAR(plane.centre.norm(), start * distance, 1e-12) << time_s;
        EXPECT_NEAR(std::abs(plane.centre.z()), plane.centre.norm(), 1e-15);
        // The plane, which is normal to z, touches the ellipsoid.
        const Eigen::Matrix3d axes = view.ellipsoids[0].half_axes;
        EXPECT_NEAR((axes.transpose() * Eigen::Vector3d::UnitZ()).norm(), plane.centre.norm(), 1e-9)
            << time_s;
        EXPECT_TRUE(has_contact(view)) << time_s;
    }
}

TEST(Drag, TheHerpolhodeEndsAtTheContactPoint) {
    const StagedScene staged(slowed("space"), 20.0);
    for (const double time_s : {5.0, 12.3, 20.0}) {
        const Drawing drawing = staged.stage.at(time_s);
        const View& view = drawing.views[0];
        double nearest = 1.0;
        for (const Curve& curve : view.curves) {
            if (curve.name.element != "herpolhode") continue;
            const auto& points = curve.geometry->points;
            const double place = std::min(curve.last, static_cast<double>(points.size() - 1));
            const auto i = static_cast<std::size_t>(place);
            const std::size_t next = std::min(i + 1, points.size() - 1);
            const Eigen::Vector3d tip =
                curve.placement * Eigen::Vector3d(points[i] + (place - std::floor(place)) *
                                                                  (points[next] - points[i]));
            const Eigen::Matrix3d inverse = view.ellipsoids[0].half_axes.inverse();
            nearest = std::min(nearest, std::abs((inverse * tip).norm() - 1.0));
        }
        EXPECT_LT(nearest, 1e-3) << time_s;
    }
}

TEST(Drag, EnergyEllipsoidAndSphereMeetAtTheMomentum) {
    const StagedScene staged(slowed("momentum"), 20.0);
    const double before = staged.stage.at(0.0).views[0].ellipsoids[1].half_axes(0, 0);
    for (const double time_s : {0.0, 7.0, 20.0}) {
        const Drawing drawing = staged.stage.at(time_s);
        const View& view = drawing.views[0];
        EXPECT_NEAR(view.ellipsoids[1].half_axes(0, 0) / before,
                    distance_at(staged, time_s) / distance_at(staged, 0.0), 1e-12);
        const Eigen::Vector3d tip = view.arrows.back().tip;
        EXPECT_NEAR(tip.norm(), 1.0, 1e-14);
        EXPECT_NEAR((view.ellipsoids[1].half_axes.inverse() * tip).norm(), 1.0, 1e-12);
    }
}

TEST(Drag, IsShownByPanelsThatAllowIt) {
    Scene scene = slowed("space");
    for (const char* kind : {"space", "body", "momentum", "object", "plot"}) {
        scene.panels[0].kind = kind;
        EXPECT_NO_THROW(StagedScene(scene, 5.0).stage.at(5.0)) << kind;
    }
    scene.panels[0].kind = "plan";
    EXPECT_THROW(StagedScene(scene, 5.0), InputError);
    scene.panels.clear();
    EXPECT_EQ(StagedScene(scene, 5.0).stage.at(1.0).views[0].planes.size(), 1u);
    // Nothing is left of ω that a construction could be drawn from.
    scene.torque = Drag{{20.0, 30.0, 40.0}};
    EXPECT_THROW(StagedScene(scene, 20.0), InputError);
}

}  // namespace
}  // namespace poinsot
