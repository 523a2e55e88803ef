// Whether a theme's lines are visible and distinguishable, for all common kinds of colour vision
// and in greyscale.
#include "drawing/style/theme.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drawing/style/colour_vision.h"
#include "drawing/style/theme_contrast.h"
#include "drawing/style/theme_roles.h"
#include "error/error.h"

namespace poinsot {
namespace {

double least_difference(const Colour& a, const Colour& b) {
    double least = 1e300;
    for (const Vision& vision : visions()) least = std::min(least, line_difference(a, b, vision));
    return least;
}

using ColourPair = std::pair<Colour, Colour>;

// Pairs of the same kind of object in one view, which are distinguished by colour alone.
std::vector<ColourPair> main_pairs(const Theme& t) {
    return {{t.polhode, t.herpolhode},  {t.polhode, t.momentum},    {t.polhode, t.omega},
            {t.herpolhode, t.omega},    {t.herpolhode, t.momentum}, {t.momentum, t.omega},
            {t.axes[0], t.axes[1]},     {t.axes[1], t.axes[2]},     {t.axes[2], t.axes[0]},
            {t.angles[0], t.angles[1]}, {t.angles[1], t.angles[2]}, {t.angles[2], t.angles[0]},
            {t.energy, t.potential},    {t.rho, t.momentum},        {t.rho, t.omega},
            {t.rho, t.polhode},         {t.rho, t.gradient},        {t.gradient, t.momentum},
            {t.gradient, t.omega},      {t.torque, t.momentum},     {t.torque, t.omega},
            {t.torque, t.axes[0]},      {t.torque, t.axes[1]},      {t.torque, t.axes[2]},
            {t.mark, t.herpolhode},     {t.angles[1], t.axes[0]},   {t.angles[1], t.axes[2]},
            {t.angles[1], t.energy},    {t.energy, t.angles[2]}};
}

// The lines of each view, which a reader with normal vision tells apart by colour alone. The colour
// of θ is that of the herpolhode, which no top has.
std::vector<std::vector<std::string_view>> lines_of_views() {
    return {{"polhode", "herpolhode", "momentum", "omega", "rho", "gradient", "e1", "e2", "e3"},
            {"polhode", "herpolhode", "momentum", "omega", "mark", "ghost"},
            {"momentum", "omega", "torque", "e1", "e2", "e3", "energy"},
            {"theta", "phi", "psi", "e1", "e3", "energy", "potential", "text"}};
}

class EveryTheme : public testing::TestWithParam<std::size_t> {
 protected:
    const Theme& theme() const { return themes()[GetParam()]; }
};

TEST_P(EveryTheme, LinesHaveContrastToTheirBackground) {
    const Theme& t = theme();
    EXPECT_GE(contrast(t.polhode, t.ellipsoid), 3.0);
    EXPECT_GE(contrast(t.separatrix, t.ellipsoid), 3.0);
    EXPECT_GE(contrast(t.polhode, t.plane), 3.0);
    EXPECT_GE(contrast(t.herpolhode, t.plane), 3.0);
    // Over a transparent background, only the text's halo is known.
    std::vector<Colour> grounds{t.halo};
    if (t.background.alpha > 0.0)
        grounds.insert(grounds.end(), {t.background.top, t.background.bottom});
    for (const Colour& ground : grounds) {
        EXPECT_GE(contrast(t.text, ground), 4.5);
        for (const Colour& line :
             {t.momentum, t.omega, t.rho, t.gradient, t.torque, t.mark, t.axes[0], t.axes[1],
              t.axes[2], t.angles[0], t.angles[1], t.angles[2], t.energy, t.potential})
            EXPECT_GE(contrast(line, ground), 3.0);
    }
}

TEST_P(EveryTheme, QuantitiesOfOneViewDifferForEveryColourVision) {
    // Measured: at least 1.02 (colour-blind, θ and ψ seen by protanopes).
    for (const Vision& vision : visions())
        for (const auto& [a, b] : main_pairs(theme()))
            EXPECT_GE(line_difference(a, b, vision), 1.0)
                << vision.eye << ": " << a.r << " " << a.g << " " << a.b << " and " << b.r << " "
                << b.g << " " << b.b;
}

TEST_P(EveryTheme, AllQuantitiesOfOneViewDifferForNormalVision) {
    Theme t = theme();
    for (const auto& view : lines_of_views())
        for (const std::string_view a : view)
            for (const std::string_view b : view)
                if (a < b) {
                    EXPECT_GE(
                        line_difference(*look_of(t, a).colour, *look_of(t, b).colour, visions()[0]),
                        1.0)
                        << a << " " << b;
                }
}

// Letters that name anything in its colour; in 8 bits, as they are stored in a picture.
TEST_P(EveryTheme, LettersOfEveryRoleHaveAContrastOfFourAndAHalf) {
    Theme t = theme();
    const auto stored = [](const Colour& c) {
        const auto part = [](double x) { return std::round(255.0 * x) / 255.0; };
        return Colour{part(c.r), part(c.g), part(c.b)};
    };
    for (const ThemeRole& role : theme_roles()) {
        const Colour letters = stored(letter_colour(t, *role.look(t).colour));
        EXPECT_GE(contrast(letters, t.halo), 4.5) << role.name;
        if (!(t.background.alpha > 0.0)) continue;
        EXPECT_GE(contrast(letters, t.background.top), 4.5) << role.name;
        EXPECT_GE(contrast(letters, t.background.bottom), 4.5) << role.name;
    }
}

// Letters have the colour of what they name, or more contrast in the same hue.
TEST_P(EveryTheme, LettersKeepTheirHue) {
    Theme t = theme();
    for (const ThemeRole& role : theme_roles()) {
        const Colour line = *role.look(t).colour, letters = letter_colour(t, line);
        double least = 21.0;
        for (const Colour& ground : grounds_of(t)) least = std::min(least, contrast(line, ground));
        if (least >= 4.56) {
            EXPECT_EQ(letters, line) << role.name;
            continue;
        }
        const Eigen::Vector3d was = lab(line), is = lab(letters);
        const double turn =
            std::atan2(was.y() * is.z() - was.z() * is.y(), was.y() * is.y() + was.z() * is.z());
        if (was.tail<2>().norm() > 10.0) {
            EXPECT_LT(std::abs(turn), 0.1) << role.name;  // measured 0.071
        }
    }
}

TEST(Letters, OfTheUsersOwnTextStayAsTheyAre) {
    Theme theme = theme_named("light");
    theme.text = {0.6, 0.6, 0.6};
    EXPECT_EQ(letter_colour(theme, theme.text), theme.text);
}

// Measured points lie on the curves and beside the arrows. They differ from these by their shape,
// too: dots on a thin line.
TEST_P(EveryTheme, MeasuredPointsDifferFromWhatTheyLieOn) {
    const Theme& t = theme();
    for (const Colour& other :
         {Colour(t.polhode), Colour(t.herpolhode), Colour(t.momentum), Colour(t.omega)})
        EXPECT_GE(least_difference(t.measured, other), 0.85);  // measured 0.90, colour-blind
    for (const Colour& ground : {t.ellipsoid, t.plane})
        EXPECT_GE(contrast(t.measured, ground), 2.5);
}

// If colours may be indistinguishable, the herpolhode differs by its width.
TEST_P(EveryTheme, CurvesDifferInWidthWhereColoursMayBeConfused) {
    const Theme& t = theme();
    EXPECT_GE(t.herpolhode_weight, 1.2 * t.polhode_weight);
}

std::string name_of(const testing::TestParamInfo<std::size_t>& info) {
    std::string name(themes()[info.param].name);
    std::erase(name, '-');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Themes, EveryTheme, testing::Range<std::size_t>(0, themes().size()),
                         name_of);

TEST(PrintTheme, IsDistinguishableInGreyscale) {
    const Theme& t = theme_named("print");
    EXPECT_GE(grey_difference(t.polhode, t.herpolhode), 1.0);
    EXPECT_GE(grey_difference(t.momentum, t.omega), 1.0);
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)})
        EXPECT_GE(grey_difference(t.axes[i], t.axes[j]), 1.0) << i << j;
    // Paper is white.
    EXPECT_EQ(t.background.top, (Colour{1.0, 1.0, 1.0}));
    EXPECT_EQ(t.background.bottom, (Colour{1.0, 1.0, 1.0}));
    EXPECT_GE(grey_difference(t.body_cone, t.space_cone), 1.0);
}

TEST(ColourBlindTheme, EveryPairDiffersMoreThanInTheOtherThemes) {
    const auto least = [](const Theme& t) {
        const std::array<Colour, 7> all{t.polhode, t.herpolhode, t.momentum, t.omega,
                                        t.axes[0], t.axes[1],    t.axes[2]};
        double worst = 1e300;
        for (std::size_t i = 0; i < all.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                worst = std::min(worst, least_difference(all[i], all[j]));
        return worst;
    };
    const double here = least(theme_named("colour-blind"));
    EXPECT_GE(here, 0.75);  // measured 0.79, e2 and ω seen by deuteranopes
    for (const Theme& theme : themes())
        if (theme.name != "colour-blind") {
            EXPECT_LT(least(theme), here) << theme.name;
        }
}

TEST(TransparentTheme, HasNoBackground) {
    EXPECT_EQ(theme_named("transparent").background.alpha, 0.0);
    EXPECT_EQ(theme_named("transparent-dark").background.alpha, 0.0);
}

TEST(Themes, UnknownNameSuggestsTheNearest) {
    try {
        theme_named("drak");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("dark"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace poinsot
