// Customisation by the scene: words, symbols, units, the clock, text sizes, captions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "drawing/figures/charts/plot_quantity.h"
#include "drawing/figures/elements/elements.h"
#include "drawing/stage/live_values.h"
#include "drawing/stage/overlay.h"
#include "drawing/stage/panel_kind.h"
#include "drawing/stage/type/scene_symbols.h"
#include "error/error.h"
#include "scenes_by_hand.h"
#include "text/languages.h"

namespace poinsot::user_style_tests {
namespace {

const Eigen::Vector3d moments{1.0, 2.0, 2.9};
const Eigen::Vector3d omega{1.4, 0.5, 1.6};

// Whether a title has words outside of $formulas$ and units in brackets.
bool title_has_words(std::string_view title) {
    const std::string plain =
        std::regex_replace(std::string(title), std::regex(R"(\$[^$]*\$|\([^)]*\))"), "");
    return std::regex_search(plain, std::regex("[A-Za-z]{2}"));
}

// Whether a formula has words in \mathrm{}.
bool formula_has_words(std::string_view label) {
    return label.find("\\mathrm{") != std::string_view::npos;
}

// Phrases with words have a text in every language; phrases without words have one text only.
void expect_whole(const Phrase& phrase, bool has_words) {
    for (std::size_t i = 1; i < phrase.size(); ++i)
        EXPECT_EQ(!phrase[i].empty(), has_words) << phrase[0] << " in " << language_codes[i];
}

TEST(UserStyle, EveryBuiltInPhraseIsTranslated) {
    for (const PanelKind& kind : panel_kinds())
        expect_whole(kind.title, title_has_words(kind.title[0]));
    for (const PlotQuantity& quantity : plot_quantities()) {
        expect_whole(quantity.title, title_has_words(quantity.title[0]));
        for (const PlotCurve& curve : quantity.curves)
            expect_whole(curve.label, formula_has_words(curve.label[0]));
    }
    EXPECT_TRUE(title_has_words("angle of $\\boldsymbol{\\omega}$ from $\\mathbf{L}$"));
    EXPECT_FALSE(title_has_words("$p_\\psi$ / (kg m²/s);  $E$"));
}

// Languages with Latin letters are set with the built-in fonts.
TEST(UserStyle, LatinTextUsesBuiltInFonts) {
    Scene scene = free_scene(moments, omega, "body");
    PanelSpec plot;
    plot.kind = "plot";
    plot.quantity = "energy";
    plot.row = 1;
    scene.grid.rows = {1.0, 1.0};
    scene.panels.push_back(plot);
    for (const char* language : {"en", "de", "fr", "es", "it"}) {
        scene.language = language;
        EXPECT_NO_THROW(StagedScene(scene, 1.0)) << language;
    }
}

TEST(UserStyle, SymbolsReplaceTheDefaultNames) {
    Scene scene;
    EXPECT_EQ(named_by_scene(scene, "\\boldsymbol{\\omega}"), "\\boldsymbol{\\omega}");
    scene.symbols.omega = "\\Omega";
    scene.symbols.momentum = "\\mathbf{J}";
    scene.symbols.e1 = "x";
    EXPECT_EQ(named_by_scene(scene, "\\boldsymbol{\\omega}\\times\\mathbf{r}"),
              "\\Omega\\times\\mathbf{r}");
    EXPECT_EQ(named_by_scene(scene, "\\omega_1"), "{\\Omega}_1");
    EXPECT_EQ(named_by_scene(scene, "\\boldsymbol{\\rho}\\cdot\\mathbf{L}/L"),
              "\\boldsymbol{\\rho}\\cdot\\mathbf{J}/|\\mathbf{J}|");
    EXPECT_EQ(named_by_scene(scene, "L_1^2 + L_2^2 = L^2"),
              "{\\mathbf{J}}_1^2 + {\\mathbf{J}}_2^2 = |\\mathbf{J}|^2");
    EXPECT_EQ(named_by_scene(scene, "L"), "|\\mathbf{J}|");
    EXPECT_EQ(named_by_scene(scene, "\\mathrm{Lage}"), "\\mathrm{Lage}");
    EXPECT_EQ(title_named_by_scene(scene, "$L_i$, $L$"), "${\\mathbf{J}}_i$, $|\\mathbf{J}|$");
    EXPECT_EQ(title_named_by_scene(scene, "Linie zu L"), "Linie zu $\\mathbf{J}$");
    EXPECT_EQ(title_named_by_scene(scene, "Lとの角度"), "$\\mathbf{J}$との角度");
    Scene renamed;  // by names that contain other symbols
    renamed.symbols.omega = "\\mathbf{L}";
    renamed.symbols.momentum = "\\boldsymbol{\\omega}";
    EXPECT_EQ(named_by_scene(renamed, "\\boldsymbol{\\omega}\\cdot\\mathbf{L}"),
              "\\mathbf{L}\\cdot\\boldsymbol{\\omega}");
    EXPECT_EQ(title_named_by_scene({}, "angle from L, $L_i$"), "angle from L, $L_i$");
    EXPECT_EQ(named_by_scene(scene, "\\mathbf{e}_1"), "x");
    EXPECT_EQ(named_by_scene(scene, "\\mathbf{e}_2"), "\\mathbf{e}_2");
    // An invalid formula is rejected.
    Scene shown = free_scene(moments, omega, "body");
    shown.symbols.omega = "\\nosuch";
    EXPECT_THROW(StagedScene(shown, 1.0), InputError);
    // The message names the place of this symbol, here an option of the command line.
    shown.locations["symbols"] = {"a.toml", 6, 2};
    shown.locations["symbols.omega"] = {"--set", 0, 0};
    try {
        StagedScene(shown, 1.0);
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find("a.toml"), std::string::npos) << error.what();
    }
    shown.symbols.omega = "x";
    EXPECT_NO_THROW(StagedScene(shown, 1.0));
}

TEST(UserStyle, ChartsUseTheRequestedUnits) {
    Scene scene = free_scene(moments, omega, "plot");
    scene.panels[0].quantity = "omega";
    scene.units = {"rpm"};
    const StagedScene staged(scene, 10.0);
    const StageContext data(scene, theme_of(scene), staged.motion,
                            {.width_px = 640, .height_px = 360}, nullptr);
    const PlotQuantity& quantity = plot_quantity_of(data, "omega");
    EXPECT_EQ(unit_of(data, quantity).name, "rpm");
    const FrameInput instant = data.instant_at({1.0, 1.0}, quantity.needs, false);
    const PlotValues in_SI = quantity.values(data, instant);
    const PlotValues shown = shown_values(data, quantity, instant);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_DOUBLE_EQ(shown[i], in_SI[i] * 60.0 / (2.0 * std::numbers::pi));
    // Quantities with several units are not converted.
    EXPECT_EQ(unit_of(data, plot_quantity_of(data, "energy")).per_SI, 1.0);
}

TEST(UserStyle, LiveNumbersUseTheRequestedUnits) {
    Scene scene = free_scene(moments, omega, "space");
    scene.units = {"rpm", "mJ"};
    FrameInput instant;
    instant.state.omega_body = {0.0, 0.0, 2.0 * std::numbers::pi};
    const auto live = [&](std::string_view text) { return live_text(scene, text, instant); };
    EXPECT_EQ(live("{omega_3:.0f} and {omega_3_rad_s:.3f}"), "60~rpm and 6.283");
    const double mJ = 1e3 * 0.5 * 2.9 * std::pow(2.0 * std::numbers::pi, 2.0);
    EXPECT_EQ(live("{kinetic_energy:.1f}"), fmt::format("57\\,{:.1f}~mJ", mJ - 57'000.0));
    EXPECT_EQ(live("{T:.1f}"), live("{kinetic_energy:.1f}"));
    EXPECT_EQ(live("{L:.3f}"), fmt::format("{:.3f}~kg~m\u00b2/s", 2.9 * 2.0 * std::numbers::pi));
    EXPECT_EQ(live("{L:.3f}"), live("{momentum:.3f}"));
    instant.time_s = 1.5;
    EXPECT_EQ(live("{t}"), "1.50~s");  // as the clock
    scene.units = {"deg", "ms"};
    EXPECT_EQ(live("{omega:.0f}, {t}"), "360~deg/s, 1500~ms");
    scene.language = "de";
    EXPECT_EQ(live("{omega:.1f}, {time_s:.2f}~s"), "360,0~deg/s, 1,50~s");
    scene.units = {"U/min", "g cm²/s"};
    EXPECT_EQ(live("{omega_3:.1f}, {t}"), "60,0~U/min, 1,50~s");
    // 2.9·2π kg m²/s, in groups of three digits.
    EXPECT_EQ(live("{L:.2f}"), "182\\,212\\,373,91~g~cm²/s");
}

TEST(UserStyle, AUnitThatDoesNotBelongToItsNumberIsNotedWithItsPlace) {
    Scene scene = free_scene(moments, omega, "space");
    scene.units = {"deg"};
    scene.caption = "$\\omega_3$ = {omega_3} rad/s";
    scene.locations["caption"] = {"a.toml", 7, 3};
    scene.captions.emplace_back().text = "{T:.1f}~J and {omega_1_rad_s}~rpm";
    scene.locations["captions[0].text"] = {"a.toml", 12, 5};
    const std::vector<std::string> notes = caption_notes(scene);
    ASSERT_EQ(notes.size(), 2u);
    EXPECT_EQ(notes[0].find("a.toml:7:3: caption: {omega_3} is shown in rad/s"), 0u) << notes[0];
    EXPECT_EQ(notes[1].find("a.toml:12:5: captions[0].text: \"rpm\" stands beside {omega_1_rad_s}"),
              0u)
        << notes[1];
    scene.captions.clear();
    scene.show = {"plane"};  // no caption
    EXPECT_TRUE(caption_notes(scene).empty());
    scene.show.clear();
    scene.caption = "$\\omega_3$ = {omega_3}";
    EXPECT_TRUE(caption_notes(scene).empty());
}

// The same picture but for the mark: a comma in a formula has no space after it.
TEST(UserStyle, ChartsHaveTheDecimalMarkOfTheLanguage) {
    Scene scene = free_scene(moments, {0.14, 0.05, 0.16}, "plot");
    scene.panels[0].quantity = "omega";
    const auto widths = [&scene](const char* language) {
        scene.language = language;
        const StagedScene staged(scene, 1.0);
        const Drawing drawing = staged.stage.at(0.5);
        std::vector<double> found;
        for (const View& view : drawing.views)
            for (const Label& label : view.labels) found.push_back(label.mask->width);
        return found;
    };
    const std::vector<double> en = widths("en"), de = widths("de");
    ASSERT_EQ(en.size(), de.size());
    for (std::size_t i = 0; i < en.size(); ++i) EXPECT_NEAR(en[i], de[i], 2.0) << i;
}

std::size_t n_overlaid(const Scene& scene, double film_s) {
    const StagedScene staged(scene, 10.0);
    const Drawing drawing = staged.stage.at(FilmTime{film_s, film_s});
    return drawing.views.size() > 1 ? drawing.views.back().labels.size() : 0;
}

TEST(UserStyle, ClockIsShownOrHidden) {
    Scene scene = free_scene(moments, omega, "space");
    EXPECT_EQ(n_overlaid(scene, 1.0), 1u);
    scene.clock = false;
    EXPECT_EQ(n_overlaid(scene, 1.0), 0u);
    scene.clock = true;
    scene.show = {"plane"};
    EXPECT_EQ(n_overlaid(scene, 1.0), 1u);
}

TEST(UserStyle, TextIsScaled) {
    Scene scene = free_scene(moments, omega, "space");
    scene.title = "Title";
    scene.caption = "Caption";
    const auto heights = [&scene](double type_scale) {
        scene.type_scale = type_scale;
        const StagedScene staged(scene, 1.0);
        const Drawing drawing = staged.stage.at(0.5);
        std::vector<double> found;
        for (const View& view : drawing.views)
            for (const Label& label : view.labels) found.push_back(label.mask->height);
        return found;
    };
    const auto once = heights(1.0);
    const auto twice = heights(2.0);
    ASSERT_EQ(once.size(), twice.size());
    for (std::size_t i = 0; i < once.size(); ++i) EXPECT_NEAR(twice[i], 2.0 * once[i], 3.0);
}

TEST(UserStyle, CaptionsFadeInAndOut) {
    Scene scene = free_scene(moments, omega, "space");
    scene.clock = false;
    scene.film.duration_s = 10.0;
    scene.captions = {{.at_s = 2.0, .over_s = 3.0, .text = "first", .place = "bottom"},
                      {.at_s = 4.0, .over_s = {}, .text = "t = {time_s:.1f}", .place = "top"},
                      {.at_s = 8.0, .over_s = {}, .text = "last", .place = "top"}};
    for (const auto& [film_s, n] : std::vector<std::pair<double, std::size_t>>{
             {0.0, 0}, {1.9, 0}, {3.0, 1}, {4.5, 2}, {6.0, 1}, {7.9, 1}, {9.0, 1}})
        EXPECT_EQ(n_overlaid(scene, film_s), n) << film_s;
    // The opacity changes continuously.
    const StagedScene staged(scene, 10.0);
    double before = 0.0;
    for (double film_s = 1.9; film_s < 5.2; film_s += 1.0 / 60.0) {
        const Drawing drawing = staged.stage.at(FilmTime{film_s, film_s});
        const double opacity =
            drawing.views.size() > 1 ? drawing.views.back().labels.front().opacity : 0.0;
        EXPECT_TRUE(film_s >= 4.0 || std::abs(opacity - before) < 0.09) << film_s;
        before = opacity;
    }
}

// The picture names the chapter that players list, with its number, until the next one begins.
TEST(UserStyle, ChaptersAreNamedInThePicture) {
    Scene scene = free_scene(moments, omega, "space");
    scene.show = {"plane", "chapter"};
    scene.film.duration_s = 10.0;
    scene.chapters = {{.at_s = 1.0, .title = "First"}, {.at_s = 4.0, .title = "Second"}};
    const auto shown = [&scene](double film_s) {
        const StagedScene staged(scene, 10.0);
        std::string texts;
        const Drawing drawing = staged.stage.at(FilmTime{film_s, film_s});
        for (const View& view : drawing.views)
            for (const Label& label : view.labels) texts += label.mask->source.text + ";";
        return texts;
    };
    EXPECT_EQ(shown(0.5), "");
    EXPECT_EQ(shown(2.0), "1  First;");
    EXPECT_EQ(shown(5.0), "2  Second;");
    EXPECT_EQ(shown(10.0), "2  Second;");
    scene.show = {"plane"};
    EXPECT_EQ(shown(2.0), "");
}

TEST(UserStyle, BodyPanelHasTheRequestedNumberOfCurves) {
    Scene scene = free_scene(moments, omega, "body");
    const auto n_thin = [&scene] {
        const StagedScene staged(scene, 1.0);
        std::size_t n = 0;
        const Drawing drawing = staged.stage.at(0.5);
        for (const Curve& curve : drawing.views[0].curves)
            n += curve.dash_px == 0.0 && curve.geometry->closed ? 1 : 0;
        return n;
    };
    scene.panels[0].curves = 0;
    const std::size_t own = n_thin();  // the motion's and its mirror image
    EXPECT_EQ(own, 2u);
    scene.panels[0].curves = 3;
    // Two families of three curves, each with its mirror images, except for the one next to the
    // motion's.
    EXPECT_GE(n_thin(), own + 2u * 2u * 3u - 2u);
    EXPECT_LE(n_thin(), own + 2u * 2u * 3u);
}

}  // namespace
}  // namespace poinsot::user_style_tests
