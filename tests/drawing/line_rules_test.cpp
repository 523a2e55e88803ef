// How lines are drawn where something hides them and where they pass under others; on paper, none
// is too thin and no type too small.
#include "drawing/line_rules.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawing/type/labels.h"
#include "scenes_by_hand.h"

namespace poinsot {
namespace {

// 85 mm at 300 dots an inch: 8 pt, 6 pt and half a point.
constexpr LeastSizes least{33.3, 25.0, 2.08};

// A scene's drawing of that size, with what it refers to.
struct OnPaper {
    Motion motion;
    Stage stage;
    Drawing drawing;

    OnPaper(const Scene& scene, const LeastSizes& sizes)
        : motion(problem_of(scene)),
          stage(scene, motion,
                {.width_px = 1004,
                 .height_px = 565,
                 .line_scale = 1.04,
                 .least = sizes,
                 .last_time_s = 10.0}),
          drawing(stage.at(5.0)) {}
};

// Of the lines that there are: a width of 0 is none.
double thinnest_px(const Drawing& drawing) {
    double px = 1e9;
    const auto take = [&px](double width_px) {
        if (width_px > 0.0) px = std::min(px, width_px);
    };
    for (const View& view : drawing.views) {
        for (const Curve& curve : view.curves) take(curve.width_px);
        for (const Arrow& arrow : view.arrows) take(arrow.shaft_px);
        for (const Plane& plane : view.planes) take(plane.grid_px);
        for (const Dot& dot : view.dots) take(dot.rim_px);
        for (const Ellipsoid& ellipsoid : view.ellipsoids) {
            take(ellipsoid.ruling_px);
            take(ellipsoid.section_px);
        }
    }
    return px;
}

double smallest_letter_px(const Drawing& drawing) {
    double px = 1e9;
    for (const View& view : drawing.views)
        for (const Label& label : view.labels)
            for (const MaskLetter& letter : label.mask->letters) px = std::min(px, letter.em_px);
    return px;
}

TEST(LineRules, OnPaperNoLineIsThinnerAndNoTypeSmaller) {
    for (const char* panel : {"space", "body", "plan", "plot"}) {
        const Scene scene = free_scene({1.0, 1.8, 2.6}, {1.3, 0.9, 0.8}, panel);
        const OnPaper small(scene, {}), paper(scene, least);
        const Drawing& drawing = paper.drawing;
        EXPECT_LT(thinnest_px(small.drawing), least.line_px) << panel;
        EXPECT_GE(thinnest_px(drawing), least.line_px) << panel;
        EXPECT_GE(smallest_letter_px(drawing), least.script_px - 1e-9) << panel;
        for (const View& view : drawing.views)
            for (const Label& label : view.labels)
                EXPECT_GE(label.mask->source.em_px, least.type_px - 1e-9) << panel;
    }
}

TEST(LineRules, AStringIsSetLargerForItsScripts) {
    TypeCase plain(1, {20.0, 0.0, 0.0}), scripts(1, {20.0, 18.0, 0.0});
    for (const char* text : {"I_1", "\\mathrm{kg}\\,\\mathrm{m}^2", "x^{a_b}"}) {
        const SetType before = plain.set(text, {.size_px = 10.0});
        EXPECT_DOUBLE_EQ(before.mask->source.em_px, 20.0);
        const SetType after = scripts.set(text, {.size_px = 10.0});
        double least_px = 1e9;
        for (const MaskLetter& letter : after.mask->letters)
            least_px = std::min(least_px, letter.em_px);
        EXPECT_NEAR(least_px, 18.0, 1e-9) << text;
    }
    EXPECT_DOUBLE_EQ(scripts.set("I", {.size_px = 10.0}).mask->source.em_px, 20.0);
    EXPECT_DOUBLE_EQ(scripts.set("I_1", {.size_px = 40.0}).mask->source.em_px, 40.0);
}

}  // namespace
}  // namespace poinsot
