// The user's own points.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenes_by_hand.h"
#include "styled_scenes.h"

namespace poinsot::style_tests {
namespace {

// F(ρ) = 1 on the ellipsoid in body axes for any attitude; a mark in space does not move.
TEST(OwnMarks, FollowTheirObject) {
    Scene scene = a_scene();
    const Colour red{1.0, 0.0, 0.0}, green{0.0, 1.0, 0.0};
    MarkSpec on_it, in_space;
    on_it.at = {0.0, 3.0, 0.0};
    on_it.srgb = {1.0, 0.0, 0.0};
    in_space.on = "space";
    in_space.at = {0.3, -0.4, 0.9};
    in_space.srgb = {0.0, 1.0, 0.0};
    on_it.trail = true;
    scene.marks = {on_it, in_space};
    const StagedScene staged(scene, 10.0);
    const auto dot_in = [&](const View& view, const Colour& colour) {
        const auto found = std::find_if(view.dots.begin(), view.dots.end(),
                                        [&](const Dot& dot) { return dot.colour == colour; });
        EXPECT_NE(found, view.dots.end());
        return found->at;
    };
    for (const double time_s : {0.0, 1.7, 9.3}) {
        const View view = staged.stage.at(time_s).views.at(0);
        // Along e2, at the end of that half-axis.
        const Eigen::Vector3d e2 = view.ellipsoids.at(0).half_axes.col(1);
        EXPECT_LT((dot_in(view, red) - e2).norm(), 1e-12);
        EXPECT_EQ(dot_in(view, green), in_space.at);

        // Its trail ends at the mark, and its distance from the centre is constant.
        const Curve* trail = curve_in(view, red);
        ASSERT_NE(trail, nullptr);
        const auto last = static_cast<std::size_t>(trail->last);
        const Eigen::Vector3d a = trail->geometry->points.at(last);
        const Eigen::Vector3d b =
            trail->geometry->points.at(std::min(last + 1, trail->geometry->points.size() - 1));
        const double share = trail->last - static_cast<double>(last);
        EXPECT_LT((a + share * (b - a) - e2).norm(), 2e-3);
        for (const Eigen::Vector3d& point : trail->geometry->points)
            EXPECT_NEAR(point.norm(), e2.norm(), 1e-12);
    }
}

// A mark without a colour of its own, or with the name of a role, follows the theme.
TEST(OwnMarks, FollowTheTheme) {
    Scene scene = a_scene();
    MarkSpec usual, named;
    usual.at = {0.0, 3.0, 0.0};
    named.at = {0.0, 0.0, 3.0};
    named.role = "ghost";
    scene.marks = {usual, named};
    for (const char* name : {"light", "dark"}) {
        scene.theme = name;
        const StagedScene staged(scene, 1.0);
        const View view = staged.stage.at(0.5).views.at(0);
        const Theme& theme = theme_named(name);
        for (const Colour& colour : {Colour(theme.mark), Colour(theme.ghost)}) {
            EXPECT_EQ(std::count_if(view.dots.begin(), view.dots.end(),
                                    [&](const Dot& dot) { return dot.colour == colour; }),
                      1)
                << name;
        }
    }
}

// The corner of a box, in metres, at the body's reach: it rotates with the body.
TEST(OwnMarks, OnABodyAreInMetres) {
    Scene scene = a_scene("object");
    scene.body.given = BodySpec::Given::solid;
    scene.body.shape = "box";
    scene.body.size_m = {0.24, 0.16, 0.04};
    scene.body.mass_kg = 1.0;
    MarkSpec corner;
    corner.on = "body";
    corner.at = {0.12, 0.08, 0.02};
    corner.name = "P";
    corner.srgb = {1.0, 0.0, 0.0};
    scene.marks = {corner};
    const StagedScene staged(scene, 10.0);
    const Drawing drawing = staged.stage.at(2.5);
    const View& view = drawing.views.at(0);
    const Colour red{1.0, 0.0, 0.0};
    const auto found = std::find_if(view.dots.begin(), view.dots.end(),
                                    [&](const Dot& dot) { return dot.colour == red; });
    ASSERT_NE(found, view.dots.end());
    // The box's farthest point has distance 1 from the centre, and an edge of the box ends there.
    EXPECT_NEAR(found->at.norm(), 1.0, 1e-12);
    double nearest = 1.0;
    for (const Curve& edge : view.curves)
        for (const Eigen::Vector3d& point : edge.geometry->points)
            nearest = std::min(nearest, (edge.placement * point - found->at).norm());
    EXPECT_LT(nearest, 1e-9);
}

}  // namespace
}  // namespace poinsot::style_tests
