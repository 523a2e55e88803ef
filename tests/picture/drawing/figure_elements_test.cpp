// The elements that explain the construction have the positions of their definitions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "construction/montgomery_phase.h"
#include "drawing/figures/charts/plot_frame.h"
#include "drawing/figures/charts/plot_quantity.h"
#include "drawing/figures/elements/elements.h"
#include "drawing/stage/live_values.h"
#include "drawing/stage/panel.h"
#include "error/error.h"
#include "mechanics/solids.h"
#include "refusal.h"
#include "scenes_by_hand.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot::figure_elements_tests {
namespace {

const Eigen::Vector3d moments{1.0, 1.8, 2.6};
const Eigen::Vector3d omega{1.3, 0.9, 0.8};

// A scene that shows only these elements, without title, caption or clock.
Scene showing(const std::vector<std::string>& show) {
    Scene scene = free_scene(moments, omega, "space");
    scene.show = show;
    return scene;
}

// F(ρ) = ρ·Iρ of a point in picture lengths, in which the largest half-axis 1/√I_min is 1.
double form(const Eigen::Matrix3d& axes, const Eigen::Vector3d& point) {
    return moments.dot((axes.transpose() * point).cwiseAbs2()) / moments.minCoeff();
}

TEST(FigureElements, RadiusEndsOnTheEllipsoidAndGradientIsAlongL) {
    const StagedScene staged(showing({"ellipsoid", "radius", "gradient", "tangent", "axes"}), 10.0);
    for (const double t : {0.0, 2.7, 9.1}) {
        const View view = staged.stage.at(t).views.front();
        ASSERT_EQ(view.arrows.size(), 5u);
        Eigen::Matrix3d axes;
        for (int i = 0; i < 3; ++i) {
            axes.col(i) = view.arrows[static_cast<std::size_t>(i)].tip.normalized();
        }
        const Eigen::Vector3d rho = view.arrows[3].tip;
        EXPECT_NEAR(form(axes, rho), 1.0, 1e-14);
        // ∇F = 2Iρ starts at ρ and is along L, which points down.
        const Arrow& gradient = view.arrows[4];
        EXPECT_EQ(gradient.tail, rho);
        const Eigen::Vector3d along = (gradient.tip - gradient.tail).normalized();
        const Eigen::Vector3d expected =
            (axes * moments.cwiseProduct(axes.transpose() * rho)).normalized();
        EXPECT_LT((along - expected).norm(), 1e-14);  // measured 5e-16
        EXPECT_LT((along + Eigen::Vector3d::UnitZ()).norm(), 1e-14);
        EXPECT_EQ(view.planes.front().centre, rho);
        EXPECT_EQ(view.planes.front().normal, Eigen::Vector3d::UnitZ());
    }
}

// The tangent patch follows the contact; the herpolhode's plane is fixed, in any order of the
// elements.
TEST(FigureElements, HerpolhodeIsOnTheFixedPlane) {
    for (const std::vector<std::string>& show :
         {std::vector<std::string>{"tangent", "herpolhode", "plane"},
          std::vector<std::string>{"plane", "tangent", "herpolhode"}}) {
        const StagedScene staged(showing(show), 10.0);
        std::vector<Eigen::Vector3d> centres;
        for (const double t : {2.7, 9.1}) {
            const View view = staged.stage.at(t).views.front();
            ASSERT_EQ(view.planes.size(), 2u);
            ASSERT_EQ(view.curves.size(), 2u);  // the herpolhode and its edge
            ASSERT_GE(view.curves.front().on_plane, 0);
            centres.push_back(
                view.planes.at(static_cast<std::size_t>(view.curves.front().on_plane)).centre);
        }
        EXPECT_EQ(centres.front(), centres.back());
    }
}

// A renderer caches uploaded curves and masks by these ids.
TEST(FigureElements, IdsAreUniqueAcrossStages) {
    std::set<std::uint64_t> masks, geometry;
    std::set<const GlyphMask*> seen_masks;
    std::set<const CurveGeometry*> seen_geometry;
    std::deque<StagedScene> stages;
    for (int k = 0; k < 3; ++k) {
        const Drawing drawing =
            stages.emplace_back(showing({"ellipsoid", "polhode", "herpolhode", "axes"}), 10.0)
                .stage.at(1.0 + k);
        for (const View& view : drawing.views) {
            for (const Label& label : view.labels) {
                if (!seen_masks.insert(label.mask).second) continue;
                EXPECT_TRUE(masks.insert(label.mask->id).second);
            }
            for (const Curve& curve : view.curves) {
                if (!seen_geometry.insert(curve.geometry).second) continue;
                EXPECT_TRUE(geometry.insert(curve.geometry->id).second);
            }
        }
    }
    EXPECT_GE(masks.size(), 9u);
    EXPECT_GE(geometry.size(), 6u);
    for (const std::uint64_t number : masks) EXPECT_FALSE(geometry.contains(number));
}

TEST(FigureElements, HalfAxesHaveTheirLengths) {
    const StagedScene staged(showing({"ellipsoid", "half-axes"}), 10.0);
    const View view = staged.stage.at(3.3).views.front();
    ASSERT_EQ(view.dots.size(), 3u);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(view.dots[static_cast<std::size_t>(i)].at.norm(),
                    std::sqrt(moments.minCoeff() / moments[i]), 1e-15);
    }
}

// n takes all directions from the film's beginning until the element fades out; ρ = n/√I(n) is the
// end of its trace, and the number beside it is I(n).
TEST(FigureElements, DirectionTracesTheEllipsoidUntilItFadesOut) {
    Scene scene = showing({"ellipsoid", "axes", "direction", "direction-trace"});
    scene.keyframes.emplace_back().speed = 0.0;  // at rest
    scene.film.duration_s = {};
    scene.film.length_s = 10.0;
    scene.fades = {{.at_s = 4.0, .elements = {"direction", "direction-trace"}, .opacity = 0.0}};
    const StagedScene staged(scene, 1.0);
    for (const double film_s : {0.0, 1.7, 3.1, 4.0}) {
        const Drawing drawing = staged.stage.at(FilmTime{0.0, film_s});
        const View& view = drawing.views.front();
        ASSERT_EQ(view.arrows.size(), 5u);
        Eigen::Matrix3d axes;
        for (int i = 0; i < 3; ++i)
            axes.col(i) = view.arrows[static_cast<std::size_t>(i)].tip.normalized();
        const Eigen::Vector3d rho = view.arrows[4].tip;
        const Eigen::Vector3d n = (axes.transpose() * rho).normalized();
        EXPECT_NEAR(form(axes, rho), 1.0, 1e-14) << film_s;
        // The colatitude of n grows evenly from 0 to π.
        EXPECT_NEAR(std::acos(std::clamp(n.z(), -1.0, 1.0)), std::numbers::pi * film_s / 4.0, 3e-8)
            << film_s;
        const auto trace_at =
            std::find_if(view.curves.begin(), view.curves.end(),
                         [](const Curve& curve) { return curve.name.element == "trace"; });
        ASSERT_NE(trace_at, view.curves.end());
        const Curve& trace = *trace_at;
        const auto last = static_cast<std::size_t>(trace.last);
        ASSERT_LT(last, trace.geometry->points.size());
        const double step =
            last + 1 < trace.geometry->points.size()
                ? (trace.geometry->points[last + 1] - trace.geometry->points[last]).norm()
                : 1e-14;
        EXPECT_LE((trace.placement * trace.geometry->points[last] - rho).norm(), step) << film_s;
        const double moment = moments.dot(n.cwiseAbs2());
        const std::string wanted = fmt::format("= {:.3g}~", moment);
        EXPECT_TRUE(std::any_of(view.labels.begin(), view.labels.end(),
                                [&wanted](const Label& label) {
                                    return label.mask->source.text.find(wanted) !=
                                           std::string::npos;
                                }))
            << film_s << wanted;
    }
    EXPECT_EQ(staged.stage.at(FilmTime{0.0, 6.0}).views.front().arrows.size(), 3u);
}

// A film may show the element late: the sweep then begins at e3 when the element fades in.
TEST(FigureElements, DirectionStartsItsSweepWhenItFadesIn) {
    Scene scene = showing({"ellipsoid", "axes", "direction", "direction-trace"});
    scene.keyframes.emplace_back().speed = 0.0;  // at rest
    scene.film.duration_s = {};
    scene.film.length_s = 10.0;
    scene.fades = {{.at_s = 3.0, .elements = {"direction"}},
                   {.at_s = 4.0, .over_s = 0.5, .elements = {"direction-trace"}},
                   {.at_s = 7.0, .elements = {"direction"}, .opacity = 0.0}};
    const StagedScene staged(scene, 1.0);
    for (const double film_s : {3.5, 5.0, 6.9}) {
        const Drawing drawing = staged.stage.at(FilmTime{0.0, film_s});
        const View& view = drawing.views.front();
        // n comes first; ρ and its path later, at the same instant of the sweep.
        ASSERT_EQ(view.arrows.size(), film_s < 4.0 ? 4u : 5u);
        const double cosine =
            view.arrows[2].tip.normalized().dot(view.arrows.back().tip.normalized());
        EXPECT_NEAR(std::acos(std::clamp(cosine, -1.0, 1.0)),
                    std::numbers::pi * (film_s - 3.0) / 4.0, 3e-8)
            << film_s;
    }
}

// n is along ω, and I(n) = Σ I_i n_i² is 2T/ω².
TEST(FigureElements, SpinDirectionIsAlongOmegaWithItsMoment) {
    const StagedScene staged(showing({"omega", "radius", "spin-direction"}), 10.0);
    for (const double time_s : {0.0, 2.3, 7.1}) {
        const Drawing drawing = staged.stage.at(time_s);
        const View& view = drawing.views.front();
        ASSERT_EQ(view.arrows.size(), 3u);
        const auto arrow_of = [&view](std::string_view element) {
            return *std::find_if(view.arrows.begin(), view.arrows.end(),
                                 [&](const Arrow& arrow) { return arrow.name.element == element; });
        };
        const Arrow n = arrow_of("spin-direction"), omega = arrow_of("omega");
        EXPECT_LT((n.tail - omega.tip).norm(), 1e-14);
        EXPECT_LT(n.tip.normalized().cross(omega.tip.normalized()).norm(), 1e-14);
        EXPECT_GT(n.tip.dot(omega.tip), 0.0);
        const Eigen::Vector3d w = staged.motion.at(time_s).omega_body;
        const double moment = moments.dot(w.normalized().cwiseAbs2());
        const std::string wanted = fmt::format("= {:.3g}~", moment);
        EXPECT_TRUE(std::any_of(view.labels.begin(), view.labels.end(),
                                [&wanted](const Label& label) {
                                    return label.mask->source.text.find(wanted) !=
                                           std::string::npos;
                                }))
            << time_s << wanted;
    }
}

// A right angle that is seen as a line is left out: from above, that at the foot of L.
TEST(FigureElements, RightAngleFadesWhereItIsSeenEdgeOn) {
    for (const auto& [elevation_deg, n_lines] : {std::pair{20.0, 2}, std::pair{89.9, 0}}) {
        Scene scene = showing({"plane", "momentum"});
        scene.camera.elevation_deg = elevation_deg;
        const StagedScene staged(scene, 10.0);
        const View view = staged.stage.at(0.0).views.front();
        EXPECT_EQ(
            std::count_if(view.curves.begin(), view.curves.end(),
                          [](const Curve& curve) { return curve.name.element == "momentum"; }),
            n_lines)
            << elevation_deg;
    }
}

// ∇F and the tangent plane enclose a right angle, drawn at ρ with the plane.
TEST(FigureElements, GradientHasItsRightAngleWithTheTangentPlane) {
    for (const bool has_plane : {false, true}) {
        Scene scene = has_plane ? showing({"gradient", "tangent"}) : showing({"gradient"});
        const StagedScene staged(scene, 10.0);
        const View view = staged.stage.at(1.0).views.front();
        const Eigen::Vector3d rho = view.arrows.front().tail;
        ASSERT_EQ(view.curves.size(), has_plane ? 2u : 0u);
        for (const Curve& curve : view.curves)
            for (const Eigen::Vector3d& point : curve.geometry->points)
                EXPECT_LT((curve.placement * point - rho).norm(), 0.13);
    }
}

// The body beside its ellipsoid is turned as this is, and clear of it in the picture.
TEST(FigureElements, BodyBesideTurnsWithTheEllipsoid) {
    const StagedScene staged(showing({"ellipsoid", "axes", "body-beside"}), 10.0);
    for (const double time_s : {0.0, 2.3, 7.1}) {
        const View view = staged.stage.at(time_s).views.front();
        std::vector<Arrow> axes, beside;
        for (const Arrow& arrow : view.arrows)
            (arrow.name.element == "axes" ? axes : beside).push_back(arrow);
        ASSERT_EQ(axes.size(), 3u);
        ASSERT_EQ(beside.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector3d along = (beside[i].tip - beside[i].tail).normalized();
            EXPECT_LT((along - axes[i].tip.normalized()).norm(), 1e-14) << time_s;
            EXPECT_GT(beside[i].tip.norm(), 1.0) << time_s;
        }
        ASSERT_FALSE(view.meshes.empty());
    }
}

// The dot and the right angle at the foot of L belong to the plane.
TEST(FigureElements, FootOfMomentumAppearsWithThePlane) {
    Scene scene = showing({"plane", "momentum"});
    scene.film.length_s = 10.0;
    scene.film.duration_s = {};
    scene.fades = {{.at_s = 4.0, .elements = {"plane"}}};
    const StagedScene staged(scene, 10.0);
    EXPECT_EQ(staged.stage.at(FilmTime{1.0, 1.0}).views.front().dots.size(), 0u);
    EXPECT_EQ(staged.stage.at(FilmTime{6.0, 6.0}).views.front().dots.size(), 1u);
}

// ω begins at the centre until ρ covers its first part.
TEST(FigureElements, OmegaBeginsAtTheCentreUntilRhoAppears) {
    Scene scene = showing({"omega", "radius"});
    scene.film.length_s = 10.0;
    scene.film.duration_s = {};
    scene.fades = {{.at_s = 4.0, .elements = {"radius"}}};
    const StagedScene staged(scene, 10.0);
    for (const auto& [film_s, least] : {std::pair{1.0, 0.0}, std::pair{6.0, 0.1}}) {
        double tail = 0.0;  // of the arrow that begins farthest from the centre
        const View view = staged.stage.at(FilmTime{film_s, film_s}).views.front();
        for (const Arrow& arrow : view.arrows) tail = std::max(tail, arrow.tail.norm());
        EXPECT_GE(tail, least) << film_s;
        EXPECT_LE(tail, least > 0.0 ? 1.5 : 1e-14) << film_s;
    }
}

TEST(FigureElements, DimensionLineSpansThePlaneDistance) {
    const StagedScene staged(showing({"plane", "distance"}), 10.0);
    const View view = staged.stage.at(0.0).views.front();
    ASSERT_EQ(view.arrows.size(), 2u);
    const double T2 = moments.dot(omega.cwiseAbs2());
    const double L = moments.cwiseProduct(omega).norm();
    const double expected = std::sqrt(T2) / L * std::sqrt(moments.minCoeff());
    EXPECT_NEAR((view.arrows[0].tip - view.arrows[1].tip).norm(), expected, 1e-15);
    EXPECT_NEAR(view.arrows[1].tip.z(), view.planes.front().centre.z(), 1e-15);
    // It ends at two level lines, from the centre and from the foot of L.
    ASSERT_EQ(view.curves.size(), 2u);
    EXPECT_LT(view.curves[0].placement.translation().norm(), 1e-15);
    EXPECT_LT((view.curves[1].placement.translation() - view.planes.front().centre).norm(), 1e-15);
    for (const Curve& level : view.curves) EXPECT_NEAR(level.placement.linear()(2, 0), 0.0, 1e-15);
}

TEST(FigureElements, PrecessionNeedsTwoEqualMoments) {
    EXPECT_THROW(StagedScene(showing({"precession"}), 10.0), InputError);
    Scene scene = free_scene({1.0, 1.0, 1.8}, {1.5, 0.0, 1.5}, "space");
    scene.show = {"precession"};
    EXPECT_EQ(StagedScene(scene, 10.0).stage.at(1.0).views.front().arrows.size(), 2u);
}

// The rings are about the tips of e3 and of L, or on the other side if the plane is in the way.
TEST(FigureElements, PrecessionIsOnTheSideAwayFromThePlane) {
    Scene scene = free_scene({1.0, 1.0, 1.8}, {1.5, 0.0, 1.5}, "space");
    for (const bool has_plane : {false, true}) {
        scene.show = {"precession"};
        if (has_plane) scene.show.emplace_back("plane");
        const View view = StagedScene(scene, 10.0).stage.at(1.0).views.front();
        ASSERT_EQ(view.arrows.size(), 2u);
        // L points down.
        for (const Arrow& arrow : view.arrows)
            EXPECT_GT((has_plane ? 1.0 : -1.0) * arrow.tip.z(), 0.5) << has_plane;
    }
}

// The disc of the scene inertial_forces, in the object panel.
Scene disc_scene() {
    Scene scene = showing({"inertial-forces"});
    scene.panels.front().kind = "object";
    scene.body.given = BodySpec::Given::masses;
    scene.body.masses = {{3.0, {1.0, 0.0, 0.0}},
                         {3.0, {-1.0, 0.0, 0.0}},
                         {1.0, {0.0, 1.0, 0.0}},
                         {1.0, {0.0, -1.0, 0.0}}};
    scene.body.inertia = inertia_of_masses(scene.body.masses).inertia;
    scene.start.omega_rad_s = {0.1, 2.0, 0.5};
    return scene;
}

std::vector<Arrow> arrows_of(const View& view, const Colour& colour) {
    std::vector<Arrow> arrows;
    std::copy_if(view.arrows.begin(), view.arrows.end(), std::back_inserter(arrows),
                 [&](const Arrow& arrow) { return arrow.colour == colour; });
    return arrows;
}

// Each mass has the arrow of −m ω × (ω × r), and one from its tip to that of the sum with −m dω/dt
// × r, where dω/dt is a difference of the motion's ω. All have one scale.
TEST(FigureElements, InertialForcesBeginAtTheirMasses) {
    const Scene scene = disc_scene();
    const StagedScene staged(scene, 10.0);
    const Theme theme = theme_of(scene);
    double per_N = 0.0, longest = 0.0;
    for (int k = 0; k <= 100; ++k) {
        const double t = 0.1 * k;
        const View view = staged.stage.at(t).views.front();
        const std::vector<Arrow> centrifugal = arrows_of(view, theme.torque);
        const std::vector<Arrow> euler = arrows_of(view, theme.potential);
        for (const Arrow& arrow : centrifugal)
            longest = std::max(longest, (arrow.tip - arrow.tail).norm());
        if (centrifugal.size() < 4 || euler.size() < 4) continue;  // too short to be drawn
        const RotationState state = staged.motion.at(t);
        const Eigen::Vector3d& w = state.omega_body;
        constexpr double h = 1e-4;
        const Eigen::Vector3d rate =
            (staged.motion.at(t + h).omega_body - staged.motion.at(t - h).omega_body) / (2.0 * h);
        // Axes of the picture, from the masses at the ends of x and y.
        Eigen::Matrix3d axes;
        axes.col(0) = centrifugal[0].tail.normalized();
        axes.col(1) = centrifugal[2].tail.normalized();
        axes.col(2) = axes.col(0).cross(axes.col(1));
        const double per_m = centrifugal[0].tail.norm();
        for (std::size_t i = 0; i < 4; ++i) {
            const PointMass& mass = scene.body.masses[i];
            EXPECT_LT((centrifugal[i].tail - per_m * (axes * mass.at_m)).norm(), 1e-14);
            const Eigen::Vector3d outward_N = -mass.mass_kg * w.cross(w.cross(mass.at_m));
            const Eigen::Vector3d euler_N = -mass.mass_kg * rate.cross(mass.at_m);
            const Eigen::Vector3d drawn = centrifugal[i].tip - centrifugal[i].tail;
            if (per_N == 0.0) per_N = drawn.norm() / outward_N.norm();
            EXPECT_LT((drawn - per_N * (axes * outward_N)).norm(), 1e-12);
            EXPECT_EQ(euler[i].tail, centrifugal[i].tip);
            EXPECT_LT((euler[i].tip - euler[i].tail - per_N * (axes * euler_N)).norm(), 1e-7);
        }
    }
    EXPECT_GT(per_N, 0.0);
    EXPECT_NEAR(longest, 1.0, 0.01);
}

TEST(FigureElements, InertialForcesNeedPointMassesWithoutFriction) {
    const auto refusal_of = [](Scene scene) -> std::string {
        scene.locations["show"] = {"disc.toml", 3, 1};
        return refusal_message([&] { const StagedScene staged(scene, 10.0); });
    };
    EXPECT_EQ(refusal_of(disc_scene()), "");
    Scene by_moments = disc_scene();
    by_moments.body.given = BodySpec::Given::moments;
    EXPECT_EQ(refusal_of(by_moments),
              "disc.toml:3:1: show: inertial-forces needs a body of point masses; give it as "
              "[[body.masses]], or leave this element out");
    Scene damped = disc_scene();
    damped.torque = InternalFriction{0.1};
    damped.method.name = "dopri5";
    EXPECT_EQ(refusal_of(damped),
              "disc.toml:3:1: show: inertial-forces cannot show a body with internal friction; "
              "leave the element or the friction out");
}

// The arc is that of the principal axis farthest from L; it ends on this axis one period after the
// film's start.
TEST(FigureElements, PeriodTurnEndsAtTheAxisOnePeriodLater) {
    for (const Eigen::Vector3d& start : {omega, Eigen::Vector3d(0.6, -0.4, 1.2)}) {
        Scene scene = showing({"axes", "period-turn"});
        scene.start.omega_rad_s = start;
        scene.film.start_s = 0.4;
        const StagedScene staged(scene, 10.0);
        const double period_s = *staged.motion.free_constants().polhode_period_s;
        const View first = staged.stage.at(scene.film.start_s).views.front();
        const View later = staged.stage.at(scene.film.start_s + period_s).views.front();
        const std::vector<Arrow> heads = arrows_of(later, theme_of(scene).angles[1]);
        ASSERT_EQ(heads.size(), 1u);
        std::size_t widest = 0;
        for (std::size_t i = 1; i < 3; ++i)
            if (first.arrows[i].tip.head<2>().norm() > first.arrows[widest].tip.head<2>().norm())
                widest = i;
        const Eigen::Vector3d axis = later.arrows[widest].tip.normalized();
        EXPECT_LT((heads[0].tip.normalized() - axis).norm(), 1e-12);
        EXPECT_GT((first.arrows[widest].tip.normalized() - axis).norm(), 0.1);
    }
    Scene scene = showing({"period-turn"});
    scene.start.omega_rad_s = {0.0, 0.0, 1.0};
    EXPECT_THROW(StagedScene(scene, 10.0), InputError);
}

// The triangles cover the solid angle, but for the segments between their outer sides and the path
// of L, on which their outermost corners lie.
TEST(FigureElements, AreaIsTheSolidAngle) {
    for (const Eigen::Vector3d& start : {omega, Eigen::Vector3d(-1.9, 0.4, -0.2)}) {
        Scene scene = showing({"solid-angle"});
        scene.panels.front().kind = "momentum";
        scene.start.omega_rad_s = start;
        const StagedScene staged(scene, 10.0);
        const View view = staged.stage.at(1.0).views.front();
        const auto phase = montgomery_phase(staged.motion.problem());
        ASSERT_TRUE(phase);
        const double ratio =
            moments.dot(start.cwiseAbs2()) / moments.cwiseProduct(start).squaredNorm();  // 2T/L²
        for (const Curve& curve : view.curves) EXPECT_NE(curve.name.element, "solid-angle");
        ASSERT_EQ(view.meshes.size(), 1u);
        EXPECT_EQ(view.meshes[0].name.element, "solid-angle");
        const auto& points = view.meshes[0].geometry->positions;
        std::vector<Eigen::Vector3d> corners;
        int n_on_path = 0;
        for (const Eigen::Vector3f& point : points) {
            EXPECT_LT(point.norm(), 1.0);  // the lines on the sphere are in front
            const Eigen::Vector3d n = point.cast<double>().normalized();
            n_on_path += std::abs(n.cwiseAbs2().cwiseQuotient(moments).sum() - ratio) < 1e-6;
            corners.push_back(n);
        }
        EXPECT_GE(n_on_path, 96);
        double area = 0.0;
        for (std::size_t k = 0; k < corners.size(); k += 3) {
            const Eigen::Vector3d &p = corners[k], &q = corners[k + 1], &r = corners[k + 2];
            const double signed_volume = p.dot(q.cross(r));
            EXPECT_GT(signed_volume, 0.0);  // seen from outside
            area += 2.0 * std::atan2(signed_volume, 1.0 + p.dot(q) + q.dot(r) + r.dot(p));
        }
        EXPECT_NEAR(area, std::abs(phase->solid_angle_rad), 2e-3 * area);
    }
}

TEST(FigureElements, CaptionsNameMontgomerysPhase) {
    Scene scene = showing({});
    const auto phase = montgomery_phase(problem_of(scene));
    ASSERT_TRUE(phase);
    EXPECT_EQ(live_text(scene, "{phase:.6f}", {}), fmt::format("{:.6f}~rad", phase->turned_rad));
    scene.units = {"deg"};
    const double deg = 180.0 / std::numbers::pi;
    EXPECT_EQ(live_text(scene, "{period:.4f}: {dynamic_phase:.2f}, {solid_angle:.2f}", {}),
              fmt::format("{:.4f}~s: {:.2f}~deg, \u2212{:.2f}~deg", phase->period_s,
                          deg * phase->dynamic_rad, -deg * phase->solid_angle_rad));
    scene.start.omega_rad_s = {0.0, 0.0, 1.0};
    EXPECT_EQ(live_text(scene, "{omega}", {}).substr(0, 1), "0");
    EXPECT_THROW(live_text(scene, "{solid_angle}", {}), InputError);
    // An index of a formula is not a number.
    EXPECT_EQ(live_text(scene, "$x_{phase}$", {}), "$x_{phase}$");
}

// What a caption says follows the keys.
TEST(FigureElements, CaptionsNameTheBodyAndItsStart) {
    Scene scene = showing({});
    scene.body.inertia = InertiaTensor::from_principal_moments({4.0, 3.0, 1.5});
    scene.start.omega_rad_s = {1.2, -0.8, 2.4};
    EXPECT_EQ(live_text(scene, "$I =$ {I}, {omega_start}", {}),
              "$I =$ $(4,\\, 3,\\, 1.5)$~kg~m\u00b2, $(1.2,\\, \u22120.8,\\, 2.4)$~rad/s");
    scene.body.inertia = InertiaTensor::from_principal_moments({7.163e-5, 4.64e-5, 2.72e-5});
    EXPECT_EQ(live_text(scene, "{I:.3g}", {}),
              "$(71.6,\\, 46.4,\\, 27.2)\\times 10^{-6}$~kg~m\u00b2");
    scene.units = {"deg", "g cm\u00b2"};
    EXPECT_EQ(live_text(scene, "{I:.3g}", {}), "$(716,\\, 464,\\, 272)$~g~cm\u00b2");
    EXPECT_EQ(live_text(scene, "{omega_start:.1f}~rad/s", {}),
              "$(1.2,\\, \u22120.8,\\, 2.4)$~rad/s");
    scene.language = "de";
    EXPECT_EQ(live_text(scene, "{omega_start:.1f}~rad/s", {}),
              "$(1{,}2;\\, \u22120{,}8;\\, 2{,}4)$~rad/s");
    // They are the same at every instant, so that such a caption is set once.
    EXPECT_FALSE(changes(scene, "{I}, {omega_start}"));
    EXPECT_TRUE(changes(scene, "{I}, {omega_1}"));
    EXPECT_FALSE(changes(scene, "$I$"));
}

TEST(FigureElements, BodyIsInsideItsEllipsoid) {
    const StagedScene staged(showing({"ellipsoid", "body"}), 10.0);
    const View view = staged.stage.at(1.9).views.front();
    ASSERT_EQ(view.meshes.size(), 1u);
    const Eigen::Matrix3d to_unit = view.ellipsoids.front().half_axes.inverse();
    for (const Eigen::Vector3f& p : view.meshes[0].geometry->positions) {
        EXPECT_LT((to_unit * (view.meshes[0].placement * p.cast<double>())).norm(), 1.0);
    }
}

TEST(PlotQuantities, ThinPlateWobblesTwiceAsFastAsItSpins) {
    // I₃ = 2I₁ and a small tilt: φ̇ = 2ω₃/cos θ and φ̇ + ψ̇ = φ̇ − ω₃.
    Scene scene = free_scene({1.0, 1.0, 2.0}, {1e-3, 0.0, 5.0}, "plot");
    scene.panels[0].quantity = "turns";
    const Motion motion(problem_of(scene));
    const StageContext stage(scene, theme_of(scene), motion,
                             {.width_px = 640,
                              .height_px = 360,
                              .first_time_s = 0.0,
                              .last_time_s = 10.0,
                              .fonts = installed_fonts()},
                             nullptr);
    FrameInput instant;
    instant.time_s = 6.283185307179586;
    const PlotValues values = plot_quantity_of(stage, "turns").values(stage, instant);
    // cos θ = 1 − 5e-9 for tan θ = 1e-3·1/(2·5).
    EXPECT_NEAR(values[0], 10.0, 1e-7);
    EXPECT_NEAR(values[1], 5.0, 1e-7);
    Scene asymmetric = free_scene(moments, omega, "plot");
    asymmetric.panels[0].quantity = "turns";
    EXPECT_THROW(StagedScene(asymmetric, 1.0), InputError);
}

// ω goes round the axis of symmetry with the length A, whatever the tilt.
TEST(PlotQuantities, WobbleIsRelativeToItsAmplitude) {
    for (const double tilt : {1e-9, 0.5}) {
        for (int axis = 0; axis < 3; ++axis) {
            Eigen::Vector3d principal(2.0, 2.0, 2.0), start(tilt, tilt, tilt);
            principal[axis] = 3.0;
            start[axis] = 1.0;
            start[(axis + 1) % 3] = 0.0;
            Scene scene = free_scene(principal, start, "plot");
            scene.panels[0].quantity = "wobble";
            const StagedScene staged(scene, 10.0);
            const StageContext& stage = staged.stage.context();
            const PlotQuantity& quantity = plot_quantity_of(stage, "wobble");
            ASSERT_EQ(quantity.curves.size(), 2u);
            FrameInput instant;
            instant.time_s = 1.3;
            instant.state = staged.motion.at(instant.time_s);
            const PlotValues values = quantity.values(stage, instant);
            EXPECT_NEAR(std::hypot(values[0], values[1]), 1.0, 1e-15);
            // \u03a9 = (I\u2083 \u2212 I\u2081)\u03c9\u2083/I\u2081 = 1/2, from axis + 2 to
            // \u2212(axis + 1).
            const int second = (axis + 2) % 3;
            const double cosine = std::cos(0.5 * 1.3);
            EXPECT_NEAR(values[second == (axis == 0 ? 1 : 0) ? 0 : 1], cosine, 1e-12) << axis;
        }
    }
    Scene asymmetric = free_scene(moments, omega, "plot");
    asymmetric.panels[0].quantity = "wobble";
    EXPECT_THROW(StagedScene(asymmetric, 1.0), InputError);
}

TEST(TimeUnits, TicksAreRoundNumbersOfTheUnit) {
    const TimeUnit unit = time_unit_of(610.0 * 86400.0);
    EXPECT_EQ(unit.name, "d");
    const Axis axis = time_axis(0.0, 610.0 * 86400.0, unit, 7);
    ASSERT_GE(axis.ticks.size(), 3u);
    EXPECT_EQ(axis.ticks[1].label, "100");
    EXPECT_EQ(axis.ticks[1].value, 100.0 * 86400.0);
    EXPECT_EQ(time_unit_of(12.0).name, "s");
    EXPECT_EQ(time_unit_of(0.01).name, "ms");
    EXPECT_EQ(time_unit_of(86400.0).name, "h");
}

}  // namespace
}  // namespace poinsot::figure_elements_tests
