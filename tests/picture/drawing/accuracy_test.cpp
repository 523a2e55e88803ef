// Conversion of accuracy_px to other units, compared with the picture.
#include "drawing/stage/accuracy.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/stage_context.h"
#include "scenes_by_hand.h"
#include "shapes/projection.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

// The tips of the longest arrows, rotated by a small angle about any axis, move by no more pixels
// than the motion's share of the accuracy; tips near the eye move by a large part of it.
TEST(Accuracy, MotionErrorIsAnUpperBoundInThePicture) {
    Scene scene = free_scene({1.0, 2.0, 2.9}, {1.4, 0.5, 1.6}, "space");
    scene.accuracy_px = 0.25;
    scene.camera.target = Eigen::Vector3d::Zero();
    const Accuracy accuracy = accuracy_of(scene);
    EXPECT_EQ(accuracy.asked_px, 0.25);
    const StagedScene staged(scene, 10.0);
    const Drawing drawing = staged.stage.at(0.0);
    const View& view = drawing.views.front();
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    const auto direction = [&] {
        return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    };
    constexpr double angle_rad = 1e-6;
    double most_px = 0.0;
    for (int k = 0; k < 20'000; ++k) {
        const Eigen::Vector3d tip = longest_arrow_length * direction();
        const Eigen::Vector3d turned = Eigen::AngleAxisd(angle_rad, direction()) * tip;
        most_px = std::max(most_px, (project(view, turned).px - project(view, tip).px).norm());
    }
    const double rad_that_moves_the_asked = angle_rad * accuracy.asked_px / most_px;
    EXPECT_LE(accuracy.motion_rad(), rad_that_moves_the_asked * (1.0 + 1e-4));
    EXPECT_GE(accuracy.motion_rad(), 0.5 * rad_that_moves_the_asked);
}

// A supersampled picture has the same error in final pixels.
TEST(Accuracy, CurveErrorIsHalfOfTheRequestedOne) {
    Scene scene = free_scene({1.0, 2.0, 2.9}, {1.4, 0.5, 1.6}, "space");
    scene.accuracy_px = 0.2;
    const Motion motion(problem_of(scene));
    EXPECT_EQ(accuracy_of(scene).curve_px(), 0.1);
    StageOptions options{
        .width_px = 640, .height_px = 360, .last_time_s = 10.0, .fonts = installed_fonts()};
    EXPECT_EQ(Stage(scene, theme_of(scene), motion, options).curve_error_px(), 0.1);
    options.curve_px = accuracy_of(scene).curve_px(4.0);
    const Stage coarse(scene, theme_of(scene), motion, options);
    EXPECT_EQ(coarse.curve_error_px(), 0.4);
    EXPECT_EQ(coarse.context().scene.accuracy_px, 0.2);
}

}  // namespace
}  // namespace poinsot
