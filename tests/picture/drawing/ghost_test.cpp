// The comparison motion is drawn as its method computes it, and is absent if there is none.
#include "drawing/figures/elements/ghost.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "drawing/stage/panel.h"
#include "error/error.h"
#include "numerics/least_turn.h"
#include "scenes_by_hand.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot::ghost_tests {
namespace {

const Eigen::Vector3d moments{1.0, 2.0, 2.6};
const Eigen::Vector3d omega{1.2, 0.35, 1.1};

// A stage whose scene has a second method.
struct StagedBeside {
    Scene scene;
    Motion motion;
    Motion beside;
    Stage stage;

    StagedBeside(const Scene& scene_, const MethodChoice& choice)
        : scene(with(scene_, choice)),
          motion(problem_of(scene)),
          beside(problem_beside()),
          stage(
              scene, theme_of(scene), motion,
              {.width_px = 640, .height_px = 360, .last_time_s = 10.0, .fonts = installed_fonts()},
              &beside) {}

    MotionProblem problem_beside() const {
        MotionProblem problem = motion.problem();
        problem.method = *scene.beside;
        return problem;
    }
    static Scene with(Scene scene, const MethodChoice& choice) {
        scene.beside = choice;
        return scene;
    }
};

const MethodChoice euler{"euler", 0.05, {}, {}};
const MethodChoice exact{"exact", {}, {}, {}};

// The largest difference of two matrices' elements.
double apart(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
    return (a - b).cwiseAbs().maxCoeff();
}

TEST(Ghost, EllipsoidRotatesAsTheComparisonMethodComputes) {
    const StagedBeside staged(free_scene(moments, omega, "space"), euler);
    for (const double time_s : {0.0, 3.3, 10.0}) {
        const Drawing drawing = staged.stage.at(time_s);
        const auto& ellipsoids = drawing.views[0].ellipsoids;
        ASSERT_EQ(ellipsoids.size(), 2u);
        // Both ellipsoids are equal up to the rotation between the two attitudes, in picture axes.
        const ConstructionPicture& picture = *staged.stage.context().rolling;
        const Eigen::Quaterniond between = picture.picture_from_space *
                                           staged.beside.at(time_s).space_from_body *
                                           staged.motion.at(time_s).space_from_body.conjugate() *
                                           picture.picture_from_space.conjugate();
        EXPECT_LE(apart(ellipsoids[1].half_axes, between * ellipsoids[0].half_axes), 1e-14);
        EXPECT_EQ(ellipsoids[1].casts_shadow, false);
    }
}

TEST(Ghost, ExactMethodCoincidesWithItself) {
    const StagedBeside staged(free_scene(moments, omega, "space"), exact);
    const Drawing drawing = staged.stage.at(7.0);
    const auto& ellipsoids = drawing.views[0].ellipsoids;
    ASSERT_EQ(ellipsoids.size(), 2u);
    EXPECT_LE(apart(ellipsoids[0].half_axes, ellipsoids[1].half_axes), 1e-14);
}

// The value of F at the end of the ghost's path in the body panel, in the ellipsoid's axes: T(t)/T.
double energy_at_end(const StagedBeside& staged) {
    const Drawing drawing = staged.stage.at(10.0);
    const View& view = drawing.views[0];
    const Colour& grey = staged.stage.context().theme.ghost;
    for (const Curve& curve : view.curves) {
        if (!(curve.colour == grey)) continue;
        const auto last = static_cast<std::size_t>(
            std::min(curve.last, static_cast<double>(curve.geometry->points.size() - 1)));
        const Eigen::Vector3d point = curve.geometry->points[last];
        return point.cwiseQuotient(staged.stage.context().rolling->half_axes).squaredNorm();
    }
    return 0.0;
}

TEST(Ghost, PolhodeOfEulersMethodLeavesTheEllipsoidAsItsEnergyGrows) {
    const StagedBeside staged(free_scene(moments, omega, "body"), euler);
    const auto energy = [&](const Motion& motion) {
        const Eigen::Vector3d w = motion.at(10.0).omega_body;
        return w.dot(moments.cwiseProduct(w));
    };
    const double grown = energy(staged.beside) / energy(staged.motion);
    EXPECT_GT(grown, 1.05);
    // The path's last point is at most 0.05 s earlier: T grows by less than 1e-2 in that time.
    EXPECT_NEAR(energy_at_end(staged), grown, 1e-2);
    EXPECT_NEAR(energy_at_end(StagedBeside(free_scene(moments, omega, "body"), exact)), 1.0, 1e-14);
}

TEST(Ghost, MomentumOfEulersMethodLeavesTheSphere) {
    const StagedBeside staged(free_scene(moments, omega, "momentum"), euler);
    const Drawing drawing = staged.stage.at(10.0);
    const Eigen::Vector3d w = staged.beside.at(10.0).omega_body;
    const double grown = moments.cwiseProduct(w).norm() / moments.cwiseProduct(omega).norm();
    EXPECT_GT(grown, 1.02);
    EXPECT_NEAR(drawing.views[0].arrows.back().tip.norm(), grown, 1e-14);
}

TEST(Ghost, PlotHasCurvesOfBothMotions) {
    const StagedScene alone(free_scene(moments, omega, "plot"), 10.0);
    const StagedBeside both(free_scene(moments, omega, "plot"), euler);
    const auto n_plotted = [](const Drawing& drawing) {
        const auto& curves = drawing.views[0].curves;
        return std::count_if(curves.begin(), curves.end(),
                             [](const Curve& curve) { return curve.lasting; });
    };
    EXPECT_EQ(n_plotted(alone.stage.at(1.0)), 3);
    EXPECT_EQ(n_plotted(both.stage.at(1.0)), 6);
}

// The last curve in the ghost's colour in the only view.
const Curve& last_grey_curve(const StagedBeside& staged, const Drawing& drawing) {
    const Colour& grey = staged.stage.context().theme.ghost;
    const auto& curves = drawing.views[0].curves;
    return *std::find_if(curves.rbegin(), curves.rend(),
                         [&grey](const Curve& curve) { return curve.colour == grey; });
}

TEST(Ghost, PlotNamesTheCurvesThatStayInIt) {
    Scene scene = free_scene(moments, omega, "plot");
    scene.panels[0].quantity = "invariants";
    const auto names_of = [&scene](double step_s) {
        const StagedBeside staged(scene, {"euler", step_s, {}, {}});
        const Drawing drawing = staged.stage.at(5.0);
        std::vector<std::string> names;
        for (const Label& label : drawing.views[0].labels)
            if (label.mask->source.is_formula) names.push_back(label.mask->source.text);
        return names;
    };
    const auto has = [](const std::vector<std::string>& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    const std::vector<std::string> near = names_of(0.01), far = names_of(1.0);
    for (const char* const name : {"T", "L"}) {
        EXPECT_TRUE(has(near, name) && has(far, name)) << name;
        const std::string of_euler = std::string("{") + name + "}_{\\mathrm{Euler}}";
        EXPECT_TRUE(has(near, of_euler)) << name;
        EXPECT_FALSE(has(far, of_euler)) << name;  // T and L grow to more than 100 times
    }
}

TEST(Ghost, BodyOfTheObjectPanelRotatesAsTheComparisonMethodComputes) {
    const StagedBeside staged(free_scene(moments, omega, "object"), euler);
    const Drawing drawing = staged.stage.at(3.3);
    // The third principal axis is the last of the body's lines.
    const Curve& axis = last_grey_curve(staged, drawing);
    const Eigen::Vector3d end = axis.placement * axis.geometry->points.back();
    // A single panel has L up.
    const Eigen::Quaterniond picture_from_space =
        least_turn(moments.cwiseProduct(omega), Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d e3 =
        picture_from_space * (staged.beside.at(3.3).space_from_body * Eigen::Vector3d::UnitZ());
    EXPECT_LE((end.normalized() - e3).norm(), 1e-14);
}

TEST(Ghost, AxisOfATopIsThatOfTheComparisonMethod) {
    Scene scene = top_scene({.theta_rad = 0.7, .omega3_rad_s = 8.0}, "top");
    const StagedBeside staged(scene, {"rk4", 0.2, {}, {}});
    const Drawing drawing = staged.stage.at(6.0);
    const Eigen::Vector3d e3 = staged.beside.at(6.0).space_from_body * Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d exact_e3 =
        staged.motion.at(6.0).space_from_body * Eigen::Vector3d::UnitZ();
    EXPECT_GT((e3 - exact_e3).norm(), 1e-3);  // such a large step causes drift
    const auto& arrows = drawing.views[0].arrows;
    const auto tip_is_there = [&e3](const Arrow& arrow) { return (arrow.tip - e3).norm() < 1e-14; };
    EXPECT_TRUE(std::any_of(arrows.begin(), arrows.end(), tip_is_there));
    // The path ends there, up to less than one of its pieces.
    const Curve& path = last_grey_curve(staged, drawing);
    EXPECT_LE((path.geometry->points[static_cast<std::size_t>(path.last)] - e3).norm(), 0.2);
}

// The path of ρ's component perpendicular to L, in units of the greatest one of the exact motion,
// with the T of the start.
TEST(Ghost, HerpolhodeInThePlanIsThatOfTheComparisonMethod) {
    const StagedBeside staged(free_scene(moments, omega, "plan"), euler);
    const Drawing drawing = staged.stage.at(6.0);
    const Curve& path = last_grey_curve(staged, drawing);
    const Eigen::Vector3d end = path.geometry->points[static_cast<std::size_t>(path.last)];
    const Eigen::Vector3d momentum = moments.cwiseProduct(omega);
    const RotationState state = staged.beside.at(6.0);
    const Eigen::Vector3d rho =
        state.space_from_body * state.omega_body / std::sqrt(omega.dot(momentum));
    const double perpendicular = rho.cross(momentum.normalized()).norm();
    const double outer = staged.stage.context().rolling->polhode.annulus().outer;
    EXPECT_NEAR(end.norm(), perpendicular / outer, 0.03);
    EXPECT_EQ(end.z(), 0.0);
}

TEST(Ghost, IsAbsentWithoutAComparisonMotion) {
    const StagedScene staged(free_scene(moments, omega, "space"), 10.0);
    EXPECT_EQ(staged.stage.at(1.0).views[0].ellipsoids.size(), 1u);
    Scene scene = free_scene(moments, omega, "space");
    scene.show = {"ghost"};
    EXPECT_THROW(StagedScene(scene, 10.0), InputError);
}

TEST(Ghost, IsRejectedByPanelsThatCannotShowIt) {
    const Scene scene = top_scene({.theta_rad = 0.7, .omega3_rad_s = 8.0}, "potential");
    EXPECT_THROW(StagedBeside(scene, {"rk4", 0.2, {}, {}}), InputError);
}

TEST(Ghost, DivergingMethodDrawsNoLineToInfinity) {
    const StagedBeside staged(free_scene(moments, omega, "space"), {"euler", 1.0, {}, {}});
    ASSERT_GT(staged.beside.at(10.0).omega_body.norm(), 6.0 * omega.norm());
    const Drawing drawing = staged.stage.at(10.0);
    for (const Curve& curve : drawing.views[0].curves) {
        for (const Eigen::Vector3d& point : curve.geometry->points) EXPECT_LE(point.norm(), 4.0);
    }
}

}  // namespace
}  // namespace poinsot::ghost_tests
