// Visibility of polhodes, herpolhodes and bodies of triangles, against ray casting.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "pinhole.h"
#include "random_views.h"
#include "vector/conic.h"
#include "vector/occluders.h"

namespace poinsot::vector::curves_tests {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

// The polhode of semi-axes a < b < c through a sphere of momentum: on the ellipsoid Σ x²/a² = 1 and
// Σ x²/a⁴ = h with 1/b² < h; it encircles the axis of a.
Track polhode(const Eigen::Matrix3d& axes, double share) {
    const Eigen::Vector3d square = axes.colwise().squaredNorm();
    Eigen::Index small = 0, large = 0;
    square.minCoeff(&small);
    square.maxCoeff(&large);
    const Eigen::Index middle = 3 - small - large;
    const double a = 1.0 / square[small], b = 1.0 / square[middle], c = 1.0 / square[large];
    const double h = b + share * (a - b);
    // With u = x/axis: Σ u² = 1 and a·u₁² + b·u₂² + c·u₃² = h.
    const double widest = std::sqrt((a - h) / (a - b)), far = std::sqrt((a - h) / (a - c));
    Track track;
    track.flow = [=](double s) {
        const double u2 = widest * std::cos(s), u3 = far * std::sin(s);
        const double u1 = std::sqrt(std::max(1.0 - u2 * u2 - u3 * u3, 0.0));
        const double v2 = -widest * std::sin(s), v3 = far * std::cos(s);
        const double v1 = -(u2 * v2 + u3 * v3) / std::max(u1, 1e-12);
        const auto at = [&](double x1, double x2, double x3) -> Eigen::Vector3d {
            return x1 * axes.col(small) + x2 * axes.col(middle) + x3 * axes.col(large);
        };
        return CurveFlow{at(u1, u2, u3), at(v1, v2, v3)};
    };
    for (int k = 0; k <= 8; ++k) track.knots.push_back(two_pi * k / 8.0);
    return track;
}

// A rosette on a plane.
Track herpolhode(const Plane& plane, double radius, double swing, double waves) {
    const Eigen::Vector3d across = plane.normal.cross(plane.along);
    Track track;
    track.flow = [=](double s) {
        const double r = radius + swing * std::cos(waves * s);
        const double dr = -swing * waves * std::sin(waves * s);
        const Eigen::Vector3d out = std::cos(s) * plane.along + std::sin(s) * across;
        const Eigen::Vector3d round = std::cos(s) * across - std::sin(s) * plane.along;
        return CurveFlow{plane.centre + r * out, dr * out + r * round};
    };
    for (int k = 0; k <= 24; ++k) track.knots.push_back(2.0 * two_pi * k / 24.0);
    return track;
}

struct Held {
    int n_points = 0, n_hidden = 0, n_beside = 0;
    double worst_um = 0.0;
};

// At random points of a track: the distance to a break if spans and rays disagree.
template <typename Hidden>
void hold(const View& view, const Track& track, const Membership& of, Hidden hidden, int n,
          RandomViews& random, Held& held) {
    const Projection projection(view, print_pt_per_px);
    const Occluders occluders(view, projection);
    if (!occluders.spheres().empty() && occluders.spheres()[0].surrounds_eye) return;
    const std::vector<Span> spans = occluders.spans(track, of);
    for (int i = 0; i < n; ++i) {
        const double s = random.between(track.knots.front(), track.knots.back());
        const Eigen::Vector3d point = track.flow(s).position;
        if (projection.perspective && projection.depth(point) <= 1.01 * projection.near_depth)
            continue;
        const auto span = std::find_if(spans.begin(), spans.end(),
                                       [s](const Span& x) { return x.from <= s && s <= x.to; });
        ASSERT_NE(span, spans.end()) << s;
        ++held.n_points;
        const bool truth = hidden(point);
        held.n_hidden += truth ? 1 : 0;
        if ((span->cover.clear < 0.5) == truth) continue;
        ++held.n_beside;
        const Eigen::Vector2d here = projection.place(point);
        const double off =
            std::min((projection.place(track.flow(span->from).position) - here).norm(),
                     (projection.place(track.flow(span->to).position) - here).norm());
        held.worst_um = std::max(held.worst_um, um(off));
    }
}

TEST(CurvesOnSurfaces, PolhodeVisibilityAgreesWithRayCasting) {
    RandomViews random(17);
    Held held;
    for (int k = 0; k < 200; ++k) {
        View view = random.view(k);
        view.ellipsoids[0].opacity = 1.0;
        view.planes[0].opacity = 1.0;
        // Wide and narrow polhodes, some near the separatrix.
        const Track track = [&] {
            Track made = polhode(view.ellipsoids[0].half_axes,
                                 k % 10 == 0 ? 1e-4 : random.between(0.01, 0.99));
            const Eigen::Vector3d centre = view.ellipsoids[0].centre;
            made.flow = [flow = std::move(made.flow), centre](double s) {
                CurveFlow at = flow(s);
                at.position += centre;
                return at;
            };
            return made;
        }();
        // In every ninth view the eye lies in the plane.
        if (k % 9 == 0 && !view.camera.orthographic)
            view.planes[0].centre = view.camera.eye + 0.3 * view.planes[0].along;
        const testing::Pinhole camera(view);
        const auto hidden = [&](const Eigen::Vector3d& point) {
            return camera.turns_away(view.ellipsoids[0], point) ||
                   camera.hides(view.planes[0], point);
        };
        hold(view, track, {0, -1}, hidden, 60, random, held);
    }
    EXPECT_GT(held.n_points, 8'000);
    EXPECT_GT(held.n_hidden, 2'000);
    EXPECT_LT(held.worst_um, 3.0) << held.n_beside << " of " << held.n_points;
    RecordProperty("worst_um", std::to_string(held.worst_um));
}

TEST(CurvesOnSurfaces, HerpolhodeVisibilityAgreesWithRayCasting) {
    RandomViews random(18);
    Held held;
    for (int k = 0; k < 200; ++k) {
        View view = random.view(k);
        view.ellipsoids[0].opacity = 1.0;
        view.planes[0].opacity = 1.0;
        const Plane on = view.planes[0];
        // In every fifth view the waves nearly end in cusps.
        const double waves = 5.0, radius = random.between(0.2, 1.2);
        const double swing =
            k % 5 == 0 ? radius / (1.0 + waves) : random.between(0.0, 0.4) * radius;
        const Track track = herpolhode(on, radius, swing, waves);
        const testing::Pinhole camera(view);
        const auto hidden = [&](const Eigen::Vector3d& point) {
            return camera.hides(view.ellipsoids[0], point);
        };
        hold(view, track, {-1, 0}, hidden, 60, random, held);
    }
    EXPECT_GT(held.n_points, 8'000);
    EXPECT_GT(held.n_hidden, 800);
    EXPECT_LT(held.worst_um, 3.0) << held.n_beside << " of " << held.n_points;
    RecordProperty("worst_um", std::to_string(held.worst_um));
}

// An irregular closed body.
MeshGeometry lump(RandomViews& random) {
    constexpr int n_rings = 8, n_spokes = 12;
    std::vector<std::vector<Eigen::Vector3f>> rings;
    for (int i = 0; i <= n_rings; ++i) {
        auto& ring = rings.emplace_back();
        const double latitude = std::numbers::pi * i / n_rings;
        for (int j = 0; j < n_spokes; ++j) {
            const double longitude = two_pi * j / n_spokes;
            const double r = i == 0 || i == n_rings ? 0.6 : random.between(0.45, 0.75);
            ring.emplace_back(
                (r * Eigen::Vector3d(std::sin(latitude) * std::cos(longitude),
                                     std::sin(latitude) * std::sin(longitude), std::cos(latitude)))
                    .cast<float>());
        }
    }
    MeshGeometry mesh;
    const auto at = [](int k) { return static_cast<std::size_t>(k); };
    for (int i = 0; i < n_rings; ++i)
        for (int j = 0; j < n_spokes; ++j) {
            const auto& a = rings[at(i)][at(j)];
            const auto& b = rings[at(i + 1)][at(j)];
            const auto& c = rings[at(i + 1)][at((j + 1) % n_spokes)];
            const auto& d = rings[at(i)][at((j + 1) % n_spokes)];
            for (const auto& corner : {a, b, c, a, c, d}) mesh.positions.push_back(corner);
        }
    return mesh;
}

TEST(CurvesOnSurfaces, MeshVisibilityAgreesWithRayCasting) {
    RandomViews random(19);
    Held held;
    for (int k = 0; k < 400; ++k) {
        View view = random.view(k);
        view.ellipsoids.clear();
        view.planes.clear();
        const MeshGeometry body = lump(random);
        Mesh& mesh = view.meshes.emplace_back();
        mesh.geometry = &body;
        const Conic conic = random.conic();
        const testing::Pinhole camera(view);
        const auto hidden = [&](const Eigen::Vector3d& point) { return camera.hides(mesh, point); };
        hold(view, track_of(conic, 0.0, two_pi), {}, hidden, 60, random, held);
    }
    EXPECT_GT(held.n_points, 16'000);
    EXPECT_GT(held.n_hidden, 2'000);
    EXPECT_LT(held.worst_um, 3.0) << held.n_beside << " of " << held.n_points;
}

}  // namespace
}  // namespace poinsot::vector::curves_tests
