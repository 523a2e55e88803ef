// Text is legible from the back row, and line styles have one meaning.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drawing/stage/type/labels.h"
#include "drawing/style/theme.h"
#include "numerics/srgb.h"
#include "places.h"
#include "scene/files/load_scene.h"
#include "scenes_by_hand.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

// Luminance for WCAG's contrast ratio.
double luminance(const Colour& c) {
    return 0.2126 * linear_from_srgb(c.r) + 0.7152 * linear_from_srgb(c.g) +
           0.0722 * linear_from_srgb(c.b);
}
double contrast(double a, double b) { return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05); }

class Legible : public ::testing::Test {
 protected:
    static Scene scene_of(const std::filesystem::path& file) {
        Scene scene = load_scene(file, {});
        scene.film.duration_s = std::min(scene.film.duration_s.value_or(1.0), 1.0);
        scene.film.loop.clear();
        scene.fades.clear();
        scene.keyframes.clear();
        scene.chapters.clear();
        return scene;
    }
};

// In every scene, at two sizes: no text is smaller than 1/45 of the height.
TEST_F(Legible, TextOfAFilmIsAtLeastAFortyFifthOfItsHeight) {
    for (const auto& file : supplied_scenes()) {
        for (const auto& [width, height] : {std::pair{1920, 1080}, std::pair{640, 360}}) {
            Scene scene = scene_of(file);
            scene.film.width_px = width;
            scene.film.height_px = height;
            const Motion motion(problem_of(scene));
            std::optional<Motion> beside;
            if (scene.beside) {
                MotionProblem problem = motion.problem();
                problem.method = *scene.beside;
                beside.emplace(problem);
            }
            const Stage stage(scene, theme_of(scene), motion,
                              {.width_px = width,
                               .height_px = height,
                               .first_time_s = scene.film.start_s,
                               .last_time_s = scene.film.start_s + 1.0,
                               .fonts = installed_fonts()},
                              beside ? &*beside : nullptr);
            EXPECT_GE(stage.store().text().least_size_px(), height / 45.0 - 1e-9)
                << file.filename() << " " << height;
        }
    }
}

// Headings have less contrast than text, but enough to be legible.
TEST_F(Legible, HeadingsHaveAContrastOfFourAndAHalf) {
    Scene scene = free_scene({1.0, 2.0, 2.9}, {1.4, 0.5, 1.6}, "body");
    PanelSpec plan;
    plan.kind = "plan";
    plan.column = 1;
    scene.grid.columns = {1.0, 1.0};
    scene.panels.push_back(plan);
    for (const Theme& theme : themes()) {
        scene.theme = theme.name;
        const StagedScene staged(scene, 1.0);
        const Drawing drawing = staged.stage.at(0.5);
        for (std::size_t i = 0; i < 2; ++i)
            for (const Label& label : drawing.views[i].labels)
                for (const Colour& ground : {theme.background.top, theme.background.bottom}) {
                    // Blended in linear light.
                    const double ground_Y = luminance(ground);
                    const double seen =
                        ground_Y + label.opacity * (luminance(label.colour) - ground_Y);
                    const bool lit = theme.background.alpha >= 1.0;
                    EXPECT_TRUE(!lit || label.opacity > 0.99 || contrast(seen, ground_Y) >= 4.5)
                        << theme.name << " " << contrast(seen, ground_Y);
                }
    }
}

// Small letters of the names in a picture are a sixtieth of its height; their size is that of a
// lower-case x in Latin Modern Sans, 0.444 em (measured in the font's outlines). Titles of panels
// are as dark as the text, and no letter of a chart is larger than a name.
TEST_F(Legible, NamesAreReadFromTheLastRow) {
    Scene scene = free_scene({1.0, 2.0, 2.9}, {1.4, 0.5, 1.6}, "space");
    scene.names.reset();
    scene.film.width_px = 1280;
    scene.film.height_px = 720;
    const StagedScene staged(scene, 5.0, 0.0, true);
    const Drawing drawing = staged.stage.at(5.0);
    int n_names = 0;
    for (const Label& label : drawing.views[0].labels)
        if (!label.mask->source.is_formula) {
            EXPECT_GE(0.444 * label.mask->source.em_px, 720.0 / 60.0) << label.mask->source.text;
            ++n_names;
        }
    EXPECT_GE(n_names, 3);
    PanelSpec chart;
    chart.kind = "plot";
    chart.column = 1;
    scene.grid.columns = {1.0, 1.0};
    scene.panels.push_back(chart);
    const StagedScene two(scene, 5.0, 0.0, true);
    const Drawing panels = two.stage.at(5.0);
    double least_name_px = 1e9, largest_in_chart_px = 0.0;
    for (const Label& label : panels.views[0].labels) {
        if (label.rank == rank_of_things)
            least_name_px = std::min(least_name_px, label.mask->source.em_px);
        if (label.rank == rank_of_headings) {
            EXPECT_EQ(label.opacity, 1.0);
        }
    }
    for (const Label& label : panels.views[1].labels)
        largest_in_chart_px = std::max(largest_in_chart_px, label.mask->source.em_px);
    EXPECT_GT(largest_in_chart_px, 0.0);
    EXPECT_LE(largest_in_chart_px, least_name_px);
}

// A caption of several lines has lines of nearly equal length: no word stands alone.
TEST_F(Legible, CaptionsHaveBalancedLines) {
    Scene scene = free_scene({1.0, 2.0, 2.9}, {1.4, 0.5, 1.6}, "space");
    scene.film.width_px = 1280;
    scene.film.height_px = 720;
    const std::string words = "The contact point traces the polhode on the ellipsoid ";
    for (const char* const end : {"and the herpolhode on the plane",
                                  "and the herpolhode on the plane, which need not close"}) {
        scene.caption = words + words + end;
        const StagedScene staged(scene, 1.0, 0.0, true);
        const Drawing drawing = staged.stage.at(1.0);
        const Label* caption = nullptr;
        for (const Label& label : drawing.views.back().labels)
            if (label.rank == rank_of_caption) caption = &label;
        ASSERT_NE(caption, nullptr);
        // The right ends of the lines, by their letters.
        std::map<double, double> right_px;
        for (const MaskLetter& letter : caption->mask->letters)
            right_px[letter.baseline_px] = std::max(right_px[letter.baseline_px], letter.x_px);
        ASSERT_EQ(right_px.size(), 2u) << end;
        EXPECT_GT(right_px.rbegin()->second, 0.7 * right_px.begin()->second) << end;
    }
}

// Names and numbers in the figures, at the largest and least brightness of the background.
TEST_F(Legible, NamesInFiguresHaveAContrastOfFourAndAHalf) {
    std::vector<Scene> scenes;
    for (const char* panel : {"space", "body", "plan", "momentum", "object", "plot"})
        scenes.push_back(free_scene({1.0, 2.0, 2.9}, {1.4, 0.5, 1.6}, panel));
    for (const char* panel : {"top", "potential", "plot"})
        scenes.push_back(top_scene({0.7, 0.0, -0.6, 5.0}, panel));
    MarkSpec mark;
    mark.at = {1.0, 1.0, 1.0};
    mark.name = "P";
    mark.srgb = {0.9, 0.8, 0.2};
    scenes.front().marks = {mark};
    for (Scene& scene : scenes)
        for (const Theme& theme : themes()) {
            scene.theme = theme.name;
            const StagedScene staged(scene, 1.0);
            const Drawing drawing = staged.stage.at(0.5);
            std::vector<Colour> grounds{theme.halo};
            if (theme.background.alpha >= 1.0)
                grounds.insert(grounds.end(), {theme.background.top, theme.background.bottom});
            EXPECT_FALSE(drawing.views[0].labels.empty());
            for (const Label& label : drawing.views[0].labels)
                for (const Colour& ground : grounds) {
                    EXPECT_GE(contrast(luminance(label.colour), luminance(ground)), 4.5)
                        << theme.name << " " << scene.panels[0].kind;
                }
        }
}

// Dashes mean a hidden line, or a curve that is not the motion's.
TEST_F(Legible, HerpolhodeIsSolidInEveryTheme) {
    for (const char* panel : {"space", "plan"}) {
        Scene scene = free_scene({1.0, 2.0, 2.9}, {1.4, 0.5, 1.6}, panel);
        for (const Theme& theme : themes()) {
            scene.theme = theme.name;
            const StagedScene staged(scene, 5.0);
            const Drawing drawing = staged.stage.at(5.0);
            std::size_t n = 0;
            for (const Curve& curve : drawing.views[0].curves) {
                if (!(curve.colour == theme.herpolhode)) continue;
                EXPECT_EQ(curve.dash_px, 0.0) << theme.name << " " << panel;
                ++n;
            }
            EXPECT_GE(n, 1u) << theme.name << " " << panel;
        }
    }
}

// An arrow that points at the viewer is replaced by a ring with a dot.
TEST_F(Legible, ArrowTowardsTheViewerIsARingWithADot) {
    Scene scene = free_scene({1.0, 2.0, 2.9}, {1.4, 0.5, 1.6}, "body");
    scene.camera.projection = "orthographic";
    scene.panels[0].camera.azimuth_deg = 90.0;
    scene.panels[0].camera.elevation_deg = 0.0;
    const StagedScene staged(scene, 1.0);
    const View view = staged.stage.at(0.5).views[0];
    const Colour& colour = staged.stage.context().theme.axes[1];
    int n_dots = 0;
    const Arrow* axis = nullptr;
    for (const Arrow& arrow : view.arrows)
        if (arrow.colour == colour) axis = &arrow;
    ASSERT_NE(axis, nullptr);
    EXPECT_EQ(axis->opacity, 0.0);
    for (const Dot& dot : view.dots) {
        const bool at_tip = (dot.at - axis->tip).norm() < 0.01;
        n_dots +=
            at_tip && dot.opacity == 1.0 && (dot.colour == colour || dot.rim_colour == colour);
    }
    EXPECT_EQ(n_dots, 2);
    // From the side, it is an arrow.
    scene.panels[0].camera.azimuth_deg = 30.0;
    const View beside = StagedScene(scene, 1.0).stage.at(0.5).views[0];
    for (const Arrow& arrow : beside.arrows) EXPECT_EQ(arrow.opacity, 1.0);
}

// If the camera moves close, the letters of title and caption get a wide halo, and nothing else
// covers the figure; beside a framed figure the halo is narrow.
TEST_F(Legible, TitleAndCaptionHaveAQuietGroundBehindLettersOnly) {
    Scene scene = free_scene({1.0, 2.0, 2.9}, {1.4, 0.5, 1.6}, "space");
    scene.title = "A title";
    scene.caption = "A caption";
    const auto n_with_ground = [&scene] {
        int n = 0;
        const StagedScene staged(scene, 1.0);
        const Drawing drawing = staged.stage.at(0.5);
        for (const Label& label : drawing.views.back().labels) {
            EXPECT_FALSE(label.mask->letters.empty());  // letters, not an area
            n += label.over_figure && label.halo_px > 8.0 * staged.stage.context().px;
        }
        return n;
    };
    EXPECT_EQ(n_with_ground(), 0);
    scene.camera.look_at = "foot";
    scene.camera.distance = 3.3;
    EXPECT_EQ(n_with_ground(), 3);  // title, caption, clock
    scene.theme = "transparent";
    EXPECT_EQ(n_with_ground(), 0);
}

}  // namespace
}  // namespace poinsot
