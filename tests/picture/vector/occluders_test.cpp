// Visibility against ray casting.
#include "vector/occluders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pinhole.h"
#include "random_views.h"
#include "vector/conic.h"

namespace poinsot::vector::occluders_tests {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

// Two bits: behind or inside the ellipsoid, behind the plane.
int hidden_by_rays(const View& view, const Eigen::Vector3d& point) {
    const testing::Pinhole camera(view);
    return (camera.hides(view.ellipsoids[0], point) ? 1 : 0) +
           (camera.hides(view.planes[0], point) ? 2 : 0);
}

int hidden(const View& view, const Cover& cover) {
    const double ellipsoid = view.ellipsoids[0].opacity;
    const double plane = 0.875;  // of 0.9, in eighths
    for (int bits = 0; bits < 4; ++bits) {
        const double transmitted =
            ((bits & 1) != 0 ? 1.0 - ellipsoid : 1.0) * ((bits & 2) != 0 ? 1.0 - plane : 1.0);
        if (std::abs(cover.transmitted - transmitted) < 1e-9) return bits;
    }
    return -1;
}

// Two hundred views, each with a conic.
template <typename Check>
void in_random_views(Check check) {
    RandomViews random(20261122);
    for (int k = 0; k < 200; ++k) {
        View view = random.view(k);
        Conic conic = random.conic();
        // Every sixth conic nearly touches the ellipsoid's outline from inside.
        const Projection projection(view, print_pt_per_px);
        if (k % 6 == 0) {
            const SphereSight sphere(view.ellipsoids[0], projection);
            if (const auto limb = limb_of(sphere)) {
                conic = *limb;
                conic.cosine_axis *= 1.0 + random.between(-1e-3, 1e-3);
                conic.centre += 0.2 * (view.camera.target - view.camera.eye).normalized();
            }
        }
        if (Occluders(view, projection).spheres()[0].surrounds_eye) continue;
        check(k, view, projection, track_of(conic, 0.0, two_pi), random);
    }
}

TEST(Occluders, AgreeWithRaysAtTenThousandRandomPoints) {
    int n_points = 0, n_hidden = 0, n_beside_breaks = 0;
    in_random_views([&](int k, const View& view, const Projection& projection, const Track& track,
                        RandomViews& random) {
        const std::vector<Span> spans = Occluders(view, projection).spans(track, {});
        for (int i = 0; i < 60; ++i) {
            const double s = random.between(0.0, two_pi);
            const Eigen::Vector3d point = track.flow(s).position;
            if (projection.perspective && projection.depth(point) <= 1.01 * projection.near_depth)
                continue;
            const auto span = std::find_if(spans.begin(), spans.end(),
                                           [s](const Span& x) { return x.from <= s && s <= x.to; });
            ASSERT_NE(span, spans.end()) << "view " << k << " at " << s;
            ++n_points;
            const int truth = hidden_by_rays(view, point);
            n_hidden += truth != 0 ? 1 : 0;
            if (hidden(view, span->cover) == truth) continue;
            const Eigen::Vector2d here = projection.place(point);
            const double from_break =
                std::min((projection.place(track.flow(span->from).position) - here).norm(),
                         (projection.place(track.flow(span->to).position) - here).norm());
            ++n_beside_breaks;
            EXPECT_LT(um(from_break), 3.0) << "view " << k << " at " << s;
        }
    });
    EXPECT_GT(n_points, 10'000);
    EXPECT_GT(n_hidden, 2'000);
    EXPECT_LT(n_points - n_hidden, n_points);
    EXPECT_LT(n_beside_breaks, 5);
}

TEST(Occluders, BreaksAgreeWithBisection) {
    int n_breaks = 0;
    double worst_um = 0.0;
    in_random_views([&](int n, const View& view, const Projection& projection, const Track& track,
                        RandomViews&) {
        const std::vector<Span> spans = Occluders(view, projection).spans(track, {});
        for (std::size_t k = 1; k < spans.size(); ++k) {
            if (spans[k].from != spans[k - 1].to) continue;  // a gap behind the eye
            const double at = spans[k].from;
            double low = 0.5 * (spans[k - 1].from + at), high = 0.5 * (at + spans[k].to);
            const int before = hidden_by_rays(view, track.flow(low).position);
            if (before == hidden_by_rays(view, track.flow(high).position)) {
                // A grazing contact that rays and roots separate only by rounding.
                const auto length_um = [&](const Span& span) {
                    return um((projection.place(track.flow(span.to).position) -
                               projection.place(track.flow(span.from).position))
                                  .norm());
                };
                EXPECT_LT(std::min(length_um(spans[k - 1]), length_um(spans[k])), 3.0)
                    << "view " << n << " at " << at;
                continue;
            }
            for (int i = 0; i < 80; ++i) {
                const double middle = 0.5 * (low + high);
                (hidden_by_rays(view, track.flow(middle).position) == before ? low : high) = middle;
            }
            ++n_breaks;
            const double off_um = um((projection.place(track.flow(low).position) -
                                      projection.place(track.flow(at).position))
                                         .norm());
            worst_um = std::max(worst_um, off_um);
        }
    });
    EXPECT_GT(n_breaks, 300);
    EXPECT_LT(worst_um, 3.0) << n_breaks << " breaks";
    RecordProperty("worst_um", std::to_string(worst_um));
}

TEST(Occluders, CurveOnTheSurfaceIsHiddenOnTheFarSide) {
    RandomViews random(7);
    for (int k = 0; k < 50; ++k) {
        const View view = random.view(k);
        const Projection projection(view, print_pt_per_px);
        const Occluders occluders(view, projection);
        if (occluders.spheres()[0].surrounds_eye) continue;
        const Ellipsoid& ellipsoid = view.ellipsoids[0];
        const Conic equator{ellipsoid.centre, ellipsoid.half_axes.col(0),
                            ellipsoid.half_axes.col(1)};
        const Eigen::Matrix3d to_u = ellipsoid.half_axes.inverse();
        for (const Span& span : occluders.spans(track_of(equator, 0.0, two_pi), {0, 0})) {
            const Eigen::Vector3d at = equator.at(0.5 * (span.from + span.to));
            // The gradient of |u|² is the outward normal.
            const Eigen::Vector3d normal = to_u.transpose() * (to_u * (at - ellipsoid.centre));
            EXPECT_EQ(span.cover.clear == 1.0, normal.dot(projection.towards_eye(at)) > 0.0) << k;
        }
    }
}

TEST(Occluders, FadingSolidsHideLess) {
    RandomViews random(3);
    View view = random.view(1);
    view.planes.clear();
    const Eigen::Vector3d inside = view.ellipsoids[0].centre;
    for (const double presence : {1.0, 0.2, 0.1, 0.0}) {
        view.ellipsoids[0].presence = presence;
        const Projection projection(view, print_pt_per_px);
        const Cover cover = Occluders(view, projection).at(inside, {});
        const double hiding = presence * view.ellipsoids[0].opacity;
        EXPECT_NEAR(cover.transmitted, 1.0 - hiding, 1e-12);
        EXPECT_NEAR(cover.clear, 1.0 - std::min(1.0, 4.0 * hiding), 1e-12);
    }
}

// A sphere and a spheroid about a common axis meet in circles of latitude. Such a circle with an
// oscillating error of 1e-7 of its radius, as fitted curves have, lies on both surfaces and is
// visible in one piece.
TEST(Occluders, IntersectionCurveIsHiddenByNeitherSurface) {
    View view;
    view.width_px = 1000;
    view.height_px = 750;
    view.camera.eye = {3.0, -4.0, 2.5};
    view.camera.target = {0.0, 0.0, 0.0};
    view.ellipsoids.resize(2);
    view.ellipsoids[1].half_axes = Eigen::Vector3d(1.2, 1.2, 0.8).asDiagonal();
    // ρ² + z² = 1 = ρ²/1.44 + z²/0.64.
    const double z_square = (1.0 - 1.0 / 1.44) / (1.0 / 0.64 - 1.0 / 1.44);
    const double z = std::sqrt(z_square), radius = std::sqrt(1.0 - z_square);
    const Projection projection(view, 0.24);
    const Occluders occluders(view, projection);
    Track track;
    for (int k = 0; k <= 16; ++k) track.knots.push_back(2.0 * std::numbers::pi * k / 16);
    track.flow = [=](double s) {
        const double r = radius * (1.0 + 1e-7 * std::sin(101.0 * s));
        return CurveFlow{{r * std::cos(s), r * std::sin(s), z},
                         {-r * std::sin(s), r * std::cos(s), 0.0}};
    };
    const std::vector<Span> spans = occluders.spans(track, {0, -1});
    EXPECT_LE(spans.size(), 5u);  // hidden behind each limb once, and where the curve begins
    double seen = 0.0;
    for (const Span& span : spans)
        if (span.cover.clear > 0.5) seen += span.to - span.from;
    // The eye is above both: the circle is visible where neither surface turns away, by the limbs'
    // planes.
    double expected = 0.0;
    constexpr int n = 100'000;
    for (int k = 0; k < n; ++k) {
        const double s = 2.0 * std::numbers::pi * (k + 0.5) / n;
        const Eigen::Vector3d at(radius * std::cos(s), radius * std::sin(s), z);
        const Eigen::Vector3d eye = view.camera.eye;
        const double first = at.dot(eye) - 1.0;
        const double second =
            (at.x() * eye.x() + at.y() * eye.y()) / 1.44 + at.z() * eye.z() / 0.64 - 1.0;
        if (first > 0.0 && second > 0.0) expected += 2.0 * std::numbers::pi / n;
    }
    EXPECT_NEAR(seen, expected, 1e-3);
}

TEST(Occluders, ClearSphereMayHideTheFarPartsOfItsCurves) {
    View view = RandomViews(1).view(1);
    view.planes.clear();
    view.ellipsoids[0] = Ellipsoid{};
    view.ellipsoids[0].opacity = 0.1;
    view.camera.target = Eigen::Vector3d::Zero();
    view.camera.eye = {0.0, 0.0, 6.0};
    const Projection projection(view, print_pt_per_px);
    const auto cover = [&](const Eigen::Vector3d& at, int ellipsoid) {
        return Occluders(view, projection).at(at, {.ellipsoid = ellipsoid, .lies_on = {}});
    };
    const Eigen::Vector3d far(0.6, 0.0, -0.8), near(0.6, 0.0, 0.8), inside(0.2, 0.0, -0.2);
    const Cover usual = cover(far, 0), inner = cover(inside, -1);
    EXPECT_DOUBLE_EQ(usual.transmitted, 0.9);
    view.ellipsoids[0].hides_far_curves = true;
    EXPECT_EQ(cover(far, 0).before_bodies, 0.0);
    EXPECT_EQ(cover(far, 0).transmitted, 0.0);
    // Its near curves, and what lies inside it, are as before.
    EXPECT_EQ(cover(near, 0).clear, 1.0);
    EXPECT_EQ(cover(inside, -1), inner);
}

}  // namespace
}  // namespace poinsot::vector::occluders_tests
