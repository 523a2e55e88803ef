// The body panel: polhodes, separatrices and arrows on the ellipsoid.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "panels_by_hand.h"
#include "scenes_by_hand.h"

namespace poinsot::panels_tests {
namespace {

TEST(BodyPanel, CurvesLieOnTheEllipsoid) {
    const StagedScene staged(free_scene(generic_moments, generic_omega, "body"), 10.0);
    const Drawing drawing = staged.stage.at(2.0);
    const Eigen::Matrix3d to_u = view_of(drawing).ellipsoids[0].half_axes.inverse();
    std::size_t n = 0;
    for (const Curve& curve : view_of(drawing).curves) {
        EXPECT_EQ(curve.on_surface, 0);
        for (const Eigen::Vector3d& point : drawn_points(curve)) {
            EXPECT_NEAR((to_u * point).norm(), 1.0, 1e-14);  // measured 7e-16
            ++n;
        }
    }
    EXPECT_GT(n, 1000u);
}

TEST(BodyPanel, OmegaIsOnTheBoldPolhodeAndMomentumIsNormal) {
    const StagedScene staged(free_scene(generic_moments, generic_omega, "body"), 10.0);
    for (int k = 0; k <= 20; ++k) {
        const Drawing drawing = staged.stage.at(0.5 * k);
        const View& view = view_of(drawing);
        // The widest nearby curve: the dot of ω is on it, within the tolerance.
        double nearest = 1e300;
        for (const Curve& curve : view.curves) {
            if (curve.width_px < 4.0 * 360.0 / 1080.0) continue;
            const auto points = drawn_points(curve);
            for (std::size_t i = 0; i + 1 < points.size(); ++i) {
                const Eigen::Vector3d along = points[i + 1] - points[i];
                const double s = std::clamp(
                    (view.dots[0].at - points[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
                nearest = std::min(nearest, (view.dots[0].at - points[i] - s * along).norm());
            }
        }
        EXPECT_LT(nearest, 2e-4);  // a tenth of a pixel at 360 rows; measured 1.0e-4

        // Arrows: e1, e2, e3, L, ω. L is normal to the ellipsoid there, ω passes through the dot.
        const Eigen::Matrix3d axes = view.ellipsoids[0].half_axes;
        const Eigen::Vector3d normal = (axes * axes).inverse() * view.dots[0].at;
        EXPECT_LT(normal.normalized().cross(view.arrows[3].tip.normalized()).norm(), 1e-14);
        EXPECT_LT(view.dots[0].at.normalized().cross(view.arrows[4].tip.normalized()).norm(),
                  1e-14);
    }
}

// Each thin polhode has the colour of the axis that it encircles: its points have no zero of this
// component, and zeros of both others.
TEST(BodyPanel, FamiliesHaveTheColoursOfTheirAxes) {
    const StagedScene staged(free_scene(generic_moments, generic_omega, "body"), 10.0);
    const Drawing drawing = staged.stage.at(2.0);
    const Theme& theme = staged.stage.context().theme;
    const Eigen::Matrix3d axes = view_of(drawing).ellipsoids[0].half_axes;
    std::array<int, 3> n{};
    for (const Curve& curve : view_of(drawing).curves) {
        for (int i = 0; i < 3; ++i) {
            if (!(curve.colour == Colour(theme.axes[i]))) continue;
            ++n[static_cast<std::size_t>(i)];
            Eigen::Vector3d least = Eigen::Vector3d::Constant(1e300), most = -least;
            for (const Eigen::Vector3d& point : drawn_points(curve)) {
                const Eigen::Vector3d u = axes.inverse() * point;
                least = least.cwiseMin(u);
                most = most.cwiseMax(u);
            }
            for (int j = 0; j < 3; ++j)
                EXPECT_EQ(least[j] * most[j] > 0.0, j == i) << i << " " << j;
        }
    }
    // Largest and smallest moment; no polhode encircles the axis of the middle one.
    int middle = 0;
    for (int i = 1; i < 3; ++i)
        if ((generic_moments[i] - generic_moments.minCoeff()) *
                (generic_moments[i] - generic_moments.maxCoeff()) !=
            0.0)
            middle = i;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(n[static_cast<std::size_t>(i)] > 3, i != middle) << i;
}

TEST(BodyPanel, SymmetricBodiesHaveNoSeparatrix) {
    const auto n_dashed = [](const StagedScene& staged) {
        int n = 0;
        const Drawing drawing = staged.stage.at(0.0);
        for (const Curve& curve : view_of(drawing).curves) n += curve.dash_px > 0.0 ? 1 : 0;
        return n;
    };
    EXPECT_EQ(n_dashed({free_scene({2.0, 2.0, 3.0}, {0.5, 0.3, 1.0}, "body"), 1.0}), 0);
    EXPECT_EQ(n_dashed({free_scene(generic_moments, generic_omega, "body"), 1.0}), 2);
}

}  // namespace
}  // namespace poinsot::panels_tests
