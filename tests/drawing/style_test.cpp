// The effect of [style] on the drawing, omitted labels, and the user's own points.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "drawing/figures/charts/plot_quantity.h"
#include "drawing/figures/charts/plot_record.h"
#include "drawing/style/theme.h"
#include "drawing/style/theme_contrast.h"
#include "drawing/style/theme_roles.h"
#include "error/error.h"
#include "mechanics/half_life.h"
#include "scene/style_keys.h"
#include "scenes_by_hand.h"

namespace poinsot::style_tests {
namespace {

const Eigen::Vector3d moments{1.0, 2.0, 2.9};
const Eigen::Vector3d omega{1.4, 0.5, 1.6};

Scene a_scene(const std::string& panel = "space") { return free_scene(moments, omega, panel); }

// Only the view is returned: the stage's geometry, such as points of curves, is destroyed.
View view_of(const Scene& scene, double time_s = 0.0) {
    const StagedScene staged(scene, 10.0);
    return staged.stage.at(time_s).views.at(0);
}

LookSpec look(double r, double g, double b) {
    LookSpec spec;
    spec.srgb = {r, g, b};
    return spec;
}

const Arrow* arrow_in(const View& view, const Colour& colour) {
    for (const Arrow& arrow : view.arrows)
        if (arrow.colour == colour) return &arrow;
    return nullptr;
}
const Curve* curve_in(const View& view, const Colour& colour) {
    for (const Curve& curve : view.curves)
        if (curve.colour == colour) return &curve;
    return nullptr;
}

// What [style] can say of a role is what a theme keeps of it.
TEST(Style, ThemesKeepWhatEveryRoleCanSay) {
    Theme theme = theme_named("light");
    EXPECT_EQ(theme_roles().size(), style_roles().size());
    for (const StyleRole& role : style_roles()) {
        const auto places =
            std::count_if(theme_roles().begin(), theme_roles().end(),
                          [&role](const ThemeRole& place) { return place.name == role.name; });
        ASSERT_EQ(places, 1) << role.name;
        const RoleLook look = look_of(theme, role.name);
        EXPECT_NE(look.colour, nullptr) << role.name;
        EXPECT_EQ(look.opacity != nullptr, role.kind == StyleKind::surface) << role.name;
        EXPECT_TRUE(look.line != nullptr || role.kind != StyleKind::line) << role.name;
    }
}

// Each role sets a different member of a theme.
TEST(Style, EveryRoleChangesItsOwnMember) {
    for (const StyleRole& role : style_roles()) {
        Scene scene = a_scene();
        scene.style.looks[std::string(role.name)] = look(0.123, 0.456, 0.789);
        const Theme theme = theme_of(scene);
        const Theme& base = theme_named("light");
        const Colour wanted{0.123, 0.456, 0.789};
        int n_changed = 0;
        const auto compare = [&](const Colour& now, const Colour& before) {
            if (now == before) return;
            EXPECT_EQ(now, wanted) << role.name;
            ++n_changed;
        };
        compare(theme.text, base.text);
        compare(theme.halo, base.halo);
        compare(theme.background.bottom, base.background.bottom);
        compare(theme.background.top, base.background.top);
        compare(theme.ellipsoid, base.ellipsoid);
        compare(theme.ellipsoid_lines, base.ellipsoid_lines);
        compare(theme.plane, base.plane);
        compare(theme.grid, base.grid);
        for (const auto ink :
             {&Theme::polhode, &Theme::herpolhode, &Theme::momentum, &Theme::omega, &Theme::contact,
              &Theme::body_cone, &Theme::space_cone, &Theme::annulus, &Theme::separatrix,
              &Theme::ghost, &Theme::sphere, &Theme::solid, &Theme::solid_lines, &Theme::energy,
              &Theme::potential, &Theme::rule})
            compare(theme.*ink, base.*ink);
        for (int i = 0; i < 3; ++i) {
            compare(theme.axes[i], base.axes[i]);
            compare(theme.angles[i], base.angles[i]);
        }
        // A background is that of the picture and that of the text.
        EXPECT_EQ(n_changed, role.name == "ground" ? 3 : 1) << role.name;
    }
}

TEST(Style, SetsColourWeightAndLine) {
    const Colour red{1.0, 0.0, 0.0}, green{0.0, 1.0, 0.0};
    Scene scene = a_scene();
    const Arrow usual = *arrow_in(view_of(scene), theme_named("light").omega);
    const Curve usual_curve = *curve_in(view_of(scene, 5.0), theme_named("light").herpolhode);
    scene.style.looks["omega"] = look(1.0, 0.0, 0.0);
    scene.style.looks["omega"].weight = 1.5;
    scene.style.looks["herpolhode"] = look(0.0, 1.0, 0.0);
    scene.style.looks["herpolhode"].weight = 2.0;
    scene.style.looks["herpolhode"].line = "dashed";
    const View view = view_of(scene, 5.0);
    ASSERT_NE(arrow_in(view, red), nullptr);
    EXPECT_DOUBLE_EQ(arrow_in(view, red)->shaft_px, 1.5 * usual.shaft_px);
    ASSERT_NE(curve_in(view, green), nullptr);
    EXPECT_DOUBLE_EQ(curve_in(view, green)->width_px, 2.0 * usual_curve.width_px);
    EXPECT_EQ(usual_curve.dash_px, 0.0);
    EXPECT_GT(curve_in(view, green)->dash_px, 0.0);
}

TEST(Style, SetsAndRemovesTheBackground) {
    Scene scene = a_scene();
    scene.theme = "transparent";
    EXPECT_EQ(theme_of(scene).background.alpha, 0.0);
    scene.style.looks["ground"] = look(1.0, 0.0, 0.0);
    EXPECT_EQ(theme_of(scene).background.alpha, 1.0);
    scene.theme = "light";
    scene.style.looks["ground"] = {};
    scene.style.looks["ground"].opacity_percent = 0.0;
    EXPECT_EQ(theme_of(scene).background.alpha, 0.0);
}

TEST(Contrast, BuiltInThemesCauseNoNotes) {
    for (const Theme& theme : themes()) {
        Scene scene = a_scene();
        scene.theme = theme.name;
        // The theme's own values, given as a style.
        scene.style.looks["omega"] = look(theme.omega.r, theme.omega.g, theme.omega.b);
        scene.style.looks["text"] = look(theme.text.r, theme.text.g, theme.text.b);
        EXPECT_TRUE(contrast_notes(scene, theme_of(scene)).empty())
            << theme.name << contrast_notes(scene, theme_of(scene)).front();
    }
}

// #777777 on #ffffff has a contrast of 4.48, as in WCAG's own examples.
TEST(Contrast, LowContrastIsReportedInOneLine) {
    Scene scene = a_scene();
    scene.theme = "print";
    scene.locations["style.text"] = {"a.toml", 7, 1};
    scene.style.looks["text"] = look(0x77 / 255.0, 0x77 / 255.0, 0x77 / 255.0);
    const std::vector<std::string> notes = contrast_notes(scene, theme_of(scene));
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0],
              "a.toml:7:1: style.text: text on ground has a contrast of 4.48, less than 4.5");
}

TEST(Contrast, ConfusableColoursAreReported) {
    Scene scene = a_scene();
    const Theme& light = theme_named("light");
    scene.style.looks["omega"] = look(light.polhode.r, light.polhode.g, light.polhode.b);
    const std::vector<std::string> notes = contrast_notes(scene, theme_of(scene));
    ASSERT_FALSE(notes.empty());
    EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
        return note.find("polhode and omega hardly differ: 0.00") != std::string::npos;
    })) << notes.front();
}

TEST(Unlabelled, LabelsAreOmittedWhileTheElementIsShown) {
    Scene scene = a_scene();
    scene.title.clear();
    const View with = view_of(scene);
    scene.unlabelled = {"omega"};
    const View without_omega = view_of(scene);
    EXPECT_EQ(without_omega.labels.size() + 1, with.labels.size());
    EXPECT_EQ(without_omega.arrows.size(), with.arrows.size());
    scene.unlabelled.clear();
    scene.labels = false;
    const View without = view_of(scene);
    EXPECT_TRUE(without.labels.empty());
    EXPECT_EQ(without.arrows.size(), with.arrows.size());
    scene.unlabelled = {"omga"};
    try {
        view_of(scene);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean \"omega\"?"), std::string::npos);
    }
}

// F(ρ) = 1 on the ellipsoid in body axes for any attitude; a mark in space does not move.
TEST(OwnMarks, FollowTheirObject) {
    Scene scene = a_scene();
    const Colour red{1.0, 0.0, 0.0}, green{0.0, 1.0, 0.0};
    MarkSpec on_it, in_space;
    on_it.at = {0.0, 3.0, 0.0};
    on_it.srgb = {1.0, 0.0, 0.0};
    in_space.on = "space";
    in_space.at = {0.3, -0.4, 0.9};
    in_space.srgb = {0.0, 1.0, 0.0};
    on_it.trail = true;
    scene.marks = {on_it, in_space};
    const StagedScene staged(scene, 10.0);
    const auto dot_in = [&](const View& view, const Colour& colour) {
        const auto found = std::find_if(view.dots.begin(), view.dots.end(),
                                        [&](const Dot& dot) { return dot.colour == colour; });
        EXPECT_NE(found, view.dots.end());
        return found->at;
    };
    for (const double time_s : {0.0, 1.7, 9.3}) {
        const View view = staged.stage.at(time_s).views.at(0);
        // Along e2, at the end of that half-axis.
        const Eigen::Vector3d e2 = view.ellipsoids.at(0).half_axes.col(1);
        EXPECT_LT((dot_in(view, red) - e2).norm(), 1e-12);
        EXPECT_EQ(dot_in(view, green), in_space.at);

        // Its trail ends at the mark, and its distance from the centre is constant.
        const Curve* trail = curve_in(view, red);
        ASSERT_NE(trail, nullptr);
        const auto last = static_cast<std::size_t>(trail->last);
        const Eigen::Vector3d a = trail->geometry->points.at(last);
        const Eigen::Vector3d b =
            trail->geometry->points.at(std::min(last + 1, trail->geometry->points.size() - 1));
        const double share = trail->last - static_cast<double>(last);
        EXPECT_LT((a + share * (b - a) - e2).norm(), 2e-3);
        for (const Eigen::Vector3d& point : trail->geometry->points)
            EXPECT_NEAR(point.norm(), e2.norm(), 1e-12);
    }
}

// The corner of a box, in metres, at the body's reach: it rotates with the body.
TEST(OwnMarks, OnABodyAreInMetres) {
    Scene scene = a_scene("object");
    scene.body.given = BodySpec::Given::solid;
    scene.body.shape = "box";
    scene.body.size_m = {0.24, 0.16, 0.04};
    scene.body.mass_kg = 1.0;
    MarkSpec corner;
    corner.on = "body";
    corner.at = {0.12, 0.08, 0.02};
    corner.name = "P";
    corner.srgb = {1.0, 0.0, 0.0};
    scene.marks = {corner};
    const StagedScene staged(scene, 10.0);
    const Drawing drawing = staged.stage.at(2.5);
    const View& view = drawing.views.at(0);
    const Colour red{1.0, 0.0, 0.0};
    const auto found = std::find_if(view.dots.begin(), view.dots.end(),
                                    [&](const Dot& dot) { return dot.colour == red; });
    ASSERT_NE(found, view.dots.end());
    // The box's farthest point has distance 1 from the centre, and an edge of the box ends there.
    EXPECT_NEAR(found->at.norm(), 1.0, 1e-12);
    double nearest = 1.0;
    for (const Curve& edge : view.curves)
        for (const Eigen::Vector3d& point : edge.geometry->points)
            nearest = std::min(nearest, (edge.placement * point - found->at).norm());
    EXPECT_LT(nearest, 1e-9);
}

// A pencil that spins about its length, and loses this spin by friction within a thousandth of the
// film: from ω = 20 rad/s to L/I_max = 1.96 rad/s about e3. The chart shows the latter's range.
TEST(Plots, FirstInstantsThatWidenTheRangeTooMuchAreExcluded) {
    Scene scene = free_scene({0.1, 1.0, 1.05}, {20.0, 0.4, 0.2}, "plot");
    scene.film.duration_s = 60.0;
    scene.panels[0].quantity = "omega";
    scene.torque = DissipationTorque{
        dissipation_rate_of_half_life(scene.body.inertia, scene.start.omega_rad_s, 0.05)};
    scene.method = {.name = "dopri5", .step_s = {}, .tolerance = 1e-9, .order = {}};
    const StagedScene staged(scene, 60.0);
    const View view = staged.stage.at(30.0).views.at(0);
    const Theme& theme = theme_named("light");
    std::array<double, 3> ends{};
    double least_y = 1e300, most_y = -1e300;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& points = curve_in(view, theme.axes[i])->geometry->points;
        ends[i] = points.back().y();
        for (const Eigen::Vector3d& point : points) {
            least_y = std::min(least_y, point.y());
            most_y = std::max(most_y, point.y());
        }
    }
    EXPECT_NEAR(ends[0], ends[1], 0.5);
    // Of a range of 20 it would be a tenth.
    EXPECT_GT(std::abs(ends[2] - ends[0]), 0.4 * (most_y - least_y));
    EXPECT_GT(least_y, 0.0);
    EXPECT_LT(most_y, view.height_px);
}

TEST(Plots, RangesOfSimilarWidthAreNotChanged) {
    const PlotQuantity& omega_row =
        *std::find_if(plot_quantities().begin(), plot_quantities().end(),
                      [](const PlotQuantity& quantity) { return quantity.name == "omega"; });
    EXPECT_TRUE(is_ruined(omega_row, {0.0, 20.0}, {0.0, 2.0}));
    EXPECT_FALSE(is_ruined(omega_row, {0.0, 20.0}, {0.0, 10.0}));
    EXPECT_FALSE(is_ruined(omega_row, {0.0, 20.0}, {19.0, 20.0}));  // its axis includes 0
    EXPECT_FALSE(is_ruined(omega_row, {0.0, 20.0}, {0.0, 1e-3}));   // it comes to rest
}

}  // namespace
}  // namespace poinsot::style_tests
