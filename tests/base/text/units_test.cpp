// Units as users write them, and the words of pictures in every language.
#include "text/units.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "text/languages.h"

namespace poinsot {
namespace {

constexpr double pi = std::numbers::pi;

double in(std::string_view text, std::string_view unit) {
    return measured_in(text, *unit_named(unit)).value_or(std::numeric_limits<double>::quiet_NaN());
}

TEST(Units, ConvertToTheNearestDouble) {
    // Bit-identical to the SI number.
    EXPECT_EQ(in("24 cm", "m"), 0.24);
    EXPECT_EQ(in("800 g", "kg"), 0.8);
    EXPECT_EQ(in("0.1 mm", "m"), 0.0001);
    EXPECT_EQ(in("120 g cm²", "kg m²"), 1.2e-5);
    EXPECT_EQ(in("120 g*cm^2", "kg m²"), 1.2e-5);
    EXPECT_EQ(in("2.7 g/cm³", "kg/m³"), 2700.0);
    EXPECT_EQ(in("5 min", "s"), 300.0);
    EXPECT_EQ(in("180 deg", "rad"), pi);
    EXPECT_EQ(in("-90°", "rad"), -pi / 2.0);
    EXPECT_EQ(in("60 rpm", "rad/s"), 2.0 * pi);
    EXPECT_EQ(in("360 deg/s", "rad/s"), 2.0 * pi);
    EXPECT_EQ(in("1 turn/min", "rad/s"), in("1 rpm", "rad/s"));
    for (const char* rpm : {"1 U/min", "1 tr/min", "1 r/min", "1 rev/min"})
        EXPECT_EQ(in(rpm, "rad/s"), in("1 rpm", "rad/s")) << rpm;
    EXPECT_EQ(in("180 Grad", "rad"), pi);
    EXPECT_EQ(in("3 1/min", "1/s"), 0.05);  // no rate of rotation
    EXPECT_EQ(in("30 deg", "degrees"), 30.0);
    EXPECT_EQ(in("3 mN m", "N m"), 0.003);
    EXPECT_EQ(in("7 1/s", "1/s"), 7.0);
    EXPECT_EQ(in("4800g", "kg"), 4.8);
}

TEST(Units, AcceptFractions) {
    EXPECT_DOUBLE_EQ(in("33 1/3 rpm", "rad/s"), 100.0 / 3.0 * 2.0 * pi / 60.0);
    EXPECT_EQ(in("1/3 m", "m"), 1.0 / 3.0);
    EXPECT_EQ(in("-2 1/2 cm", "m"), -0.025);
    EXPECT_EQ(in("1/2 kg m²", "kg m²"), 0.5);
}

TEST(Units, RejectInvalidUnitsAndOtherDimensions) {
    for (const char* text :
         {"", "cm", "24", "24 parsec", "24 cmm", "24 m 3", "m 24", "1/0 m", "24 m^0", "24 /m",
          "24 m//s", "0x10 m", "nan m", "inf m", "24 (m", "--3 m"})
        EXPECT_FALSE(measured(text)) << text;
    EXPECT_FALSE(measured_in("24 kg", *unit_named("m")));
    // Angle is a dimension: an angular rate differs from other rates.
    EXPECT_FALSE(measured_in("3 1/s", *unit_named("rad/s")));
    EXPECT_FALSE(unit_named("units of the largest half-axis"));
    EXPECT_FALSE(unit_named("pixels"));
    EXPECT_FALSE(unit_named(""));
}

TEST(Units, AreShownInTheWantedUnitOfTheSameDimension) {
    const std::vector<std::string> wanted{"rpm", "deg", "g cm²/s"};
    EXPECT_EQ(unit_shown(wanted, "rad/s").name, "rpm");
    EXPECT_DOUBLE_EQ(2.0 * pi * unit_shown(wanted, "rad/s").per_SI, 60.0);
    EXPECT_DOUBLE_EQ(pi * unit_shown(wanted, "rad").per_SI, 180.0);
    EXPECT_DOUBLE_EQ(unit_shown(wanted, "kg m²/s").per_SI, 1e7);
    EXPECT_EQ(unit_shown(wanted, "J").name, "J");
    EXPECT_EQ(unit_shown(wanted, "J").per_SI, 1.0);
}

TEST(Units, OfAngleAlsoGiveThoseOfRates) {
    const std::vector<std::string> degrees{"deg"};
    EXPECT_EQ(unit_shown(degrees, "rad/s").name, "deg/s");
    EXPECT_DOUBLE_EQ(pi * unit_shown(degrees, "rad/s").per_SI, 180.0);
    EXPECT_EQ(unit_shown(degrees, "J").name, "J");
    // Other rates are no angles, and a unit of rates comes first.
    EXPECT_EQ(unit_shown(degrees, "1/s").name, "1/s");
    const std::vector<std::string> both{"turn", "rpm"};
    EXPECT_EQ(unit_shown(both, "rad/s").name, "rpm");
    EXPECT_EQ(unit_shown(both, "rad").name, "turn");
}

TEST(Units, ArePrintedWithSuperscripts) {
    EXPECT_EQ(printed_unit("g*cm^2/s"), "g\u00b7cm\u00b2/s");
    EXPECT_EQ(printed_unit("kg m2 s^-1"), "kg m\u00b2 s\u207b\u00b9");
    EXPECT_EQ(printed_unit("1/s"), "1/s");
    EXPECT_EQ(printed_unit("m**3"), "m\u00b3");
    EXPECT_EQ(printed_unit("kg m\u00b2/s"), "kg m\u00b2/s");
}

TEST(Languages, ChooseTheDecimalMark) {
    for (const std::string_view language : languages()) {
        const bool comma = language != "en" && language != "ja";
        EXPECT_EQ(decimal_mark_of(language), comma ? "," : ".") << language;
        EXPECT_EQ(decimal_mark_in_formula(language), comma ? "{,}" : ".") << language;
    }
    EXPECT_EQ(with_decimal_mark("-12.50", ","), "-12,50");
    EXPECT_EQ(with_decimal_mark("12", ","), "12");
}

TEST(Languages, SelectTheWord) {
    EXPECT_EQ(languages().size(), 6u);
    constexpr Phrase top{"top", "Kreisel", "toupie", "peonza", "trottola", "こま"};
    EXPECT_EQ(phrase_in("en", top), "top");
    EXPECT_EQ(phrase_in("de", top), "Kreisel");
    EXPECT_EQ(phrase_in("ja", top), "こま");
    // A formula is the same in all languages.
    EXPECT_EQ(phrase_in("de", formula("E")), "E");
}

}  // namespace
}  // namespace poinsot
