// The distance of arrows in a picture, and the picture chosen by it.
#include "shapes/arrow_separation.h"

#include <gtest/gtest.h>

#include <vector>

#include "shapes/projection.h"

namespace poinsot {
namespace {

// An arrow in the plane of the picture.
PlacedArrow arrow(int index, Eigen::Vector2d tail, Eigen::Vector2d tip) {
    const Eigen::Vector2d way = (tip - tail).normalized();
    return {0, index, tail, tip, {way.x(), way.y(), 0.0}};
}

using Picture = std::vector<PlacedArrow>;

TEST(ArrowSeparation, IsTheSmallerDistanceOfATipFromTheOtherArrow) {
    const PlacedArrow up = arrow(0, {0, 0}, {0, 100});
    EXPECT_EQ(separation_px(up, arrow(1, {0, 0}, {0, 40})), 0.0);
    EXPECT_EQ(separation_px(up, arrow(1, {0, 0}, {30, 40})), 30.0);
    EXPECT_EQ(separation_px(up, arrow(1, {0, 0}, {0, -50})), 50.0);
    EXPECT_EQ(separation_px(arrow(1, {0, 0}, {0, -50}), up), 50.0);
    // Arrows may cross.
    EXPECT_EQ(separation_px(up, arrow(1, {-50, 50}, {50, 50})), 50.0);
}

TEST(ArrowSeparation, OfPlacedArrowsIsAsTheCameraSeesThem) {
    View view;
    view.x_px = 10, view.y_px = 20, view.width_px = 200, view.height_px = 100;
    view.camera.eye = {0.0, 0.0, 5.0};
    view.camera.target = {0.0, 0.0, 0.0};
    view.camera.up = {0.0, 1.0, 0.0};
    Arrow one;
    one.tip = {1.0, 0.0, 0.0};
    Arrow towards_eye;  // longer, but seen as a point
    towards_eye.tip = {0.0, 0.0, 2.0};
    Arrow faded = one;
    faded.opacity = 0.0;
    Arrow behind;
    behind.tail = {0.0, 0.0, 6.0};
    behind.tip = {0.0, 0.0, 7.0};
    view.arrows = {faded, one, towards_eye, behind};
    Picture arrows;
    append_arrows(view, 3, arrows);
    ASSERT_EQ(arrows.size(), 2u);
    EXPECT_EQ(arrows[0].view, 3);
    EXPECT_EQ(arrows[0].index, 1);
    EXPECT_EQ(arrows[0].tip_px, project(view, one.tip).px);
    EXPECT_EQ(arrows[0].tail_px, Eigen::Vector2d(110.0, 70.0));
    EXPECT_NEAR(separation_px(arrows[0], arrows[1]), 0.0, 1e-12);
}

TEST(ArrowSeparation, ChoosesTheClearestPictureAndTheLastOfEquals) {
    const PlacedArrow up = arrow(0, {0, 0}, {0, 100});
    const auto at = [&](double x) { return Picture{up, arrow(1, {0, 0}, {x, 80})}; };
    const std::vector<Picture> one{at(3), at(30), at(12), at(0.1)};
    EXPECT_EQ(clearest_picture(one, 1.0, 40.0), 1u);
    // What is beyond "enough" is equal, and so is what rounds to the same step.
    const std::vector<Picture> enough{at(300), at(41), at(60), at(39)};
    EXPECT_EQ(clearest_picture(enough, 1.0, 40.0), 2u);
    const std::vector<Picture> noise{at(20.3), at(20.2), at(20.1)};
    EXPECT_EQ(clearest_picture(noise, 1.0, 40.0), 2u);
    const std::vector<Picture> empty(3);
    EXPECT_EQ(clearest_picture(empty, 1.0, 40.0), 2u);
}

TEST(ArrowSeparation, LeavesOutArrowsThatAreAlwaysParallel) {
    // The second arrow lies on the first in every picture; the third is apart from them in one.
    const auto with_third = [](double x) {
        return Picture{arrow(0, {0, 0}, {0, 100}), arrow(1, {0, 0}, {0, 60}),
                       arrow(2, {0, 0}, {x, 60})};
    };
    const std::vector<Picture> pictures{with_third(2), with_third(35), with_third(5)};
    EXPECT_EQ(clearest_picture(pictures, 1.0, 40.0), 1u);
    // Parallel in one picture only: they coincide there.
    const std::vector<Picture> passing{with_third(20), with_third(0)};
    EXPECT_EQ(clearest_picture(passing, 1.0, 40.0), 0u);
}

}  // namespace
}  // namespace poinsot
