// Every element is finite and independent of units, in the panel that shows it.
#include "drawing/figures/elements/elements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "error/error.h"
#include "panels_by_hand.h"
#include "scenes_by_hand.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot::panels_tests {
namespace {

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

// A scene with the panel that shows this element, and a body that it accepts: for inertial-forces
// six equal masses on the principal axes, which have the moments of the scene's body.
Scene scene_of_element(const Element& element, Scene scene) {
    for (const PanelKind& kind : panel_kinds())
        if ((kind.uses & element.shown_in) != 0) scene.panels.front().kind = kind.name;
    scene.show = {std::string(element.name)};
    if (element.name != "inertial-forces") return scene;
    const Eigen::Vector3d I = scene.body.inertia.moments_kg_m2();
    scene.body.given = BodySpec::Given::masses;
    for (int i = 0; i < 3; ++i) {
        const double at_m = std::sqrt(std::max(0.0, 0.5 * (I.sum() - 2.0 * I[i])));
        for (const double side : {at_m, -at_m})
            scene.body.masses.push_back(
                {0.5, side * scene.body.inertia.body_from_principal().col(i)});
    }
    return scene;
}

// The numbers of one element for a body, with lengths, masses and times in other units.
std::vector<double> places_of_element(const Element& element, const Eigen::Matrix3d& tensor,
                                      double moments_by, double rates_by) {
    Scene scene =
        free_scene(Eigen::Vector3d::Ones(), rates_by * Eigen::Vector3d(1.4, 0.5, 1.6), "space");
    scene.body.inertia = InertiaTensor::from_matrix(moments_by * tensor);
    scene = scene_of_element(element, scene);
    const double last_time_s = 10.0 / rates_by;
    scene.film.duration_s = last_time_s;
    MethodChoice stepped{"rk4", 0.01 / rates_by, {}, {}};
    const bool of_beside = is_of_beside(element);
    if (of_beside) scene.beside = stepped;
    if (element.name == "measured") measure(scene, last_time_s, 41);
    const Motion motion(problem_of(scene));
    MotionProblem problem = motion.problem();
    problem.method = stepped;
    const Motion beside(problem);
    const Stage stage(
        scene, theme_of(scene), motion,
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
            Scene scene = scene_of_element(element, free_scene(one.moments, one.omega, "space"));
            if (element.name == "measured") measure(scene, 10.0, 41);
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

}  // namespace
}  // namespace poinsot::panels_tests
