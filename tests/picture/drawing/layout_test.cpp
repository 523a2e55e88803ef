// Places of panels and text, at any size.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "drawing/stage/panel.h"
#include "drawing/stage/type/labels.h"
#include "panels_by_hand.h"
#include "scenes_by_hand.h"

namespace poinsot::panels_tests {
namespace {

TEST(Layout, PanelsLeaveSpaceForTitleAndCaption) {
    Scene scene = free_scene(generic_moments, generic_omega, "body");
    scene.title = "Title";
    scene.caption = "Caption";
    PanelSpec plot;
    plot.kind = "plot";
    plot.row = 1;
    scene.grid.rows = {2.0, 1.0};
    scene.panels.push_back(plot);
    const StagedScene staged(scene, 1.0);
    const Drawing drawing = staged.stage.at(1.0);
    ASSERT_EQ(drawing.views.size(), 3u);
    const View& body = drawing.views[0];
    const View& below = drawing.views[1];
    EXPECT_GT(body.y_px, 0);
    EXPECT_EQ(body.y_px + body.height_px, below.y_px);
    EXPECT_LT(below.y_px + below.height_px, scene.film.height_px);
    EXPECT_NEAR(body.height_px, 2.0 * below.height_px, 2.0);
    // The overlays' text is in the reserved bands.
    for (const Label& label : drawing.views[2].labels) {
        const double bottom = label.top_left_px.y() + label.mask->height;
        EXPECT_TRUE(bottom <= body.y_px || label.top_left_px.y() >= below.y_px + below.height_px)
            << label.top_left_px.transpose();
    }
}

TEST(Layout, TitlesEndBeforeTheClockInUprightPictures) {
    Scene scene = free_scene(generic_moments, generic_omega, "body");
    scene.title = "Sphere and ellipsoid of momentum";
    scene.clock = true;
    const auto place = [&scene](int width_px, int height_px) {
        scene.film.width_px = width_px;
        scene.film.height_px = height_px;
        const StagedScene staged(scene, 1.0);
        const Drawing drawing = staged.stage.at(1.0);
        const Label *title = nullptr, *clock = nullptr;
        for (const Label& label : drawing.views.back().labels) {
            if (label.rank == rank_of_title) title = &label;
            if (label.rank == rank_of_clock) clock = &label;
        }
        EXPECT_TRUE(title != nullptr && clock != nullptr);
        if (title == nullptr || clock == nullptr) return std::pair(0.0, 0.0);
        return std::pair(title->top_left_px.x() + title->mask->width - clock->top_left_px.x(),
                         title->mask->height / static_cast<double>(height_px));
    };
    const auto [wide_px, wide_share] = place(1280, 720);
    const auto [upright_px, upright_share] = place(780, 1280);
    EXPECT_LT(wide_px, 0.0);
    EXPECT_LT(upright_px, 0.0);
    EXPECT_LT(upright_share, wide_share);
}

// A heading that is the name of a thing follows the scene's own name for it.
TEST(Layout, HeadingsHaveTheScenesOwnNames) {
    Scene scene = free_scene(generic_moments, generic_omega, "space");
    scene.language = "de";
    scene.panels.push_back({});
    scene.panels[1].kind = "plan";
    scene.panels[1].column = 1;
    scene.grid.columns = {1.0, 1.0};
    const auto headings = [&scene] {
        std::vector<std::string> found;
        const StagedScene staged(scene, 1.0);
        const Drawing drawing = staged.stage.at(1.0);
        for (const View& view : drawing.views)
            for (const Label& label : view.labels)
                if (label.rank == rank_of_headings) found.push_back(label.mask->source.text);
        return found;
    };
    using Headings = std::vector<std::string>;
    EXPECT_EQ(headings(), (Headings{"Invariable Ebene", "Herpolhodie"}));
    scene.symbols.things["invariable-plane"] = "feste Ebene";
    scene.symbols.things["herpolhode"] = "ähnliche Kurve";
    EXPECT_EQ(headings(), (Headings{"Feste Ebene", "Ähnliche Kurve"}));
    // A name that is left out leaves the heading; a title of the panel's own has precedence.
    scene.symbols.things["invariable-plane"] = "";
    scene.panels[1].title = "Von oben";
    EXPECT_EQ(headings(), (Headings{"Invariable Ebene", "Von oben"}));
}

// In reading order, whatever the order of the list.
TEST(Layout, LettersOfPanelsFollowTheirPlaces) {
    Scene scene = free_scene(generic_moments, generic_omega, "body");
    scene.panels[0].row = 1;
    PanelSpec plot;
    plot.kind = "plot";
    scene.grid.rows = {1.0, 1.0};
    scene.panels.push_back(plot);
    const auto headings = [&scene] {
        const StagedScene staged(scene, 1.0);
        const Drawing drawing = staged.stage.at(1.0);
        std::vector<std::string> found;
        for (const View& view : drawing.views)
            for (const Label& label : view.labels)
                if (label.rank == rank_of_headings) found.push_back(label.mask->source.text);
        return found;
    };
    EXPECT_EQ(headings().front().find('('), std::string::npos);
    scene.panel_letters = true;
    const std::vector<std::string> lettered = headings();
    ASSERT_EQ(lettered.size(), 2u);
    EXPECT_TRUE(lettered[0].starts_with("(b) ")) << lettered[0];
    EXPECT_TRUE(lettered[1].starts_with("(a) ")) << lettered[1];
}

// The text in a view lies outside of a part of the picture.
void expect_outside(const View& view, const LabelBox& part) {
    for (const Label& label : view.labels) {
        const double apart_px = label_box(label).distance(part);
        EXPECT_TRUE(apart_px >= -1.0 || label.opacity < 0.1) << label.mask->source.text << apart_px;
    }
}

TEST(Layout, InsetsStandInTheirCornersAndTextKeepsOffThem) {
    for (const std::string corner : {"top left", "top right", "bottom left", "bottom right"})
        for (const bool has_chart : {false, true}) {
            Scene scene = free_scene(generic_moments, generic_omega, "space");
            scene.names.reset();
            scene.title = "Title";
            scene.caption = "Caption";
            scene.panels[0].inset = corner;
            if (has_chart) {
                PanelSpec& plot = scene.panels.emplace_back();
                plot.kind = "plot";
                plot.column = 1;
                scene.grid.columns = {1.0, 1.0};
            }
            SCOPED_TRACE(corner);
            const StagedScene staged(scene, 5.0);
            const Drawing drawing = staged.stage.at(5.0);
            ASSERT_EQ(drawing.views.size(), has_chart ? 4u : 3u);
            const View& space = drawing.views[0];
            const View& inset = drawing.views[drawing.views.size() - 2];
            EXPECT_EQ(inset.name, "plan");
            const Eigen::Vector2d half_px = 0.5 * Eigen::Vector2d(inset.width_px, inset.height_px),
                                  host_px = 0.5 * Eigen::Vector2d(space.width_px, space.height_px),
                                  centre_px = Eigen::Vector2d(inset.x_px, inset.y_px) + half_px;
            const Eigen::Vector2d offset_px =
                centre_px - Eigen::Vector2d(space.x_px, space.y_px) - host_px;
            EXPECT_EQ(offset_px.x() > 0.0, corner.ends_with("right"));
            EXPECT_EQ(offset_px.y() > 0.0, corner.starts_with("bottom"));
            EXPECT_TRUE(((offset_px.cwiseAbs() + half_px).array() <= host_px.array()).all());
            const LabelBox box{centre_px, half_px};
            expect_outside(space, box);
            expect_outside(drawing.views.back(), box);
        }
}

// The camera's side of the plane is told in words, in the scene's language.
TEST(Layout, InsetsSayFromWhereTheyAreSeen) {
    Scene scene = free_scene(generic_moments, generic_omega, "space");
    scene.panels[0].inset = "top left";
    const auto text = [&scene] {
        const StagedScene staged(scene, 1.0);
        const Drawing drawing = staged.stage.at(1.0);
        for (const Label& label : drawing.views.at(1).labels)
            if (label.rank == rank_of_charts) return label.mask->source.text;
        return std::string();
    };
    EXPECT_EQ(text(), "from above");
    scene.camera.elevation_deg = -50.0;
    scene.language = "de";
    EXPECT_EQ(text(), "von unten");
}

TEST(Layout, InsetsFadeByNameAndNeedAFreeBody) {
    Scene scene = free_scene(generic_moments, generic_omega, "space");
    FadeSpec& fade = scene.fades.emplace_back();
    fade.elements = {"inset"};
    fade.opacity = 0.0;
    EXPECT_THROW(StagedScene(scene, 5.0), InputError);  // there is none
    scene.panels[0].inset = "top left";
    EXPECT_TRUE(StagedScene(scene, 5.0).stage.at(5.0).views.at(1).curves.empty());
    // In a still, words are whole or absent.
    for (const double opacity : {0.3, 0.7}) {
        scene.fades[0].opacity = opacity;
        const StagedScene still(scene, 5.0, 0.0, true);
        const Drawing drawing = still.stage.at(5.0);
        std::size_t n_words = 0;
        for (const Label& label : drawing.views.at(1).labels)
            if (label.rank == rank_of_charts) {
                EXPECT_EQ(label.opacity, 1.0);
                ++n_words;
            }
        EXPECT_EQ(n_words, opacity > 0.5 ? 1u : 0u);
    }
    fade.opacity = 0.0;
    scene.fades.clear();
    EXPECT_FALSE(StagedScene(scene, 5.0).stage.at(5.0).views.at(1).curves.empty());
    scene.torque = InternalFriction{0.1};
    scene.method.name = "dopri5";
    try {
        const StagedScene staged(scene, 5.0);
        ADD_FAILURE() << "a herpolhode with friction";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("panels[0].inset needs a torque-free body"),
                  std::string::npos)
            << error.what();
    }
}

TEST(Layout, WithoutOverlaysPanelsHaveTheWholePicture) {
    Scene scene = free_scene(generic_moments, generic_omega, "body");
    scene.title = "Title";
    scene.caption = "Caption";
    scene.clock = true;
    scene.captions.emplace_back().text = "Timed";
    scene.panels.push_back(scene.panels[0]);
    scene.panels[1].row = 1;
    scene.grid.rows = {1.0, 1.0};
    scene.overlays = false;
    const StagedScene staged(scene, 1.0);
    const Drawing drawing = staged.stage.at(1.0);
    ASSERT_EQ(drawing.views.size(), 2u);  // no view of overlays
    EXPECT_EQ(drawing.views[0].y_px, 0);
    EXPECT_EQ(drawing.views[1].y_px + drawing.views[1].height_px, drawing.height_px);
}

TEST(Layout, NumbersOfAChartDoNotOverlapAtAnyHeight) {
    // Three stacked charts.
    for (const int height : {100, 180, 240, 400}) {
        Scene scene = top_scene({.theta_rad = 0.7, .omega3_rad_s = 5.0}, "plot");
        scene.panels[0].quantity = "euler_angles";
        scene.film.width_px = 640;
        scene.film.height_px = height;
        const StagedScene staged(scene, 1.0);
        const Drawing drawing = staged.stage.at(1.0);
        // The numbers of the values are right-aligned, up to a pixel of rounding.
        const std::vector<Label>& labels = view_of(drawing).labels;
        const auto right = [](const Label& label) {
            return label.top_left_px.x() + label.mask->width;
        };
        int n_pairs = 0;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (std::abs(right(labels[i]) - right(labels[j])) > 1.0) continue;
                const bool above = labels[i].top_left_px.y() < labels[j].top_left_px.y();
                const Label& upper = above ? labels[i] : labels[j];
                const Label& lower = above ? labels[j] : labels[i];
                EXPECT_LE(upper.top_left_px.y() + upper.mask->height, lower.top_left_px.y() + 1.0)
                    << height;
                ++n_pairs;
            }
        }
        EXPECT_TRUE(n_pairs > 0 || height < 400);
    }
}

TEST(Layout, LabelsAreInsideTheirPanelAtAnySize) {
    for (const PanelKind& kind : panel_kinds()) {
        Scene scene = scene_for(kind);
        scene.show = {"polhode", "ellipsoid", "momentum", "axes", "omega"};  // no overlays
        if (kind.name == "sweep") scene.show = {"caption"};
        for (const auto& [width, height] :
             std::vector<std::pair<int, int>>{{320, 180}, {640, 360}, {1920, 1080}, {500, 900}}) {
            scene.film.width_px = width;
            scene.film.height_px = height;
            const StagedScene staged(scene, 1.0);
            const Drawing drawing = staged.stage.at(1.0);
            for (const Label& label : view_of(drawing).labels) {
                EXPECT_GE(label.top_left_px.x(), 0.0) << kind.name << " " << width;
                EXPECT_GE(label.top_left_px.y(), 0.0) << kind.name << " " << width;
                EXPECT_LE(label.top_left_px.x() + label.mask->width, width)
                    << kind.name << " " << width;
                EXPECT_LE(label.top_left_px.y() + label.mask->height, height)
                    << kind.name << " " << width;
            }
        }
    }
}

}  // namespace
}  // namespace poinsot::panels_tests
