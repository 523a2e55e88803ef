// Notes about colours that can hardly be seen or distinguished.
#include "drawing/style/theme_contrast.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "drawing/style/theme.h"
#include "scenes_by_hand.h"
#include "styled_scenes.h"

namespace poinsot::style_tests {
namespace {

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

// A theme for black and white is one decision, not a dozen.
TEST(Contrast, ThemesOfOneColourCauseOneNote) {
    Scene scene = a_scene();
    scene.theme = "print";
    for (const char* role : {"polhode", "herpolhode", "momentum", "omega", "rho", "e1", "e2", "e3"})
        scene.style.looks[role] = look(0.0, 0.0, 0.0);
    scene.locations["style.polhode"] = {"a.toml", 7, 1};
    const std::vector<std::string> notes = contrast_notes(scene, theme_of(scene));
    ASSERT_EQ(notes.size(), 1u) << notes[1];
    EXPECT_EQ(
        notes[0],
        "a.toml:7:1: style.polhode: polhode, herpolhode, momentum, omega, rho, e1, e2, e3 have "
        "one colour; only their names and shapes tell them apart");
}

}  // namespace
}  // namespace poinsot::style_tests
