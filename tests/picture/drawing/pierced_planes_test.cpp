// What lies beyond a plane is dashed and in full strength, and a ring shows where an arrow pierces
// it.
#include "drawing/style/pierced_planes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "shapes/projection.h"

namespace poinsot {
namespace {

// The plane z = 0, an arrow from above it to below it, and an eye at this height.
struct Setting {
    CurveGeometry circle;
    View view;
    LineStyleRules rules;

    Setting(double eye_height, const Eigen::Vector3d& tail, const Eigen::Vector3d& tip) {
        for (int k = 0; k < 64; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / 64.0;
            circle.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
        }
        circle.closed = true;
        rules.unit_circle = &circle;
        view.width_px = 640;
        view.height_px = 360;
        view.camera.eye = {0.0, -6.0, eye_height};
        view.camera.target = {0.0, 0.0, 0.0};
        view.camera.up = {0.0, 0.0, 1.0};
        view.planes.emplace_back();
        Arrow& arrow = view.arrows.emplace_back();
        arrow.tail = tail;
        arrow.tip = tip;
        arrow.shaft_px = 4.0;
        arrow.head_px = 16.0;
        arrow.head_length_px = 26.0;
        arrow.name = {"momentum"};
    }
    const View& pierced() {
        pierce_planes(rules, view);
        return view;
    }
};

TEST(PiercePlanes, ThePartBeyondIsDashedAndAsStrong) {
    const Eigen::Vector3d tail(0.3, 0.2, 1.0), tip(-0.1, 0.4, -1.0);
    Setting setting(3.0, tail, tip);
    const View& view = setting.pierced();
    ASSERT_EQ(view.arrows.size(), 2u);
    const Arrow &before = view.arrows[0], &beyond = view.arrows[1];
    const Eigen::Vector3d at = 0.5 * (tail + tip);
    EXPECT_EQ(before.tail, tail);
    EXPECT_LT((before.tip - at).norm(), 1e-12);
    EXPECT_LT((beyond.tail - at).norm(), 1e-12);
    EXPECT_EQ(beyond.tip, tip);
    // The first part has no head and is as before.
    EXPECT_EQ(before.opacity, 1.0);
    EXPECT_EQ(before.dash_px, 0.0);
    EXPECT_LE(before.head_px, before.shaft_px);
    EXPECT_EQ(beyond.opacity, 1.0);
    EXPECT_EQ(beyond.hidden_opacity, 1.0);
    EXPECT_GT(beyond.dash_px, 0.0);
    EXPECT_EQ(beyond.head_px, 16.0);
}

TEST(PiercePlanes, ARingOnThePlaneSurroundsTheShaft) {
    Setting setting(3.0, {0.3, 0.2, 1.0}, {-0.1, 0.4, -1.0});
    const View& view = setting.pierced();
    ASSERT_EQ(view.curves.size(), 1u);
    const Curve& ring = view.curves.front();
    EXPECT_EQ(ring.on_plane, 0);
    const double unit_px = unit_px_of(view);
    for (const Eigen::Vector3d& point : ring.geometry->points) {
        const Eigen::Vector3d at = ring.placement * point;
        EXPECT_NEAR(at.z(), 0.0, 1e-12);
        const double radius_px = (at - Eigen::Vector3d(0.1, 0.3, 0.0)).norm() * unit_px;
        // Outside of the shaft, and smaller than a head's length.
        EXPECT_GT(radius_px, 4.0);
        EXPECT_LT(radius_px, 26.0);
    }
}

TEST(PiercePlanes, ADotAtThePlaceNeedsNoRing) {
    Setting setting(3.0, {0.0, 0.0, 1.0}, {0.0, 0.0, -1.0});
    setting.view.dots.emplace_back();
    EXPECT_TRUE(setting.pierced().curves.empty());
    EXPECT_EQ(setting.view.arrows.size(), 2u);
}

// Seen from below, the head is before the plane, and the plane is glass.
TEST(PiercePlanes, AHeadBeforeThePlaneIsStrong) {
    Setting setting(-3.0, {0.0, 0.0, 1.0}, {0.0, 0.0, -1.0});
    const View& view = setting.pierced();
    ASSERT_EQ(view.arrows.size(), 1u);
    EXPECT_EQ(view.arrows[0].opacity, 1.0);
    EXPECT_EQ(view.arrows[0].dash_px, 0.0);
    EXPECT_EQ(view.curves.size(), 1u);
}

TEST(PiercePlanes, AnArrowThatBeginsOnThePlaneIsBeyondItAsAWhole) {
    Setting setting(3.0, {0.2, 0.0, 0.0}, {0.4, 0.0, -1.0});
    const View& view = setting.pierced();
    ASSERT_EQ(view.arrows.size(), 1u);
    EXPECT_EQ(view.arrows[0].hidden_opacity, 1.0);
    EXPECT_GT(view.arrows[0].dash_px, 0.0);
}

TEST(PiercePlanes, ArrowsAboveOrBesideThePlaneAreUnchanged) {
    for (const double below : {0.2, -0.5}) {
        const double aside = below < 0.0 ? 1.1 * Plane().radius : 0.0;
        Setting setting(3.0, {aside, 0.0, 1.0}, {aside, 0.0, below});
        const View& view = setting.pierced();
        ASSERT_EQ(view.arrows.size(), 1u);
        EXPECT_EQ(view.arrows[0].opacity, 1.0);
        EXPECT_TRUE(view.curves.empty());
    }
}

// From one picture of a film to the next, nothing jumps while a head goes through the plane.
TEST(PiercePlanes, AHeadKeepsItsStrengthAsItGoesThrough) {
    double before = Arrow().hidden_opacity;
    int n_between = 0;
    for (int k = 0; k <= 400; ++k) {
        Setting setting(3.0, {0.0, 0.0, 1.0}, {0.0, 0.0, -0.0011 * k});
        const Arrow& last = setting.pierced().arrows.back();
        EXPECT_EQ(last.opacity, 1.0);
        EXPECT_GE(last.hidden_opacity, before);
        EXPECT_LT(last.hidden_opacity - before, 0.05);
        n_between += last.hidden_opacity < 1.0 && last.hidden_opacity > 0.5 ? 1 : 0;
        before = last.hidden_opacity;
    }
    EXPECT_GT(n_between, 20);
    EXPECT_EQ(before, 1.0);
}

TEST(PiercePlanes, WhatIsOmittedWhereHiddenStaysSo) {
    Setting setting(3.0, {0.0, 0.0, 1.0}, {0.0, 0.0, -1.0});
    setting.view.arrows.front().hidden_opacity = -1.0;
    EXPECT_LT(setting.pierced().arrows.back().hidden_opacity, 0.0);
}

}  // namespace
}  // namespace poinsot
