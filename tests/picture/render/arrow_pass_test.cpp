// Arrows and dots.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "pictures.h"

namespace poinsot::testing {
namespace {

TEST(ArrowPicture, HasTheAreaOfShaftAndHead) {
    Drawing drawing = flat_drawing(200, 100, 100.0);
    Arrow arrow;
    arrow.tail = {-80.0, -10.0, 0.0};
    arrow.tip = {80.0, 20.0, 0.0};
    arrow.shaft_px = 5.0;
    arrow.head_px = 17.0;
    arrow.head_length_px = 24.0;
    drawing.views[0].arrows.push_back(arrow);
    const double length = std::hypot(160.0, 30.0);
    const double expected = (length - 24.0) * 5.0 + 0.5 * 17.0 * 24.0;
    EXPECT_NEAR(covered_px(renderer().render(drawing)), expected, 0.005 * expected);
}

TEST(ArrowPicture, IsADiscWhenItPointsAtTheEye) {
    Drawing drawing = flat_drawing(100, 100, 100.0);
    for (const double way : {-1.0, 1.0}) {
        Arrow arrow;
        arrow.tail = {0.3, 0.2, -30.0 * way};
        arrow.tip = {0.3, 0.2, 30.0 * way};
        arrow.shaft_px = 4.0;
        arrow.head_px = 30.0;
        arrow.head_length_px = 26.0;
        drawing.views[0].arrows = {arrow};
        EXPECT_NEAR(covered_px(renderer().render(drawing)), std::numbers::pi * 225.0, 2.5) << way;
    }
}

// As for ω and ρ: the longer arrow is below, and the shorter one, which is drawn later, on top,
// whatever the rounding of either.
TEST(ArrowPicture, LaterOfTwoOnOneLineIsOnTop) {
    const CurveGeometry none = circle(9302, 0.1, -0.8);
    Drawing drawing = lecture_drawing(320, 180, none, none);
    View& view = drawing.views[0];
    view.planes.clear();
    view.ellipsoids.clear();
    view.curves.clear();
    view.dots.clear();
    const Eigen::Vector3d direction = Eigen::Vector3d(0.7, -0.9, 0.4).normalized();
    const auto picture = [&](double bits, bool long_first) {
        Arrow omega, rho;
        omega.tip = (1.0 + bits) * 1.3 * direction;
        omega.colour = {0.6, 0.1, 0.4};
        rho.tip = (1.0 - bits) * direction;
        rho.colour = {0.1, 0.2, 0.6};
        for (Arrow* arrow : {&omega, &rho}) {
            arrow->shaft_px = 4.0;
            arrow->head_px = 16.0;
            arrow->head_length_px = 26.0;
        }
        view.arrows = long_first ? std::vector{omega, rho} : std::vector{rho, omega};
        return renderer().render(drawing);
    };
    const Image rho_on_top = picture(0.0, true);
    const Image omega_on_top = picture(0.0, false);
    EXPECT_GT(n_different(rho_on_top, omega_on_top), 50u);
    for (int n = 1; n <= 8; ++n) {
        for (const double bits : {n * 0x1p-52, n * -0x1p-52}) {
            EXPECT_EQ(n_different(picture(bits, true), rho_on_top), 0u) << bits;
            EXPECT_EQ(n_different(picture(bits, false), omega_on_top), 0u) << bits;
        }
    }
}

TEST(ArrowPicture, IsSolidOutsideTheEllipsoid) {
    Drawing drawing = flat_drawing(200, 100, 100.0);
    View& view = drawing.views[0];
    view.background.alpha = drawing.background.alpha = 1.0;
    view.background.top = view.background.bottom = {1.0, 1.0, 1.0};
    Ellipsoid sphere = plain_ellipsoid(30.0 * Eigen::Matrix3d::Identity());
    sphere.colour = {1.0, 1.0, 1.0};
    view.ellipsoids.push_back(sphere);
    const Image bare = renderer().render(drawing);
    Arrow arrow;
    arrow.tip = {80.0, 0.0, 0.0};
    arrow.colour = {0.0, 0.0, 0.0};
    arrow.shaft_px = 8.0;
    arrow.head_px = 16.0;
    arrow.head_length_px = 26.0;
    arrow.hidden_opacity = 0.3;
    view.arrows.push_back(arrow);
    const Image image = renderer().render(drawing);
    const auto kept = [&](int x) {
        return std::pow(static_cast<double>(image.at(x, 50).g) / bare.at(x, 50).g, 2.2);
    };
    EXPECT_NEAR(kept(110), 0.7, 0.05);
    EXPECT_LT(kept(150), 0.2);
}

TEST(DotPicture, HasTheRequestedPositionAndSize) {
    const CurveGeometry none = circle(9301, 0.1, -0.8);
    Drawing drawing = lecture_drawing(1920, 1080, none, none);
    View& view = drawing.views[0];
    view.planes.clear();
    view.ellipsoids.clear();
    view.curves.clear();
    view.arrows.clear();
    view.background.alpha = drawing.background.alpha = 0.0;
    // The point of contact with the plane z = -0.8, projected by the definition of the camera.
    view.dots[0].at = {0.21, -0.13, -0.8};
    view.dots[0].radius_px = 6.0;
    const Camera& camera = view.camera;
    const Eigen::Vector3d forward = (camera.target - camera.eye).normalized();
    const Eigen::Vector3d right = forward.cross(camera.up).normalized();
    const Eigen::Vector3d down = forward.cross(right);
    const Eigen::Vector3d from_eye = view.dots[0].at - camera.eye;
    const double focal = 540.0 / std::tan(0.5 * camera.vertical_field_rad) / forward.dot(from_eye);
    const Eigen::Vector2d expected(960.0 + focal * right.dot(from_eye),
                                   540.0 + focal * down.dot(from_eye));
    const Image image = renderer().render(drawing);
    EXPECT_LT((middle_of(image) - expected).norm(), 0.02);
    EXPECT_NEAR(covered_px(image), std::numbers::pi * 36.0, 0.3);
}

}  // namespace
}  // namespace poinsot::testing
