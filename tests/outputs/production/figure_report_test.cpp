// The report of a journal's figure, for a drawing made by hand.
#include "production/vectors/figure_report.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "drawing/stage/type/labels.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

// A page of 60 by 30 points, two pixels a point, with one line and two labels.
Drawing page_with(TextCache& types) {
    static const CurveGeometry segment{1, {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}};
    Drawing drawing;
    drawing.width_px = 120;
    drawing.height_px = 60;
    drawing.background = {{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, 1.0};
    View view;
    view.width_px = 120;
    view.height_px = 60;
    Curve& line = view.curves.emplace_back();
    line.geometry = &segment;
    line.width_px = 1.5;
    line.colour = {0.0, 0.0, 0.0};
    Curve faint = line;  // a rule of a chart
    faint.colour = {0.9, 0.9, 0.9};
    faint.opacity = 0.4;
    faint.occlusion = Occlusion::none;
    view.curves.push_back(faint);
    Label word;
    word.mask = types.set("word", {.size_px = 20.0, .mode = TypeMode::text}).mask;
    word.top_left_px = {8.0, 30.0};
    word.colour = {0.0, 0.0, 0.0};
    Label axis;
    axis.mask = types.set("e_1", {.size_px = 18.0}).mask;
    axis.top_left_px = {70.0, 10.0};
    axis.colour = {0.5, 0.5, 0.5};
    view.labels = {word, axis};
    drawing.views.push_back(std::move(view));
    drawing.left_out = {"$\\omega_2$"};
    return drawing;
}

TEST(FigureReport, MeasuresLinesTypeContrastAndMargins) {
    TextCache types(installed_fonts());
    const Drawing drawing = page_with(types);
    const FigureReport report = report_on(drawing, 0.5);
    EXPECT_NEAR(report.width_mm, 60.0 * 25.4 / 72.0, 1e-12);
    EXPECT_NEAR(report.height_mm, 30.0 * 25.4 / 72.0, 1e-12);
    EXPECT_NEAR(report.least_line_pt, 0.75, 1e-12);
    EXPECT_NEAR(report.least_type_pt, 9.0, 1e-12);
    EXPECT_NEAR(report.least_script_pt, 0.7 * 9.0, 0.05);
    // WCAG: black on white has 21, and (0.5, 0.5, 0.5) of relative luminance 0.2140 has
    // 1.05 / 0.2640.
    EXPECT_NEAR(report.line_contrast, 21.0, 1e-4);
    EXPECT_NEAR(report.type_contrast, 3.977, 0.001);
    EXPECT_NEAR(report.margin_pt, 4.0, 1e-12);
    const std::string words = in_words(report);
    EXPECT_NE(words.find("size: 21.2 x 10.6 mm"), std::string::npos) << words;
    EXPECT_NE(words.find("least line: 0.75 pt"), std::string::npos) << words;
    EXPECT_NE(words.find("left out: \"ω₂\""), std::string::npos) << words;
}

// What fading makes of a colour is what the reader sees.
TEST(FigureReport, MeasuresTheContrastOfFadedTypeAndLines) {
    TextCache types(installed_fonts());
    Drawing drawing = page_with(types);
    View& view = drawing.views[0];
    view.labels[0].opacity = 0.5;  // black: light of 0.5 on white
    EXPECT_NEAR(report_on(drawing, 0.5).type_contrast, 1.05 / 0.55, 1e-6);
    view.curves[0].opacity = 0.8;
    EXPECT_NEAR(report_on(drawing, 0.5).line_contrast, 1.05 / 0.25, 1e-6);
    EXPECT_EQ(report_on(drawing, 0.5).hidden_contrast, 0.0) << "nothing hides a line";
    view.ellipsoids.emplace_back();
    view.curves[0].hidden_opacity = 0.25;
    const FigureReport report = report_on(drawing, 0.5);
    EXPECT_NEAR(report.hidden_contrast, 1.05 / 0.85, 1e-6);
    EXPECT_NE(in_words(report).find("lines 4.2 : 1, pale lines behind bodies 1.24 : 1"),
              std::string::npos)
        << in_words(report);
    view.curves[0].hidden = HiddenStyle::dashed;
    EXPECT_EQ(report_on(drawing, 0.5).hidden_contrast, 0.0);
}

TEST(FigureReport, SaysWhichNamesAreAbsent) {
    TextCache types(installed_fonts());
    Drawing drawing = page_with(types);
    drawing.unnamed = {{"herpolhode"}, {"polhode", false}};
    EXPECT_NE(in_words(report_on(drawing, 0.5))
                  .find("the name of herpolhode, the name of polhode (too little in sight)"),
              std::string::npos);
    // Another panel has the name.
    drawing.views[0].labels[0].name = {"polhode", 0, ""};
    EXPECT_EQ(in_words(report_on(drawing, 0.5)).find("polhode (too"), std::string::npos);
}

// Where a body hides a line, its dashes are thinner than the line.
TEST(FigureReport, CountsTheThinnerDashesOfHiddenLines) {
    TextCache types(installed_fonts());
    Drawing drawing = page_with(types);
    Curve& line = drawing.views[0].curves[0];
    line.hidden = HiddenStyle::dashed;
    line.hidden_share = 0.8;
    EXPECT_NEAR(report_on(drawing, 0.5).least_line_pt, 0.6, 1e-12);
}

TEST(FigureReport, SaysWhenThereIsNothing) {
    Drawing drawing;
    drawing.width_px = drawing.height_px = 100;
    const std::string words = in_words(report_on(drawing, 1.0));
    EXPECT_NE(words.find("least line: none"), std::string::npos) << words;
    EXPECT_NE(words.find("left out: nothing"), std::string::npos) << words;
}

}  // namespace
}  // namespace poinsot
