// Smooth forms of curves, compared with the exact curves: the polhode as the intersection of two
// quadrics, and the motion at every instant.
#include "drawing/stage/smooth_paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "drawing/figures/elements/trail.h"
#include "scenes_by_hand.h"

namespace poinsot {
namespace {

struct Body {
    Eigen::Vector3d moments;
    Eigen::Vector3d omega;
};

// Generic polhodes about both outer axes, a small one, two near the separatrix, and the separatrix.
const std::vector<Body> bodies{
    {{1.0, 2.0, 3.0}, {0.2, 0.3, 1.0}},         {{1.0, 2.0, 3.0}, {1.0, 0.3, 0.2}},
    {{1.0, 2.0, 2.5}, {1e-3, 2e-3, 1.0}},       {{1.0, 2.0, 3.0}, {1.7320, 1.0, 1.0}},
    {{1.0, 2.0, 3.0}, {1.73205080, 1e-3, 1.0}}, {{3.0, 6.0, 8.0}, {4.0, 1.0, 3.0}},
};

SmoothForm smooth_of(const Polhode& polhode, const Eigen::Affine3d& map, double tolerance) {
    return placed(smooth_polhode(polhode, 1e-3), map)(tolerance);
}

TEST(SmoothPolhode, IsWithinItsErrorBoundOfTheExactPolhode) {
    Eigen::Affine3d map(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 2) / 3.0));
    map.linear() *= 1.7;
    map.translation() = Eigen::Vector3d(0.1, 0.2, -0.3);
    for (const Body& body : bodies) {
        const Polhode polhode(InertiaTensor::from_principal_moments(body.moments), body.omega);
        for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
            const SmoothForm smooth = smooth_of(polhode, map, tolerance);
            EXPECT_LE(smooth.off, tolerance) << body.omega.transpose();
            double worst = 0.0;
            constexpr int n = 40'000;
            for (int k = 0; k <= n; ++k) {
                const double chi =
                    polhode.first_chi_rad() +
                    (polhode.last_chi_rad() - polhode.first_chi_rad()) * k / double{n};
                worst = std::max(worst, (smooth.at(chi) - map * polhode.at(chi)).norm());
            }
            // Rounding of points of order one.
            EXPECT_LE(worst, smooth.off + 2e-15) << body.omega.transpose() << " to " << tolerance;
        }
    }
}

// 2T and L² are those of the start all along: F(ρ) = ρᵀJρ = 1 and |Jρ|² = L²/2T.
TEST(SmoothPolhode, LiesOnTheEllipsoidAndOnTheSphereOfL) {
    const Eigen::Affine3d as_it_is = Eigen::Affine3d::Identity();
    for (const Body& body : bodies) {
        const Polhode polhode(InertiaTensor::from_principal_moments(body.moments), body.omega);
        const SmoothForm smooth = smooth_of(polhode, as_it_is, 1e-7);
        const Eigen::Vector3d momentum = body.moments.cwiseProduct(body.omega);
        const double wanted = momentum.squaredNorm() / momentum.dot(body.omega);
        for (int k = 0; k <= 1000; ++k) {
            const double chi = polhode.first_chi_rad() +
                               (polhode.last_chi_rad() - polhode.first_chi_rad()) * k / 1000.0;
            const Eigen::Vector3d rho = smooth.at(chi);
            const Eigen::Vector3d m = body.moments.cwiseProduct(rho);
            // The gradients 2Jρ and 2J²ρ convert a distance to a residual.
            EXPECT_NEAR(rho.dot(m), 1.0, 2.0 * m.norm() * smooth.off + 1e-14);
            EXPECT_NEAR(m.squaredNorm(), wanted,
                        2.0 * body.moments.cwiseProduct(m).norm() * smooth.off + 4e-14);
        }
    }
}

// A cubic replaces several points of an equally accurate polyline.
TEST(SmoothPolhode, HasFewerPiecesThanPoints) {
    const Polhode polhode(InertiaTensor::from_principal_moments({1.0, 2.0, 3.0}), {0.2, 0.3, 1.0});
    const SmoothForm smooth = smooth_of(polhode, Eigen::Affine3d::Identity(), 1e-6);
    const std::size_t n_pieces = std::get<std::vector<CubicPiece>>(smooth.form).size();
    EXPECT_LT(4 * n_pieces, polhode.samples(1e-6).samples.size());
}

TEST(SmoothPolhode, OfASymmetricBodyIsAConic) {
    const Polhode polhode(InertiaTensor::from_principal_moments({1.0, 1.0, 2.0}), {0.3, 0.4, 1.0});
    const SmoothForm smooth = smooth_of(polhode, Eigen::Affine3d::Identity(), 1e-9);
    ASSERT_TRUE(std::holds_alternative<Conic>(smooth.form));
    EXPECT_EQ(smooth.off, 0.0);
    for (const double chi : {-3.0, -1.0, 0.0, 0.4, 2.0})
        EXPECT_LT((smooth.at(chi) - polhode.at(chi)).norm(), 4e-16);
}

// Every point of the geometry agrees with its parameter, and a closed curve's end is its start.
TEST(SmoothPolhode, HasTheParametersOfItsPoints) {
    const Polhode polhode(InertiaTensor::from_principal_moments({1.0, 2.0, 3.0}), {0.2, 0.3, 1.0});
    const auto points = polhode.sampled(1e-3);
    const SmoothForm smooth = smooth_of(polhode, Eigen::Affine3d::Identity(), 1e-9);
    ASSERT_EQ(smooth.parameters.size(), points.size() + 1);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_LE((smooth.at(smooth.parameter_at(static_cast<double>(i))) - points[i]).norm(),
                  smooth.off + 4e-16);
    EXPECT_LT((smooth.at(smooth.parameters.back()) - points.front()).norm(), 1e-15);
}

TEST(SmoothCircle, IsTheCircleOfItsPoints) {
    const SmoothForm smooth = smooth_circle({0.0, 0.0, -0.7}, 2.0, 256)(1e-9);
    EXPECT_EQ(smooth.parameters.size(), 257u);
    const Eigen::Vector3d at = smooth.at(smooth.parameter_at(64.0));
    EXPECT_LT((at - Eigen::Vector3d(0.0, 2.0, -0.7)).norm(), 1e-15);
}

// For the geometry of all panels: each point agrees with its parameter.
TEST(SmoothForms, OfAllPanelsPassThroughTheirPoints) {
    int n_smooth = 0;
    for (const std::string panel : {"space", "body", "plan", "momentum"}) {
        for (const std::string trail : {"whole", "history", "fading"}) {
            for (const std::string camera : {"fixed", "co-precessing"}) {
                Scene scene = free_scene({1.0, 2.0, 2.9}, {0.4, 0.3, 1.1}, panel);
                scene.trail.polhode = scene.trail.herpolhode = trail;
                scene.camera.motion = panel == "space" || panel == "plan" ? camera : "fixed";
                const StagedScene staged(scene, 4.0);
                for (const CurveGeometry& curve : staged.stage.store().curves()) {
                    if (!curve.smooth) continue;
                    ++n_smooth;
                    const SmoothForm smooth = curve.smooth(1e-7);
                    EXPECT_LE(smooth.off, 1e-7);
                    ASSERT_EQ(smooth.parameters.size(),
                              curve.points.size() + (curve.closed ? 1 : 0));
                    double worst = 0.0;
                    for (std::size_t i = 0; i < curve.points.size(); ++i)
                        worst = std::max(
                            worst, (smooth.at(smooth.parameters[i]) - curve.points[i]).norm());
                    EXPECT_LE(worst, smooth.off + 1e-14) << panel << " " << trail << " " << camera;
                }
            }
        }
    }
    EXPECT_GT(n_smooth, 40);
}

// The herpolhode's cubics, also between its points, compared with the motion itself.
TEST(SmoothForms, OfTheHerpolhodeFollowTheContactPoint) {
    const Scene scene = free_scene({1.0, 2.0, 2.9}, {0.4, 0.3, 1.1}, "space");
    const StagedScene staged(scene, 4.0);
    const StageContext& stage = staged.stage.context();
    const TimedCurve timed = herpolhode_trail(stage, 1e-3);
    for (const double tolerance : {1e-4, 1e-8}) {
        const SmoothForm smooth = timed.smooth(tolerance);
        EXPECT_LE(smooth.off, tolerance);
        double worst = 0.0;
        for (int k = 0; k <= 5000; ++k) {
            const double time_s = 4.0 * k / 5000.0;
            const MotionSample sample = staged.motion.sample(
                time_s, {.attitude = false, .herpolhode = true, .euler_angles = false});
            const Eigen::Vector3d exact =
                stage.rolling->construction.contact_in_plane(sample.herpolhode_space);
            worst = std::max(worst, (smooth.at(time_s) - exact).norm());
        }
        EXPECT_LE(worst, smooth.off + 1e-14);
    }
}

// A stepped motion has no exact tangents, only points.
TEST(SmoothForms, DoNotExistForSteppedMotions) {
    Scene scene = free_scene({1.0, 2.0, 2.9}, {0.4, 0.3, 1.1}, "space");
    scene.method.name = "rk4";
    scene.method.step_s = 0.01;
    const StagedScene staged(scene, 4.0);
    EXPECT_FALSE(herpolhode_trail(staged.stage.context(), 1e-3).smooth);
    EXPECT_FALSE(polhode_trail(staged.stage.context(), 1e-3).smooth);
}

}  // namespace
}  // namespace poinsot
