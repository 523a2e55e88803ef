// The effect of [style] on the drawing, and omitted labels.
#include <gtest/gtest.h>

#include <string>

#include "drawing/style/theme.h"
#include "drawing/style/theme_roles.h"
#include "error/error.h"
#include "scene/style_keys.h"
#include "scenes_by_hand.h"
#include "styled_scenes.h"

namespace poinsot::style_tests {
namespace {

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
             {&Theme::polhode,     &Theme::herpolhode, &Theme::momentum,   &Theme::omega,
              &Theme::rho,         &Theme::gradient,   &Theme::torque,     &Theme::mark,
              &Theme::contact,     &Theme::body_cone,  &Theme::space_cone, &Theme::annulus,
              &Theme::separatrix,  &Theme::ghost,      &Theme::sphere,     &Theme::solid,
              &Theme::solid_lines, &Theme::energy,     &Theme::potential,  &Theme::rule,
              &Theme::measured})
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

}  // namespace
}  // namespace poinsot::style_tests
