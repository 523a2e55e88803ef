// The measured motion on the construction: where its points lie, and when they appear.
#include "drawing/figures/elements/measured_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "drawing/style/theme.h"
#include "error/error.h"
#include "panels_by_hand.h"
#include "scenes_by_hand.h"
#include "shapes/projection.h"

namespace poinsot::panels_tests {
namespace {

bool is_measured(const ShapeName& name) { return name.element == "measured"; }

std::vector<Dot> measured_dots(const View& view) {
    std::vector<Dot> dots;
    for (const Dot& dot : view.dots)
        if (is_measured(dot.name)) dots.push_back(dot);
    return dots;
}

Scene measured_scene(const std::string& panel, double factor, int n_rows = 21,
                     bool with_attitude = true) {
    Scene scene = free_scene({3.0, 2.2, 1.3}, {0.9, 1.4, -0.8}, panel);
    measure(scene, 10.0, n_rows, factor, with_attitude);
    return scene;
}

// Where a point is in the picture.
Eigen::Vector2d place_of(const View& view, const Eigen::Vector3d& at) {
    return project(view, at).px;
}

// The pixels of ρ = ω/√(2T) of the rows, with the scene's T: first on the ellipsoid of the instant,
// then on the plane, by the definition.
std::vector<Eigen::Vector2d> expected_places(const StagedScene& staged, const View& view,
                                             double time_s) {
    const Scene& scene = staged.scene;
    const MotionProblem& problem = staged.motion.problem();
    const Eigen::Matrix3d inertia = problem.inertia.matrix_body();
    const Eigen::Vector3d& omega = problem.start.omega_body;
    const double root_2T = std::sqrt(omega.dot(inertia * omega));
    // Picture lengths: the largest half-axis 1/√I is 1.
    const double scale = std::sqrt(problem.inertia.moments_kg_m2().minCoeff()) / root_2T;
    // Picture axes from the instant's ellipsoid, whose half-axes are along e1, e2, e3.
    const Eigen::Matrix3d halves = view.ellipsoids.at(0).half_axes;
    Eigen::Matrix3d axes;
    for (int k = 0; k < 3; ++k) axes.col(k) = halves.col(k).normalized();
    const Eigen::Matrix3d picture_from_body =
        axes * problem.inertia.body_from_principal().transpose();
    const Eigen::Matrix3d picture_from_space =
        picture_from_body * staged.motion.at(time_s).space_from_body.toRotationMatrix().transpose();
    std::vector<Eigen::Vector2d> places;
    for (const bool on_plane : {false, true})
        for (const MeasuredRow& row : scene.measured.motion.rows) {
            if (row.time_s > time_s) break;
            const Eigen::Matrix3d turn =
                on_plane ? Eigen::Matrix3d(picture_from_space *
                                           staged.motion.at(row.time_s).space_from_body)
                         : picture_from_body;
            places.push_back(place_of(view, turn * (scale * row.omega_body)));
        }
    return places;
}

// In perspective and orthographic views; a table 3 % too fast lies outside of the ellipsoid.
TEST(MeasuredPoints, LieAtOmegaOverTheScenesRootOfTwiceT) {
    for (const char* projection : {"perspective", "orthographic"})
        for (const bool with_attitude : {true, false})
            for (const double factor : {1.0, 1.03}) {
                Scene scene = measured_scene("space", factor, 21, with_attitude);
                scene.camera.projection = projection;
                const StagedScene staged(scene, 10.0);
                const double time_s = 6.3;
                const View view = staged.stage.at(time_s).views.at(0);
                const std::vector<Dot> dots = measured_dots(view);
                const auto expected = expected_places(staged, view, time_s);
                ASSERT_EQ(dots.size(), expected.size());
                EXPECT_EQ(dots.size(), 2u * 13u);  // rows every half second, on both surfaces
                for (std::size_t i = 0; i < dots.size(); ++i)
                    EXPECT_LT((place_of(view, dots[i].at) - expected[i]).norm(), 1e-6)
                        << projection << factor << i;
            }
}

// ω of a table that is right ends on the polhode, in the body panel.
TEST(MeasuredPoints, OfTheExactMotionLieOnTheEllipsoid) {
    const StagedScene staged(measured_scene("body", 1.0), 10.0);
    const View view = staged.stage.at(10.0).views.at(0);
    const Eigen::Vector3d halves = view.ellipsoids.at(0).half_axes.diagonal();
    std::size_t n = 0;
    for (const Curve& curve : view.curves) {
        if (!is_measured(curve.name)) continue;
        for (const Eigen::Vector3d& point : curve.geometry->points) {
            EXPECT_NEAR(point.cwiseQuotient(halves).norm(), 1.0, 1e-12);
            ++n;
        }
    }
    EXPECT_EQ(n, 21u);
    EXPECT_EQ(measured_dots(view).size(), 21u);
}

// The line is not drawn where rows are missing.
TEST(MeasuredPoints, AreNotJoinedAcrossGaps) {
    Scene scene = measured_scene("body", 1.0, 41);
    auto& rows = scene.measured.motion.rows;
    rows.erase(rows.begin() + 10, rows.begin() + 20);
    const StagedScene staged(scene, 10.0);
    std::vector<std::size_t> lengths;
    const Drawing drawing = staged.stage.at(10.0);
    for (const Curve& curve : drawing.views.at(0).curves)
        if (is_measured(curve.name)) lengths.push_back(curve.geometry->points.size());
    EXPECT_EQ(lengths, (std::vector<std::size_t>{10, 21}));
}

// The line ends at the last row that was measured by then.
TEST(MeasuredPoints, AppearWithTime) {
    const StagedScene staged(measured_scene("body", 1.0), 10.0);
    for (const double time_s : {0.4, 0.5, 4.9, 10.0}) {
        const View view = staged.stage.at(time_s).views.at(0);
        const auto n = static_cast<std::size_t>(std::floor(time_s / 0.5 + 1e-9)) + 1;
        EXPECT_EQ(measured_dots(view).size(), n) << time_s;
        for (const Curve& curve : view.curves)
            if (is_measured(curve.name)) {
                EXPECT_EQ(curve.last, static_cast<double>(n - 1)) << time_s;
            }
    }
}

// A point just below the surface that faces the eye is not hidden by it; one behind the body is.
TEST(MeasuredPoints, AreHiddenByTheBodyOnlyBehindIt) {
    int n_front = 0, n_back = 0;
    for (const double azimuth_deg : {-40.0, 140.0}) {  // from two opposite sides
        Scene scene = measured_scene("body", 0.999, 201);
        scene.panels[0].camera.azimuth_deg = azimuth_deg;
        const StagedScene staged(scene, 10.0);
        const View view = staged.stage.at(10.0).views.at(0);
        const Eigen::Vector3d halves = view.ellipsoids.at(0).half_axes.diagonal();
        for (const Dot& dot : measured_dots(view)) {
            // In lengths in which the ellipsoid is the unit sphere: the line of sight from the dot
            // to the eye.
            const Eigen::Vector3d from = dot.at.cwiseQuotient(halves);
            const Eigen::Vector3d way = (view.camera.eye - dot.at).cwiseQuotient(halves);
            const double b = from.dot(way), c = from.squaredNorm() - 1.0, a = way.squaredNorm();
            const bool is_hidden = b * b - a * c > 0.0 && (-b + std::sqrt(b * b - a * c)) > 0.0;
            // How the surface faces the eye there.
            const double facing = dot.at.cwiseQuotient(halves.cwiseAbs2())
                                      .normalized()
                                      .dot((view.camera.eye - dot.at).normalized());
            if (facing > 0.2) {
                EXPECT_FALSE(is_hidden) << facing;
                ++n_front;
            }
            if (facing < -0.2) {
                EXPECT_TRUE(is_hidden) << facing;
                ++n_back;
            }
        }
    }
    EXPECT_GT(n_front, 10);
    EXPECT_GT(n_back, 10);
}

TEST(MeasuredPoints, OfLongTablesAreThinnedAndNoted) {
    const StagedScene staged(measured_scene("body", 1.0, 1001), 10.0);
    const View view = staged.stage.at(10.0).views.at(0);
    const std::vector<Dot> dots = measured_dots(view);
    EXPECT_LE(dots.size(), 143u);
    EXPECT_GT(dots.size(), 20u);
    // As far apart as two of their widths.
    const double unit_px = staged.stage.panels().front().units_per_px;
    for (std::size_t k = 1; k < dots.size(); ++k)
        EXPECT_GE((dots[k].at - dots[k - 1].at).norm(), 3.9 * dots[k].radius_px * unit_px) << k;
    std::size_t n = 0;
    for (const Curve& curve : view.curves)
        if (is_measured(curve.name)) n += curve.geometry->points.size();
    EXPECT_EQ(n, 1001u);
    const auto notes = staged.stage.store().notes();
    EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
        return note == "of 1001 measured points at most one in 7 has a dot; the line joins all";
    }));
}

// In the plan: |ρ| in the plane, in units of the annulus's outer radius.
TEST(MeasuredPoints, LieOnTheHerpolhodeInThePlan) {
    const StagedScene staged(measured_scene("plan", 1.0), 10.0);
    const View view = staged.stage.at(10.0).views.at(0);
    const Eigen::Vector3d momentum =
        staged.motion.at(0.0).space_from_body *
        (staged.motion.problem().inertia.matrix_body() * staged.motion.problem().start.omega_body);
    double outer = 0.0;
    std::vector<double> radii;
    for (const MeasuredRow& row : staged.scene.measured.motion.rows)
        radii.push_back((row.space_from_body * row.omega_body).cross(momentum.normalized()).norm());
    for (int k = 0; k < 20'000; ++k) {
        const RotationState state = staged.motion.at(0.01 * k);
        outer = std::max(
            outer, (state.space_from_body * state.omega_body).cross(momentum.normalized()).norm());
    }
    const auto dots = measured_dots(view);
    ASSERT_EQ(dots.size(), radii.size());
    for (std::size_t i = 0; i < dots.size(); ++i)
        EXPECT_NEAR(dots[i].at.head<2>().norm(), radii[i] / outer, 1e-5);
}

TEST(MeasuredPoints, NeedATable) {
    Scene scene = free_scene(generic_moments, generic_omega, "space");
    scene.show = {"measured"};
    EXPECT_THROW(StagedScene(scene, 1.0), InputError);
}

}  // namespace
}  // namespace poinsot::panels_tests
