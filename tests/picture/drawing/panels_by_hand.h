// Scenes for the tests of all panels, among them motions at every extreme, and the test that a view
// is finite.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "drawing/stage/panel_kind.h"
#include "scenes_by_hand.h"

namespace poinsot::panels_tests {

inline constexpr double pi = std::numbers::pi;

inline const Eigen::Vector3d generic_moments{1.0, 2.0, 2.9};
inline const Eigen::Vector3d generic_omega{1.4, 0.5, 1.6};

inline const View& view_of(const Drawing& drawing) { return drawing.views.front(); }

// The points of a curve at their drawn positions.
inline std::vector<Eigen::Vector3d> drawn_points(const Curve& curve) {
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3d& point : curve.geometry->points) {
        points.emplace_back(curve.placement * point);
    }
    return points;
}

inline bool finite(const Eigen::Vector3d& v) { return v.allFinite(); }

// Expects that all numbers of a view are finite.
inline void expect_finite(const View& view, const std::string& name) {
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

inline const FreeCase extremes[] = {
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

struct TopCase {
    const char* name;
    TopStart start;
    double mgl_N_m;
};

inline const TopCase tops[] = {
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

// A scene that this kind of panel can show.
inline Scene scene_for(const PanelKind& kind) {
    const std::string name(kind.name);
    if (name == "top" || name == "potential") {
        return top_scene({.theta_rad = 0.7, .omega3_rad_s = 5.0}, name);
    }
    Scene scene = free_scene(generic_moments, generic_omega, name);
    if (name == "sweep") scene.construction.sweep = "axis";
    return scene;
}

}  // namespace poinsot::panels_tests
