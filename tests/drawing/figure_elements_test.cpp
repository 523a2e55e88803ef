// The elements that explain the construction have the positions of their definitions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <set>
#include <string>

#include "drawing/figures/charts/plot_frame.h"
#include "drawing/figures/charts/plot_quantity.h"
#include "drawing/figures/elements/elements.h"
#include "drawing/stage/panel.h"
#include "error/error.h"
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
            ASSERT_EQ(view.curves.size(), 1u);
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
    Scene scene = showing({"ellipsoid", "axes", "direction"});
    scene.keyframes.emplace_back().speed = 0.0;  // at rest
    scene.film.duration_s = {};
    scene.film.length_s = 10.0;
    scene.fades = {{.at_s = 4.0, .elements = {"direction"}, .opacity = 0.0}};
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
        const Curve& trace = view.curves.front();
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
