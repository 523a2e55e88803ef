// Surfaces that are not filled: their contours, against closed forms.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "pinhole.h"
#include "random_views.h"
#include "vector/picture.h"

namespace poinsot::vector {
namespace {

constexpr double pi = std::numbers::pi;

SheetOfPaper line_drawing(const View& view) {
    Drawing drawing;
    drawing.width_px = view.width_px;
    drawing.height_px = view.height_px;
    drawing.background.top = drawing.background.bottom = {1.0, 1.0, 1.0};
    drawing.views = {view};
    drawing.views[0].background = drawing.background;
    return paper_of(drawing, {.pt_per_px = print_pt_per_px, .shading = Shading::none});
}

std::vector<Stroke> strokes_of(const SheetOfPaper& paper) {
    std::vector<Stroke> strokes;
    for (const Item& item : paper.items)
        if (const auto* stroke = std::get_if<Stroke>(&item)) strokes.push_back(*stroke);
    return strokes;
}

// The points where the pieces of a path end.
std::vector<Eigen::Vector2d> ends_px(const Stroke& stroke) {
    std::vector<Eigen::Vector2d> ends;
    for (const Step& step : stroke.path.steps)
        if (step.kind != Step::Kind::close) ends.push_back(step.to / print_pt_per_px);
    return ends;
}

// WCAG 2.1's contrast ratio with white.
double contrast_with_white(const Colour& c) {
    const auto light = [](double x) {
        return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    };
    return 1.05 / (0.2126 * light(c.r) + 0.7152 * light(c.g) + 0.0722 * light(c.b) + 0.05);
}

// The silhouette of x'Qx = 0 from the eye e is x'(Q e e'Q - (e'Qe) Q) x = 0: the double roots of
// the quadratic along a line of sight. A sphere without lines of its own has it, too.
TEST(Contours, OfAnEllipsoidIsTheKnownConic) {
    RandomViews random(7);
    int n_seen = 0;
    for (int k = 1; k < 40; ++k) {
        View view = random.view(k);
        if (view.camera.orthographic || k % 4 == 0 || k % 7 == 0) continue;
        view.planes.clear();
        Ellipsoid& shape = view.ellipsoids[0];
        shape.section_px = shape.ruling_px = 0.0;
        shape.colour = {0.77, 0.79, 0.81};
        const Eigen::Matrix3d axes = shape.half_axes;
        const Eigen::Matrix3d q = (axes * axes.transpose()).inverse();
        const Eigen::Vector3d o = view.camera.eye - shape.centre;
        if (!(o.dot(q * o) > 1.1)) continue;
        const std::vector<Stroke> strokes = strokes_of(line_drawing(view));
        ASSERT_EQ(strokes.size(), 1u) << k;
        ++n_seen;
        EXPECT_GE(strokes[0].width_pt, 0.5);
        EXPECT_GE(contrast_with_white(strokes[0].ink.colour), 3.0 - 1e-9);
        EXPECT_EQ(strokes[0].ink.alpha, 1.0);

        // The direction of the line of sight through a place of the picture.
        const Eigen::Vector3d forward = (view.camera.target - view.camera.eye).normalized();
        const Eigen::Vector3d right = forward.cross(view.camera.up).normalized();
        const Eigen::Vector3d down = forward.cross(right);
        const double unit = std::tan(0.5 * view.camera.vertical_field_rad) / (0.5 * view.height_px);
        Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
        for (const Eigen::Vector2d& at : ends_px(strokes[0])) {
            const Eigen::Vector2d off =
                unit * (at - 0.5 * Eigen::Vector2d(view.width_px, view.height_px));
            const Eigen::Vector3d d = forward + off.x() * right + off.y() * down;
            const double square = std::pow(d.dot(q * o), 2);
            EXPECT_NEAR(square / (d.dot(q * d) * (o.dot(q * o) - 1.0)), 1.0, 1e-9) << k;
            low = low.cwiseMin(at), high = high.cwiseMax(at);
        }
        // It goes all round.
        EXPECT_GT((high - low).minCoeff(), 20.0);
    }
    EXPECT_GT(n_seen, 10);
}

// The rim and the two generators that touch it in the picture, in the cone's colour.
TEST(Contours, OfAConeAreItsRimAndTwoGenerators) {
    RandomViews random(8);
    int n_generators = 0, n_without = 0;
    for (int k = 0; k < 60; ++k) {
        View view = random.view(k);
        view.camera.orthographic = false;
        view.planes.clear();
        view.ellipsoids.clear();
        Cone cone;
        cone.axis = random.direction();
        cone.reference = cone.axis.unitOrthogonal();
        cone.half_angle_rad = random.between(0.2, 1.0);
        cone.length = random.between(0.3, 0.6);
        cone.colour = {0.37, 0.1, 0.2};
        view.cones.push_back(cone);
        const std::vector<Stroke> strokes = strokes_of(line_drawing(view));

        const testing::Pinhole pinhole(view);
        const Eigen::Vector3d second = cone.axis.cross(cone.reference);
        const double radius = cone.length * std::tan(cone.half_angle_rad);
        std::vector<Eigen::Vector2d> rim;
        for (int i = 0; i < 720; ++i) {
            const double s = 2.0 * pi * i / 720.0;
            rim.push_back(
                pinhole.place(cone.length * cone.axis +
                              radius * (std::cos(s) * cone.reference + std::sin(s) * second)));
        }
        const Eigen::Vector2d apex = pinhole.place(cone.apex);
        ASSERT_TRUE(strokes.size() == 1 || strokes.size() == 3) << k;
        for (const Stroke& stroke : strokes) {
            EXPECT_TRUE(stroke.ink.colour == cone.colour);
            EXPECT_GE(stroke.width_pt, 0.8);
        }
        n_without += strokes.size() == 1 ? 1 : 0;
        for (std::size_t i = 1; i < strokes.size(); ++i) {
            const std::vector<Eigen::Vector2d> ends = ends_px(strokes[i]);
            ASSERT_GE(ends.size(), 2u);
            EXPECT_LT((ends.front() - apex).norm(), 1e-6);
            // The whole rim is on one side.
            const Eigen::Vector2d along = (ends.back() - apex).normalized();
            double least = 1e9, most = -1e9;
            for (const Eigen::Vector2d& at : rim) {
                const double side = along.x() * (at - apex).y() - along.y() * (at - apex).x();
                least = std::min(least, side), most = std::max(most, side);
            }
            // Between two points of the rim it may pass by their chord's height.
            EXPECT_LT(std::min(std::abs(least), std::abs(most)), 0.05) << k;
            EXPECT_GT(std::max(std::abs(least), std::abs(most)), 1.0) << k;
            ++n_generators;
        }
    }
    EXPECT_GT(n_generators, 40);
    EXPECT_GT(n_without, 2);
}

}  // namespace
}  // namespace poinsot::vector
