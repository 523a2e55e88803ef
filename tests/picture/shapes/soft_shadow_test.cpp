#include "shapes/soft_shadow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poinsot {
namespace {

// A sphere above the plane z = 0, which fades only far away.
struct Setting {
    Plane plane;
    Ellipsoid sphere;
    Light light;

    Setting(double radius, double height) {
        plane.radius = 1e6;
        plane.opacity = 0.8;
        sphere.centre = {0.0, 0.0, height};
        sphere.half_axes = radius * Eigen::Matrix3d::Identity();
    }
    SoftShadow shadow() const { return {plane, UnitSphere(sphere), 1.0, light}; }
};

// A sphere blocks h r²/d³ of a plane's cosine-weighted sky (h its height, d its distance; Lambert);
// from this, 0.07 and then 1/256 of the rest are subtracted.
TEST(SoftShadow, SkyShareAgreesWithTheFormulaForASphere) {
    Setting setting(0.5, 0.8);
    setting.light.key = 0.0;
    const SoftShadow shadow = setting.shadow();
    for (const double aside : {0.0, 0.1, 0.4, 0.7}) {
        const double d = std::hypot(0.8, aside);
        const double hidden = 0.8 * 0.25 / (d * d * d);
        EXPECT_NEAR(shadow.darkness({aside, 0.0, 0.0}), 0.8 * (hidden - 0.07) / 0.93 - 1.0 / 256.0,
                    1e-12);
    }
}

// Sphere and plane touch: at most two levels of white, without the plane's own fading.
TEST(SoftShadow, IsBarelyVisibleBeyondItsLimit) {
    const Setting setting(0.5, 0.5);
    const SoftShadow shadow = setting.shadow();
    for (int k = 0; k < 16; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 16.0;
        const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0.0);
        const double limit = shadow.limit(direction);
        for (const double further : {1.0, 1.2, 2.0})
            EXPECT_LE(shadow.darkness(shadow.hub() + further * limit * direction), 2.5 / 255.0);
    }
}

// Scaling along the plane's normal does not change the shadow: the shadow of a touching disc equals
// that of the sphere.
TEST(SoftShadow, OfAnEllipsoidEqualsThatOfTheScaledSphere) {
    Setting flat(0.5, 0.1);
    flat.sphere.half_axes.col(2) *= 0.2;
    flat.light.key = 0.0;
    Setting round(0.5, 0.5);
    round.light.key = 0.0;
    for (const double aside : {0.05, 0.3, 0.6})
        EXPECT_NEAR(flat.shadow().darkness({aside, 0.0, 0.0}),
                    round.shadow().darkness({aside, 0.0, 0.0}), 1e-12);
}

// A core of half darkness at the point of contact, blurred over twice 0.12 of the radius, beside
// the share of the sky that the sphere blocks.
TEST(SoftShadow, HasADarkCoreWhereTheSphereTouches) {
    Setting setting(0.5, 0.5);
    setting.light.key = 0.0;
    const SoftShadow shadow = setting.shadow();
    for (const double aside : {0.0, 0.03, 0.06, 0.09, 0.2}) {
        const double d = std::hypot(0.5, aside);
        const double sky = (0.5 * 0.25 / (d * d * d) - 0.07) / 0.93;
        const double t = std::min(aside / 0.12, 1.0);
        const double core = 0.5 * (1.0 - t * t * (3.0 - 2.0 * t));
        EXPECT_NEAR(shadow.darkness({aside, 0.0, 0.0}),
                    0.8 * (1.0 - (1.0 - sky) * (1.0 - core)) - 1.0 / 256.0, 1e-12)
            << aside;
    }
}

TEST(SoftShadow, TheCoreFadesAsTheSphereIsLifted) {
    double before = 1.0;
    for (const double gap : {0.0, 0.005, 0.01, 0.02, 0.025}) {
        Setting setting(0.5, 0.5 + gap);
        setting.light.key = 0.0;
        const double core = setting.shadow().darkness({0.0, 0.0, 0.0});
        EXPECT_LT(core, before);
        before = core;
    }
    const double d = 0.525, sky = (0.525 * 0.25 / (d * d * d) - 0.07) / 0.93;
    EXPECT_NEAR(before, 0.8 * sky - 1.0 / 256.0, 1e-12);
}

TEST(OpacityAt, FadesFromTheGivenFractionToTheRim) {
    Plane plane;
    plane.radius = 2.0;
    plane.fade_from = 0.5;
    plane.opacity = 0.8;
    EXPECT_DOUBLE_EQ(opacity_at(plane, 1.0), 0.8);
    EXPECT_DOUBLE_EQ(opacity_at(plane, 1.5), 0.4);
    EXPECT_DOUBLE_EQ(opacity_at(plane, 2.0), 0.0);
}

}  // namespace
}  // namespace poinsot
