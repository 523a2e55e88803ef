// Outlines and circles on paper, against single points and lines of sight.
#include "vector/conic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "random_views.h"
#include "vector/canvas.h"

namespace poinsot::vector {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

// Distance of a point on paper from a conic of the view: Newton's method on the distance from the
// projected conic.
double distance_um(const Conic& conic, const Projection& projection, const Eigen::Vector2d& at) {
    const auto place = [&](double s) { return projection.place(conic.at(s)); };
    double best = 0.0, least = 1e300;
    for (int k = 0; k < 720; ++k) {
        const double s = two_pi * k / 720.0, d = (place(s) - at).squaredNorm();
        if (d < least) least = d, best = s;
    }
    double low = best - two_pi / 720.0, high = best + two_pi / 720.0;
    for (int k = 0; k < 100; ++k) {
        const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
        ((place(a) - at).squaredNorm() < (place(b) - at).squaredNorm() ? high : low) =
            (place(a) - at).squaredNorm() < (place(b) - at).squaredNorm() ? b : a;
    }
    return um((place(0.5 * (low + high)) - at).norm());
}

TEST(Conic, ProjectsToAnEllipseThroughItsPoints) {
    RandomViews random(1);
    int n_seen = 0;
    for (int k = 0; k < 100; ++k) {
        const View view = random.view(k);
        const Projection projection(view, print_pt_per_px);
        const Conic conic = random.conic();
        const auto picture = picture_of(conic, projection);
        if (!picture) continue;
        ++n_seen;
        for (int i = 0; i < 16; ++i) {
            const Eigen::Vector2d at = projection.place(conic.at(two_pi * i / 16.0));
            EXPECT_NEAR(picture->radius_of(at), 1.0, 1e-9) << "view " << k;
        }
    }
    EXPECT_GT(n_seen, 70);
}

TEST(Conic, IsTheEllipseThroughUnevenPoints) {
    const PaperEllipse ellipse{{412.0, -87.0}, {30.0, 12.0}, {-4.0, 21.0}};
    std::vector<Eigen::Vector2d> points;
    // Crowded on one side, as if seen from a place near the rim.
    for (int k = 0; k < 16; ++k) {
        const double t = two_pi * k / 16.0;
        points.push_back(ellipse.at(t + 0.9 * std::sin(t)));
    }
    const auto found = ellipse_through(points);
    ASSERT_TRUE(found);
    for (int k = 0; k < 32; ++k)
        EXPECT_NEAR(found->radius_of(ellipse.at(two_pi * k / 32.0)), 1.0, 1e-9) << k;
    EXPECT_NEAR((found->centre - ellipse.centre).norm(), 0.0, 1e-8);
}

TEST(Conic, IsNoEllipseThroughOnePointOrALine) {
    EXPECT_FALSE(ellipse_through(std::vector<Eigen::Vector2d>(16, {3.0, 4.0})));
    std::vector<Eigen::Vector2d> line, hyperbola;
    for (int k = -8; k < 8; ++k) {
        line.emplace_back(2.0 * k, 5.0 - 3.0 * k);
        const double t = 0.2 * (k + 0.5);
        hyperbola.emplace_back((k % 2 == 0 ? 1.0 : -1.0) * std::cosh(t), std::sinh(t));
    }
    EXPECT_FALSE(ellipse_through(line));
    EXPECT_FALSE(ellipse_through(hyperbola));
}

TEST(Conic, BeziersStayWithinAMicrometre) {
    RandomViews random(2);
    double worst_um = 0.0;
    std::size_t n_most = 0;
    for (int k = 0; k < 60; ++k) {
        const View view = random.view(k);
        const Projection projection(view, print_pt_per_px);
        const auto limb = limb_of(SphereSight(view.ellipsoids[0], projection));
        const auto picture = limb ? picture_of(*limb, projection) : std::nullopt;
        if (!picture) continue;
        double bound_pt = 0.0;
        const auto beziers = beziers_of(*picture, conic_tolerance_pt, bound_pt);
        n_most = std::max(n_most, beziers.size());
        EXPECT_LE(um(bound_pt), 1.0);
        double worst_here_um = 0.0;
        for (std::size_t i = 0; i < beziers.size(); ++i) {
            EXPECT_LT((beziers[i][3] - beziers[(i + 1) % beziers.size()][0]).norm(), 1e-9);
            // At and near the parameters of an arc's largest radial error.
            for (const double t : {0.1, 0.2, 0.211, 0.3, 0.5, 0.789, 0.9})
                worst_here_um =
                    std::max(worst_here_um, distance_um(*limb, projection, at(beziers[i], t)));
        }
        EXPECT_LE(worst_here_um, um(bound_pt) + 1e-3) << "view " << k;
        worst_um = std::max(worst_um, worst_here_um);
    }
    EXPECT_GT(worst_um, 0.01);  // not more arcs than necessary
    EXPECT_LE(worst_um, 1.0);
    EXPECT_LE(n_most, 24u);
}

// Along the limb, lines of sight are tangent to the ellipsoid: perpendicular to its normal.
TEST(Conic, LimbHasTangentLinesOfSight) {
    RandomViews random(3);
    for (int k = 0; k < 60; ++k) {
        const View view = random.view(k);
        const Projection projection(view, print_pt_per_px);
        const Ellipsoid& ellipsoid = view.ellipsoids[0];
        const auto limb = limb_of(SphereSight(ellipsoid, projection));
        if (!limb) continue;
        const Eigen::Matrix3d to_u = ellipsoid.half_axes.inverse();
        for (int i = 0; i < 12; ++i) {
            const Eigen::Vector3d u = to_u * (limb->at(two_pi * i / 12.0) - ellipsoid.centre);
            EXPECT_NEAR(u.norm(), 1.0, 1e-9);
            const Eigen::Vector3d towards =
                to_u * projection.towards_eye(limb->at(two_pi * i / 12.0));
            EXPECT_NEAR(u.dot(towards) / towards.norm(), 0.0, 1e-9);
        }
    }
}

TEST(Conic, HasNoOutlineFromInside) {
    View view = RandomViews(4).view(1);
    view.ellipsoids[0].centre = view.camera.eye;
    EXPECT_FALSE(limb_of(SphereSight(view.ellipsoids[0], Projection(view, print_pt_per_px))));
}

}  // namespace
}  // namespace poinsot::vector
