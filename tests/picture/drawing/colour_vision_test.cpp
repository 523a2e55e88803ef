// Contrast and difference of colours, compared with published values.
#include "drawing/style/colour_vision.h"

#include <gtest/gtest.h>

namespace poinsot {
namespace {

const Colour white{1.0, 1.0, 1.0}, black{0.0, 0.0, 0.0}, red{1.0, 0.0, 0.0}, green{0.0, 1.0, 0.0},
    blue{0.0, 0.0, 1.0};

Colour grey(int level) {
    const double part = level / 255.0;
    return {part, part, part};
}

// Values from WCAG's techniques and checkers: on white, #767676 is the lightest grey allowed for
// text, #949494 the lightest allowed for graphical objects.
TEST(Contrast, OfGreysOnWhiteAgreesWithWcag) {
    EXPECT_NEAR(contrast(black, white), 21.0, 1e-5);
    EXPECT_EQ(contrast(white, white), 1.0);
    EXPECT_NEAR(contrast(grey(0x76), white), 4.54, 0.005);
    EXPECT_NEAR(contrast(white, grey(0x77)), 4.48, 0.005);
    EXPECT_NEAR(contrast(grey(0x94), white), 3.03, 0.005);
    EXPECT_NEAR(contrast(red, white), 4.00, 0.005);
    EXPECT_NEAR(contrast(blue, white), 8.59, 0.005);
}

// Published values of sRGB's primaries under D65.
TEST(Lab, OfPrimariesAgreesWithPublishedTables) {
    const auto is = [](const Colour& colour, double l, double a, double b) {
        const Eigen::Vector3d found = lab(colour);
        EXPECT_NEAR(found.x(), l, 0.02);
        EXPECT_NEAR(found.y(), a, 0.02);
        EXPECT_NEAR(found.z(), b, 0.02);
    };
    is(white, 100.0, 0.0, 0.0);
    is(black, 0.0, 0.0, 0.0);
    is(red, 53.24, 80.09, 67.20);
    is(green, 87.73, -86.18, 83.18);
    is(blue, 32.30, 79.19, -107.86);
    is(grey(128), 53.59, 0.0, 0.0);
}

TEST(Visions, DoNotChangeGreys) {
    for (const Vision& vision : visions())
        for (int row = 0; row < 3; ++row)
            EXPECT_NEAR(vision.seen_from_linear.row(row).sum(), 1.0, 2e-6) << vision.eye;
}

// Without red or green cones, a dark red and an olive of the same lightness look alike, though they
// differ strongly for normal vision; blue and yellow remain distinguishable.
TEST(LineDifference, IsSmallForConfusableColours) {
    const Colour brown{0.55, 0.32, 0.0}, olive{0.36, 0.40, 0.0};
    EXPECT_GT(line_difference(brown, olive, visions()[0]),
              2.0 * line_difference(brown, olive, visions()[2]));
    for (const Vision& vision : visions()) {
        EXPECT_EQ(line_difference(red, red, vision), 0.0);
        EXPECT_GT(line_difference(white, black, vision), 1.0);
    }
    EXPECT_EQ(grey_difference(red, red), 0.0);
    // ΔL* = 100 in units of 5.08 + 0.75/0.0741: half of 10.16 + 1.50/s.
    EXPECT_NEAR(grey_difference(white, black), 100.0 / (5.08 + 0.75 / (80.0 / 1080.0)), 1e-3);
}

}  // namespace
}  // namespace poinsot
