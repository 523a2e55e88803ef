// Text over all panels: captions.
#include "drawing/stage/overlay.h"

#include <gtest/gtest.h>

#include <map>

#include "drawing/style/theme_contrast.h"
#include "scenes_by_hand.h"

namespace poinsot {
namespace {

// The number of letters of the caption in each colour.
std::map<std::string, int> letters_by_colour(const Scene& scene, const std::string& text) {
    const StagedScene staged(scene, 10.0);
    const Drawing drawing = staged.stage.at(1.0);
    const Theme& theme = staged.stage.context().theme;
    const auto name_of = [&](const Colour& colour) -> std::string {
        if (colour == letter_colour(theme, theme.polhode)) return "polhode";
        if (colour == letter_colour(theme, theme.omega)) return "omega";
        if (colour == theme.text) return "text";
        return "other";
    };
    std::map<std::string, int> n;
    for (const View& view : drawing.views)
        for (const Label& label : view.labels) {
            if (label.mask->source.text != text) continue;
            for (const MaskLetter& letter : label.mask->letters)
                ++n[name_of(letter.tint == 0
                                ? label.colour
                                : label.inks.at(static_cast<std::size_t>(letter.tint) - 1))];
        }
    return n;
}

TEST(Captions, NameThingsInTheirColours) {
    for (const Theme& theme : themes()) {
        Scene scene = free_scene({4.0, 3.0, 1.5}, {1.2, 0.8, 2.4}, "space");
        scene.theme = theme.name;
        scene.caption = "The polhode of $\\boldsymbol\\omega$";
        EXPECT_EQ(letters_by_colour(scene, scene.caption),
                  (std::map<std::string, int>{{"text", 5}, {"polhode", 7}, {"omega", 1}}))
            << theme.name;
        // Titles are in one colour.
        scene.caption.clear();
        scene.title = "The polhode";
        EXPECT_EQ(letters_by_colour(scene, scene.title), (std::map<std::string, int>{{"text", 10}}))
            << theme.name;
    }
}

// In the scene's language, and by the scene's own names.
TEST(Captions, KnowTheWordsOfTheScene) {
    Scene scene = free_scene({4.0, 3.0, 1.5}, {1.2, 0.8, 2.4}, "space");
    scene.caption = "Polhodie ou Polkurve";
    EXPECT_EQ(letters_by_colour(scene, scene.caption).count("polhode"), 0u);
    scene.symbols.things["polhode"] = "Polkurve";
    EXPECT_EQ(letters_by_colour(scene, scene.caption)["polhode"], 8);
    scene.symbols.omega = "\\boldsymbol{\\Omega}";
    scene.caption = "$\\boldsymbol{\\Omega}$, $\\boldsymbol{\\omega}$";
    EXPECT_EQ(letters_by_colour(scene, scene.caption)["omega"], 1);
}

}  // namespace
}  // namespace poinsot
