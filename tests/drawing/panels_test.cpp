// The contents of the panels satisfy the laws of the motion; and all panels are finite for extreme
// motions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "drawing/charts/plot_quantity.h"
#include "drawing/elements/elements.h"
#include "drawing/elements/object_shapes.h"
#include "drawing/panel.h"
#include "drawing/theme.h"
#include "error/error.h"
#include "mechanics/top/heavy_top.h"
#include "scenes_by_hand.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot::panels_tests {
namespace {

constexpr double pi = std::numbers::pi;

const Eigen::Vector3d generic_moments{1.0, 2.0, 2.9};
const Eigen::Vector3d generic_omega{1.4, 0.5, 1.6};

const View& view_of(const Drawing& drawing) { return drawing.views.front(); }

// The points of a curve at their drawn positions.
std::vector<Eigen::Vector3d> drawn_points(const Curve& curve) {
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3d& point : curve.geometry->points) {
        points.emplace_back(curve.placement * point);
    }
    return points;
}

bool finite(const Eigen::Vector3d& v) { return v.allFinite(); }

// Expects that all numbers of a view are finite.
void expect_finite(const View& view, const std::string& name) {
    EXPECT_TRUE(finite(view.camera.eye) && finite(view.camera.target)) << name;
    EXPECT_GT((view.camera.eye - view.camera.target).norm(), 0.0) << name;
    if (view.camera.orthographic) {
        EXPECT_GT(view.camera.height_units, 0.0) << name;
        EXPECT_TRUE(std::isfinite(view.camera.height_units)) << name;
    }
    for (const Ellipsoid& e : view.ellipsoids) {
        EXPECT_TRUE(finite(e.centre) && e.half_axes.allFinite()) << name;
    }
    for (const Plane& p : view.planes) {
        EXPECT_TRUE(finite(p.centre) && std::isfinite(p.radius) && p.radius > 0.0) << name;
    }
    for (const Curve& c : view.curves) {
        ASSERT_NE(c.geometry, nullptr) << name;
        EXPECT_TRUE(c.placement.matrix().allFinite() && std::isfinite(c.first)) << name;
        EXPECT_FALSE(std::isnan(c.last)) << name;
        for (const Eigen::Vector3d& p : c.geometry->points) ASSERT_TRUE(finite(p)) << name;
    }
    for (const Arrow& a : view.arrows) {
        EXPECT_TRUE(finite(a.tail) && finite(a.tip)) << name;
        EXPECT_TRUE(std::isfinite(a.shaft_px) && std::isfinite(a.head_px)) << name;
    }
    for (const Dot& d : view.dots) EXPECT_TRUE(finite(d.at)) << name;
    for (const Mesh& m : view.meshes) {
        ASSERT_NE(m.geometry, nullptr) << name;
        EXPECT_TRUE(m.placement.matrix().allFinite()) << name;
        for (const auto& p : m.geometry->positions) ASSERT_TRUE(p.allFinite()) << name;
        for (const auto& n : m.geometry->normals) ASSERT_TRUE(n.allFinite()) << name;
    }
    for (const Label& l : view.labels) EXPECT_TRUE(l.top_left_px.allFinite()) << name;
}

struct FreeCase {
    const char* name;
    Eigen::Vector3d moments;
    Eigen::Vector3d omega;
};

const FreeCase extremes[] = {
    {"generic", {1.0, 2.0, 2.9}, {1.4, 0.5, 1.6}},
    {"unsorted", {2.9, 1.0, 2.0}, {-1.4, 0.5, -1.6}},
    {"sphere", {2.0, 2.0, 2.0}, {0.3, 0.4, -0.5}},
    {"nearly a sphere", {1.0, std::nextafter(1.0, 2.0), 1.0 + 4e-16}, {0.3, 0.4, -0.5}},
    {"oblate", {2.0, 2.0, 3.0}, {0.5, 0.3, 1.0}},
    {"prolate", {3.0, 3.0, 1.0}, {0.5, 0.3, 1.0}},
    {"nearly symmetric", {2.0, std::nextafter(2.0, 3.0), 3.0}, {0.5, 0.3, 1.0}},
    {"permanent about the first", {1.0, 2.0, 2.9}, {-1.0, 0.0, 0.0}},
    {"permanent about the middle", {1.0, 2.0, 2.9}, {0.0, 1.0, 0.0}},
    {"equator of a symmetric body", {2.0, 2.0, 3.0}, {0.6, 0.8, 0.0}},
    {"separatrix", {1.0, 2.0, 2.25}, {0.75, 0.5, 1.0}},
    {"beside the separatrix", {1.0, 2.0, 2.25}, {std::nextafter(0.75, 1.0), 0.5, 1.0}},
    {"wobble of 1e-8", {1.0, 2.0, 2.9}, {1e-8, 0.0, 1.0}},
    {"wobble of 1e-150", {1.0, 2.0, 2.9}, {1e-150, 0.0, 1.0}},
    {"wobble about the middle", {1.0, 2.0, 2.9}, {1e-8, 1.0, -1e-8}},
    {"needle", {1e-12, 1.0, 1.0}, {1.0, 1e-3, 0.0}},
    {"needle of three moments", {1e-12, 1.0, 1.0 + 5e-13}, {1.0, 1e-3, 1e-3}},
    {"needle end over end", {1e-12, 1.0, 1.0}, {0.0, 1.0, 1e-3}},
    {"lamina", {1.0, 2.0, 3.0}, {1.0, 0.2, 0.3}},
    {"large", {1e300, 2e300, 2.9e300}, {1e-140, 2e-140, 1e-141}},
    {"small", {1e-200, 2e-200, 2.9e-200}, {1e-3, 2e-3, 1e-4}},
    {"slow", {1.0, 2.0, 2.9}, {1e-150, 2e-150, 1e-151}},
    {"unphysical", {1.0, 2.0, 3.5}, {1.0, 0.2, 0.3}},
};

TEST(Panels, AreFiniteForExtremeMotions) {
    for (const char* kind : {"space", "body", "plan", "momentum", "object", "plot"}) {
        for (const FreeCase& one : extremes) {
            const std::string name = std::string(kind) + ", " + one.name;
            const StagedScene staged(free_scene(one.moments, one.omega, kind), 10.0);
            for (const double t : {0.0, 3.7, 10.0}) {
                const Drawing drawing = staged.stage.at(t);
                for (const View& view : drawing.views) expect_finite(view, name);
            }
        }
    }
}

struct TopCase {
    const char* name;
    TopStart start;
    double mgl_N_m;
};

const TopCase tops[] = {
    {"looping", {0.7, 0.0, -0.6, 5.0}, 1.0},
    {"wavy", {0.7, 0.1, 0.9, 5.0}, 1.0},
    {"cusp", {0.7, 0.0, 0.0, 5.0}, 1.0},
    {"sleeping", {0.0, 0.0, 0.0, 6.0}, 1.0},
    {"nearly sleeping", {1e-100, 0.0, 0.0, 6.0}, 1.0},
    {"steady", {0.5 * pi, 0.0, 0.2, 10.0}, 1.0},
    {"hanging", {pi, 0.0, 0.0, 3.0}, 1.0},
    {"hanging by Mgl < 0", {0.7, 0.0, 0.0, 5.0}, -1.0},
    {"without gravity", {0.7, 0.0, 0.5, 5.0}, 0.0},
    {"pendulum", {1.0, 0.0, 0.0, 0.0}, 1.0},
    {"pendulum through the vertical", {1.0, 3.0, 0.0, 0.0}, 1.0},
    {"through the upright", {1.0, 2.0, 0.0, 0.0}, 1.0},
    {"at rest upright", {0.0, 0.0, 0.0, 0.0}, 1.0},
};

TEST(Panels, OfTopsAreFiniteForExtremeMotions) {
    for (const char* kind : {"top", "potential", "plot", "object"}) {
        for (const TopCase& one : tops) {
            const std::string name = std::string(kind) + ", " + one.name;
            const StagedScene staged(top_scene(one.start, kind, one.mgl_N_m), 10.0);
            for (const double t : {0.0, 3.7, 10.0}) {
                const Drawing drawing = staged.stage.at(t);
                for (const View& view : drawing.views) expect_finite(view, name);
            }
        }
    }
}

// Expects that the charts of all quantities of a motion are finite; returns their number.
int n_finite_charts(Scene scene, const std::string& name) {
    int n = 0;
    for (const PlotQuantity& quantity : plot_quantities()) {
        scene.panels.front().quantity = quantity.name;
        std::optional<StagedScene> staged;
        try {
            staged.emplace(scene, 10.0);
        } catch (const InputError&) {
            continue;  // it needs another kind of motion
        }
        ++n;
        for (const double t : {0.0, 3.7, 10.0})
            expect_finite(staged->stage.at(t).views.front(), std::string(quantity.name) + name);
    }
    return n;
}

TEST(Panels, EveryQuantityIsFiniteForExtremeMotions) {
    for (const FreeCase& one : extremes)
        EXPECT_GE(n_finite_charts(free_scene(one.moments, one.omega, "plot"), one.name), 5);
    for (const TopCase& one : tops)
        EXPECT_GE(n_finite_charts(top_scene(one.start, "plot", one.mgl_N_m), one.name), 5);
}

// The numbers of an element in the space panel: positions of its marks, curves and solids, in
// picture units.
std::vector<double> places_of(const View& view) {
    std::vector<double> places;
    const auto add = [&places](const auto& numbers) {
        for (const double x : numbers.reshaped()) places.push_back(x);
    };
    for (const Arrow& arrow : view.arrows) {
        add(arrow.tail);
        add(arrow.tip);
    }
    for (const Dot& dot : view.dots) add(dot.at);
    for (const Ellipsoid& ellipsoid : view.ellipsoids) add(ellipsoid.half_axes);
    for (const Cone& cone : view.cones) add(Eigen::Vector3d(cone.length * cone.axis));
    for (const Plane& plane : view.planes) add(plane.centre);
    for (const Curve& curve : view.curves) {
        add(Eigen::Vector3d(curve.placement * curve.geometry->points.front()));
        add(Eigen::Vector3d(curve.placement * curve.geometry->points.back()));
    }
    for (const Mesh& mesh : view.meshes) add(mesh.placement.matrix());
    return places;
}

// Whether it shows a comparison motion.
bool is_of_beside(const Element& element) {
    return element.name == "ghost" || element.name == "drift";
}

// The numbers of one element for a body, with lengths, masses and times in other units.
std::vector<double> places_of_element(const Element& element, const Eigen::Matrix3d& tensor,
                                      double moments_by, double rates_by) {
    Scene scene =
        free_scene(Eigen::Vector3d::Ones(), rates_by * Eigen::Vector3d(1.4, 0.5, 1.6), "space");
    scene.body.inertia = InertiaTensor::from_matrix(moments_by * tensor);
    scene.show = {std::string(element.name)};
    const double last_time_s = 10.0 / rates_by;
    scene.film.duration_s = last_time_s;
    MethodChoice stepped{"rk4", 0.01 / rates_by, {}, {}};
    const bool of_beside = is_of_beside(element);
    if (of_beside) scene.beside = stepped;
    const Motion motion(problem_of(scene));
    MotionProblem problem = motion.problem();
    problem.method = stepped;
    const Motion beside(problem);
    const Stage stage(
        scene, motion,
        {.width_px = 640, .height_px = 360, .last_time_s = last_time_s, .fonts = installed_fonts()},
        of_beside ? &beside : nullptr);
    const Drawing drawing = stage.at(0.37 * last_time_s);
    expect_finite(drawing.views.front(), std::string(element.name));
    return places_of(view_of(drawing));
}

std::vector<double> places_of_element(const Element& element, double moments_by, double rates_by) {
    // Two equal moments, as cones and precession require; the axis is between the first two of the
    // given axes.
    Eigen::Matrix3d tensor;
    tensor << 2.5, 0.5, 0.0, 0.5, 2.5, 0.0, 0.0, 0.0, 2.0;
    try {
        return places_of_element(element, tensor, moments_by, rates_by);
    } catch (const InputError&) {
        tensor(2, 2) = 2.9;  // moments 2, 3 and 2.9
        return places_of_element(element, tensor, moments_by, rates_by);
    }
}

// A body's picture does not depend on the units of its data: no absolute tolerance of order one is
// involved.
TEST(SpacePanel, EveryElementIsIndependentOfUnits) {
    for (const Element& element : elements()) {
        const std::vector<double> expected = places_of_element(element, 1.0, 1.0);
        EXPECT_GT(expected.size(), 0u) << element.name;
        for (const auto& [moments_by, rates_by] :
             {std::pair{0x1p500, 1.0}, std::pair{0x1p-500, 1.0}, std::pair{1.0, 0x1p100},
              std::pair{1.0, 0x1p-100}}) {
            const std::vector<double> places = places_of_element(element, moments_by, rates_by);
            ASSERT_EQ(places.size(), expected.size()) << element.name;
            for (std::size_t i = 0; i < places.size(); ++i)
                EXPECT_NEAR(places[i], expected[i], 1e-9)
                    << element.name << ", moments by " << moments_by << ", rates by " << rates_by;
        }
    }
}

// Motions for which an element is rejected are skipped; every element is drawn for some motion.
TEST(SpacePanel, EveryElementIsFiniteForExtremeMotions) {
    for (const Element& element : elements()) {
        if (is_of_beside(element)) continue;  // tested above with a comparison motion
        int n = 0;
        for (const FreeCase& one : extremes) {
            Scene scene = free_scene(one.moments, one.omega, "space");
            scene.show = {std::string(element.name)};
            std::optional<StagedScene> staged;
            try {
                staged.emplace(scene, 10.0);
            } catch (const InputError&) {
                continue;
            }
            ++n;
            for (const double t : {0.0, 10.0})
                expect_finite(staged->stage.at(t).views.front(),
                              std::string(element.name) + ", " + one.name);
        }
        EXPECT_GT(n, 0) << element.name;
    }
}

// A scene that this kind of panel can show.
Scene scene_for(const PanelKind& kind) {
    const std::string name(kind.name);
    if (name == "top" || name == "potential") {
        return top_scene({.theta_rad = 0.7, .omega3_rad_s = 5.0}, name);
    }
    Scene scene = free_scene(generic_moments, generic_omega, name);
    if (name == "sweep") scene.construction.sweep = "axis";
    return scene;
}

TEST(Panels, EveryKindCanBeMade) {
    for (const PanelKind& kind : panel_kinds()) {
        const Scene scene = scene_for(kind);
        const StagedScene staged(scene, 1.0);
        const Drawing drawing = staged.stage.at(1.0);
        const View& view = view_of(drawing);
        EXPECT_GT(view.curves.size() + view.meshes.size(), 0u) << kind.name;
        EXPECT_GT(view.labels.size(), 0u) << kind.name;
        EXPECT_EQ(&panel_kind_named(kind.name), &kind);
    }
}

TEST(Panels, RejectMotionsThatTheyCannotShow) {
    EXPECT_THROW(StagedScene(top_scene({.theta_rad = 0.7, .omega3_rad_s = 5.0}, "body"), 1.0),
                 InputError);
    EXPECT_THROW(StagedScene(free_scene(generic_moments, generic_omega, "top"), 1.0), InputError);
    EXPECT_THROW(StagedScene(free_scene(generic_moments, {0.0, 0.0, 0.0}, "plan"), 1.0),
                 InputError);
}

TEST(Panels, DefaultSuitsTheMotion) {
    Scene top = top_scene({.theta_rad = 0.7, .omega3_rad_s = 5.0}, "top");
    top.panels.clear();
    EXPECT_EQ(default_panel(StagedScene(top, 1.0).stage.data()), "top");
    Scene free = free_scene(generic_moments, generic_omega, "space");
    free.panels.clear();
    EXPECT_EQ(default_panel(StagedScene(free, 1.0).stage.data()), "space");
}

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

TEST(MomentumPanel, CurvesLieOnSphereAndEnergyEllipsoid) {
    for (const FreeCase& one : extremes) {
        const StagedScene staged(free_scene(one.moments, one.omega, "momentum"), 10.0);
        for (const double t : {0.0, 3.7}) {
            const Drawing drawing = staged.stage.at(t);
            const View& view = view_of(drawing);
            const Eigen::Vector3d half_axes = view.ellipsoids[1].half_axes.diagonal();
            std::vector<Eigen::Vector3d> points{view.arrows.back().tip};
            for (const Curve& curve : view.curves) {
                if (curve.geometry == staged.stage.data().unit_segment) continue;  // a leader
                for (const Eigen::Vector3d& point : drawn_points(curve)) points.push_back(point);
            }
            for (const Eigen::Vector3d& point : points) {
                EXPECT_NEAR(point.norm(), 1.0, 4e-15) << one.name;  // measured 4e-16
                // 2T/L² of the point: the relative error of the moments' ratio does not matter,
                // since all terms are positive.
                EXPECT_NEAR(point.cwiseQuotient(half_axes).norm(), 1.0, 2e-14) << one.name;
            }
        }
    }
}

TEST(PlanPanel, HerpolhodeStaysBetweenItsCirclesAndEndsAtTheContact) {
    const Colour herpolhode_colour = theme_named("light").herpolhode;
    for (const FreeCase& one : extremes) {
        const StagedScene staged(free_scene(one.moments, one.omega, "plan"), 10.0);
        const Drawing drawing = staged.stage.at(3.7);
        const View& view = view_of(drawing);
        const Eigen::Vector3d contact = view.dots.back().at;
        double inner = 0.0;
        double outer = 0.0;
        const Curve* path = nullptr;
        for (const Curve& curve : view.curves) {
            if (curve.geometry->closed) {
                const double radius = curve.placement.linear().col(0).norm();
                inner = radius < 1.0 ? radius : inner;
                outer = std::max(outer, radius);
            } else if (curve.colour == herpolhode_colour && !curve.geometry->points.empty()) {
                path = &curve;
            }
        }
        if (outer == 0.0) {
            EXPECT_EQ(contact.norm(), 0.0) << one.name;
            EXPECT_EQ(path, nullptr) << one.name;
            continue;
        }
        EXPECT_NEAR(outer, 1.0, 1e-14) << one.name;
        // If ω differs from the axis by an ulp, the herpolhode has a relative error of a few
        // hundredths.
        const double slack = std::string_view(one.name) == "nearly a sphere" ? 0.03 : 1e-8;
        EXPECT_LE(contact.norm(), 1.0 + slack) << one.name;
        EXPECT_GE(contact.norm(), inner - slack) << one.name;
        ASSERT_NE(path, nullptr) << one.name;
        for (const Eigen::Vector3d& point : path->geometry->points) {
            EXPECT_LE(point.norm(), 1.0 + slack) << one.name;
        }
        const auto i = static_cast<std::size_t>(path->last);
        const auto& points = path->geometry->points;
        const Eigen::Vector3d end =
            points[i] + (path->last - static_cast<double>(i)) *
                            (points[std::min(i + 1, points.size() - 1)] - points[i]);
        // The end of the shown part moves along the chord at a constant rate.
        EXPECT_LT((end - contact).norm(), 2e-2) << one.name;
    }
}

TEST(PlotPanel, DotsLieOnTheirCurvesUnderTheCursor) {
    const StagedScene staged(free_scene(generic_moments, generic_omega, "plot"), 10.0);
    for (int k = 0; k <= 20; ++k) {
        const Drawing drawing = staged.stage.at(0.5 * k);
        const View& view = view_of(drawing);
        ASSERT_EQ(view.dots.size(), 3u);
        std::size_t at = 0;
        for (const Curve& curve : view.curves) {
            if (curve.geometry->points.size() < 3) continue;
            const Eigen::Vector3d dot = view.dots[at++].at;
            EXPECT_NEAR(dot.x(), view.dots[0].at.x(), 1e-9);
            double nearest = 1e300;
            const auto& points = curve.geometry->points;
            for (std::size_t i = 0; i + 1 < points.size(); ++i) {
                if (points[i].x() > dot.x() + 1e-9 || points[i + 1].x() < dot.x() - 1e-9) continue;
                const double s = (dot.x() - points[i].x()) / (points[i + 1].x() - points[i].x());
                nearest = std::min(
                    nearest,
                    std::abs(points[i].y() + s * (points[i + 1].y() - points[i].y()) - dot.y()));
            }
            EXPECT_LT(nearest, 0.1);  // px: accuracy_px; measured 0.05
        }
        EXPECT_EQ(at, 3u);
    }
}

// Rounding noise around zero is not drawn as a curve and does not determine the order of names.
TEST(PlotPanel, RoundingNoiseIsOnTheLowestLineInTableOrder) {
    for (const Eigen::Vector3d& omega : {generic_omega, Eigen::Vector3d(0.3, 2.0, 0.1)}) {
        Scene scene = free_scene(generic_moments, omega, "plot");
        scene.panels[0].quantity = "residuals";
        const StagedScene staged(scene, 10.0);
        const Drawing drawing = staged.stage.at(7.0);
        const View& view = view_of(drawing);
        ASSERT_EQ(view.dots.size(), 5u);
        for (const Dot& dot : view.dots) EXPECT_EQ(dot.at.y(), view.dots[0].at.y());
        for (const Curve& curve : view.curves) {
            if (curve.geometry->points.size() < 3) continue;
            for (const Eigen::Vector3d& point : curve.geometry->points)
                ASSERT_EQ(point.y(), view.dots[0].at.y());
        }
        // The names are the last labels, stacked upwards in the order of the table.
        ASSERT_GE(view.labels.size(), 5u);
        const std::span names(view.labels.end() - 5, view.labels.end());
        for (std::size_t i = 1; i < names.size(); ++i)
            EXPECT_LT(names[i].top_left_px.y(), names[i - 1].top_left_px.y()) << i;
    }
}

TEST(PlotPanel, QuantitiesDependOnTheMotion) {
    Scene scene = free_scene(generic_moments, generic_omega, "plot");
    for (const char* quantity : {"omega", "energy", "residuals"}) {
        scene.panels[0].quantity = quantity;
        const StagedScene staged(scene, 10.0);
        const Drawing drawing = staged.stage.at(1.0);
        expect_finite(view_of(drawing), quantity);
    }
    scene.panels[0].quantity = "euler_angles";
    EXPECT_THROW(StagedScene(scene, 10.0), InputError);
    scene.panels[0].quantity = "omgea";
    try {
        const StagedScene staged(scene, 10.0);
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean \"omega\"?"), std::string::npos)
            << error.what();
    }
}

TEST(TopPanel, AxisIsThatOfTheAttitude) {
    for (const TopCase& one : tops) {
        const StagedScene staged(top_scene(one.start, "top", one.mgl_N_m), 10.0);
        for (const double t : {0.0, 1.3, 10.0}) {
            // The quaternion is computed independently of the angles.
            const Eigen::Vector3d e3 =
                staged.motion.at(t).space_from_body * Eigen::Vector3d::UnitZ();
            const Drawing drawing = staged.stage.at(t);
            EXPECT_LT((view_of(drawing).dots.back().at - e3).norm(), 2e-12) << one.name << " " << t;
            // The shown path ends there; leaders of labels follow it in the list.
            const auto& curves = view_of(drawing).curves;
            const auto path = std::find_if(curves.rbegin(), curves.rend(), [&](const Curve& curve) {
                return curve.geometry != staged.stage.data().unit_segment;
            });
            ASSERT_NE(path, curves.rend());
            const auto i = static_cast<std::size_t>(path->last);
            EXPECT_LT((path->geometry->points[i] - e3).norm(), 0.25) << one.name << " " << t;
        }
    }
}

TEST(TopPanel, AxisMovesBetweenTheDrawnCircles) {
    const StagedScene staged(top_scene({0.7, 0.0, -0.6, 5.0}, "top"), 10.0);
    const Drawing drawing = staged.stage.at(10.0);
    std::vector<double> heights;
    for (const Curve& curve : view_of(drawing).curves) {
        if (curve.dash_px > 0.0 && curve.geometry->closed) {
            heights.push_back(curve.placement.translation().z());
        }
    }
    ASSERT_EQ(heights.size(), 2u);
    double lowest = 1.0;
    double highest = -1.0;
    for (const Eigen::Vector3d& point : view_of(drawing).curves.back().geometry->points) {
        lowest = std::min(lowest, point.z());
        highest = std::max(highest, point.z());
        EXPECT_NEAR(point.norm(), 1.0, 1e-14);
    }
    EXPECT_NEAR(lowest, std::min(heights[0], heights[1]), 1e-3);  // reached between two samples
    EXPECT_NEAR(highest, std::max(heights[0], heights[1]), 1e-3);
    EXPECT_GE(lowest, std::min(heights[0], heights[1]) - 1e-13);
    EXPECT_LE(highest, std::max(heights[0], heights[1]) + 1e-13);
}

TEST(PotentialPanel, MovingPointReachesTheEnergyAtTheTurningPoints) {
    const StagedScene staged(top_scene({0.7, 0.0, -0.6, 5.0}, "potential"), 10.0);
    // θ̇(0) = 0: the start is a turning point, where V = E.
    const Drawing start = staged.stage.at(0.0);
    const auto& dots = view_of(start).dots;
    ASSERT_EQ(dots.size(), 3u);
    EXPECT_LT(std::min((dots[2].at - dots[0].at).norm(), (dots[2].at - dots[1].at).norm()), 1e-6);
    // Between the turning points V is less than E.
    const double period = staged.motion.heavy_top()->nutation().period_s;
    const Drawing middle = staged.stage.at(0.25 * period);
    EXPECT_LT(view_of(middle).dots[2].at.y(), dots[0].at.y() - 10.0);
}

TEST(ObjectPanel, BoxHasTheGivenMoments) {
    // For 1 kg: I₁ = (b² + c²)/12 and so on.
    const Eigen::Vector3d edges = box_of_moments(generic_moments);
    const Eigen::Vector3d squares = edges.cwiseProduct(edges);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR((squares[(i + 1) % 3] + squares[(i + 2) % 3]) / 12.0, generic_moments[i],
                    1e-14);
    }
    // A lamina and bodies with impossible moments have a positive thickness.
    EXPECT_GT(box_of_moments({1.0, 2.0, 3.0}).minCoeff(), 0.0);
    EXPECT_GT(box_of_moments({1.0, 2.0, 3.5}).minCoeff(), 0.0);
}

TEST(ObjectPanel, MassesAreAtTheirPositions) {
    Scene scene = free_scene({1.0, 2.0, 2.5}, generic_omega, "object");
    scene.body.given = BodySpec::Given::masses;
    scene.body.masses = {{1.0, {1.0, 0.0, 0.0}}, {1.0, {-0.5, 0.5, 0.0}}, {1.0, {-0.5, -0.5, 0.0}}};
    const StagedScene staged(scene, 1.0);
    const Drawing drawing = staged.stage.at(0.0);
    ASSERT_EQ(view_of(drawing).meshes.size(), 2u);
    // The mean of the balls' corners is the centre of mass, in units of the body's reach: all balls
    // have the same number of corners.
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    double reach = 0.0;
    for (const auto& p : view_of(drawing).meshes[1].geometry->positions) {
        mean += p.cast<double>();
        reach = std::max(reach, 1.0 * p.norm());
    }
    mean /= static_cast<double>(view_of(drawing).meshes[1].geometry->positions.size());
    EXPECT_LT(mean.norm(), 1e-5);
    EXPECT_NEAR(reach, 1.0, 1e-6);
}

TEST(Layout, PanelsLeaveSpaceForTitleAndCaption) {
    Scene scene = free_scene(generic_moments, generic_omega, "body");
    scene.title = "Title";
    scene.caption = "Caption";
    PanelSpec plot;
    plot.kind = "plot";
    plot.row = 1;
    scene.grid.rows = {2.0, 1.0};
    scene.panels.push_back(plot);
    const StagedScene staged(scene, 1.0);
    const Drawing drawing = staged.stage.at(1.0);
    ASSERT_EQ(drawing.views.size(), 3u);
    const View& body = drawing.views[0];
    const View& below = drawing.views[1];
    EXPECT_GT(body.y_px, 0);
    EXPECT_EQ(body.y_px + body.height_px, below.y_px);
    EXPECT_LT(below.y_px + below.height_px, scene.film.height_px);
    EXPECT_NEAR(body.height_px, 2.0 * below.height_px, 2.0);
    // The overlays' text is in the reserved bands.
    for (const Label& label : drawing.views[2].labels) {
        const double bottom = label.top_left_px.y() + label.mask->height;
        EXPECT_TRUE(bottom <= body.y_px || label.top_left_px.y() >= below.y_px + below.height_px)
            << label.top_left_px.transpose();
    }
}

TEST(Layout, NumbersOfAChartDoNotOverlapAtAnyHeight) {
    // Three stacked charts.
    for (const int height : {100, 180, 240, 400}) {
        Scene scene = top_scene({.theta_rad = 0.7, .omega3_rad_s = 5.0}, "plot");
        scene.panels[0].quantity = "euler_angles";
        scene.film.width_px = 640;
        scene.film.height_px = height;
        const StagedScene staged(scene, 1.0);
        const Drawing drawing = staged.stage.at(1.0);
        // The numbers of the values are right-aligned, up to a pixel of rounding.
        const std::vector<Label>& labels = view_of(drawing).labels;
        const auto right = [](const Label& label) {
            return label.top_left_px.x() + label.mask->width;
        };
        int n_pairs = 0;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (std::abs(right(labels[i]) - right(labels[j])) > 1.0) continue;
                const bool above = labels[i].top_left_px.y() < labels[j].top_left_px.y();
                const Label& upper = above ? labels[i] : labels[j];
                const Label& lower = above ? labels[j] : labels[i];
                EXPECT_LE(upper.top_left_px.y() + upper.mask->height, lower.top_left_px.y() + 1.0)
                    << height;
                ++n_pairs;
            }
        }
        EXPECT_TRUE(n_pairs > 0 || height < 400);
    }
}

TEST(Layout, LabelsAreInsideTheirPanelAtAnySize) {
    for (const PanelKind& kind : panel_kinds()) {
        Scene scene = scene_for(kind);
        scene.show = {"polhode", "ellipsoid", "momentum", "axes", "omega"};  // no overlays
        if (kind.name == "sweep") scene.show = {"caption"};
        for (const auto& [width, height] :
             std::vector<std::pair<int, int>>{{320, 180}, {640, 360}, {1920, 1080}, {500, 900}}) {
            scene.film.width_px = width;
            scene.film.height_px = height;
            const StagedScene staged(scene, 1.0);
            const Drawing drawing = staged.stage.at(1.0);
            for (const Label& label : view_of(drawing).labels) {
                EXPECT_GE(label.top_left_px.x(), 0.0) << kind.name << " " << width;
                EXPECT_GE(label.top_left_px.y(), 0.0) << kind.name << " " << width;
                EXPECT_LE(label.top_left_px.x() + label.mask->width, width)
                    << kind.name << " " << width;
                EXPECT_LE(label.top_left_px.y() + label.mask->height, height)
                    << kind.name << " " << width;
            }
        }
    }
}

}  // namespace
}  // namespace poinsot::panels_tests
