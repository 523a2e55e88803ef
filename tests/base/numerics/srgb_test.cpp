// sRGB's transfer function, against values of the standard.
#include "numerics/srgb.h"

#include <gtest/gtest.h>

namespace poinsot {
namespace {

TEST(Srgb, MatchesTheStandardAtEndsAndThreshold) {
    EXPECT_EQ(linear_from_srgb(0.0), 0.0);
    EXPECT_EQ(linear_from_srgb(1.0), 1.0);
    EXPECT_EQ(srgb_from_linear(0.0), 0.0);
    EXPECT_NEAR(srgb_from_linear(1.0), 1.0, 1e-15);
    // The two branches agree at the threshold within the rounding of the standard's constants.
    EXPECT_NEAR(linear_from_srgb(0.04045), 0.0031308, 1e-7);
    EXPECT_NEAR(linear_from_srgb(0.0404500001), 0.0031308, 1e-7);
}

// Known values: half of the light is level 188, and the middle level is a fifth of the light.
TEST(Srgb, HalfOfTheLightIsLevel188) {
    EXPECT_NEAR(linear_from_srgb(128.0 / 255.0), 0.2158605, 1e-7);
    EXPECT_NEAR(linear_from_srgb(188.0 / 255.0), 0.5028865, 1e-7);
    EXPECT_NEAR(255.0 * srgb_from_linear(0.2), 123.55, 0.01);
    EXPECT_NEAR(255.0 * srgb_from_linear(0.5), 187.52, 0.01);
}

TEST(Srgb, ConversionsAreInverses) {
    for (int level = 0; level <= 255; ++level) {
        const double encoded = level / 255.0;
        EXPECT_NEAR(srgb_from_linear(linear_from_srgb(encoded)), encoded, 2e-7) << level;
    }
}

}  // namespace
}  // namespace poinsot
