// Decimals, fractions and progressions, each rounded once: held to GMP's rationals and to MPFR.
#include "text/rational.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "text/numbers.h"
#include "text/random_decimals.h"
#include "text/units.h"

namespace poinsot::testing::rational_tests {
namespace {

// 100,000 decimals, a quarter of them at or beside the middle of two doubles.
std::vector<std::string> decimals() {
    RandomDecimals random(33);
    std::vector<std::string> texts{"4.155289061186346",
                                   "9007199254740993",
                                   "9007199254740992.9999999999999999",
                                   "2.4703282292062327e-324",
                                   "2.4703282292062328e-324",
                                   "1.7976931348623158e308",
                                   "0",
                                   "-0.0"};
    while (texts.size() < 75'000) texts.push_back(random.any(texts.size() % 3 == 0 ? 320 : 4));
    while (texts.size() < 100'000) {
        const double size = texts.size() % 2 == 0 ? random.any_double() : random.ordinary_double();
        texts.push_back(random.near_a_middle(size));
    }
    return texts;
}

TEST(NumbersReadOnce, AreTheDoublesThatMPFRReads) {
    int n_finite = 0;
    for (const std::string& text : decimals()) {
        const double right = read_by_mpfr(text);
        const auto rational = rational_of(text);
        ASSERT_TRUE(rational) << text;
        ASSERT_EQ(nearest_double(*rational), right) << text;
        if (!std::isfinite(right)) {
            ASSERT_FALSE(number_of<double>(text)) << text;
            continue;
        }
        ++n_finite;
        ASSERT_EQ(number_of<double>(text), right) << text;
        ASSERT_EQ(measured_in(text + " s", *unit_named("s")), right) << text;
    }
    EXPECT_GT(n_finite, 95'000);
}

TEST(NumbersReadOnce, BelowTheSmallestDoubleAreZeroOrIt) {
    EXPECT_EQ(number_of<double>("1e-400"), 0.0);
    EXPECT_EQ(number_of<double>("-1e-99999999999999999999"), 0.0);
    EXPECT_EQ(number_of<double>("0." + std::string(400, '0') + "1"), 0.0);
    EXPECT_EQ(number_of<double>("0." + std::string(400, '0') + "1e10"), 0.0);
    EXPECT_EQ(number_of<double>("1" + std::string(400, '0') + "e-800"), 0.0);
    EXPECT_EQ(number_of<double>("3e-324"), std::numeric_limits<double>::denorm_min());
    EXPECT_FALSE(number_of<double>("1" + std::string(400, '0')));
    EXPECT_FALSE(number_of<double>("0.1e99999999999999999999"));
}

TEST(Rationals, ReadWhatFromCharsReads) {
    for (const char* text : {"1", "-1.5e3", ".5", "5.", "0e5", "1e+2", "007", "1E-2"}) {
        ASSERT_TRUE(rational_of(text)) << text;
        EXPECT_EQ(nearest_double(*rational_of(text)), number_of<double>(text)) << text;
    }
    for (const char* text : {"", ".", "-", "+1", "e5", "1e", "1e+", "0x1", " 1", "1 ", "inf", "nan",
                             "1,5", "--1", "1e5001", "1e-5002", "1e99999999999999999999"})
        EXPECT_FALSE(rational_of(text)) << text;
    EXPECT_FALSE(rational_of(std::string(1001, '1')));
    EXPECT_TRUE(rational_of("1" + std::string(3000, '0') + "e-3000"));
    // An "e" that begins no exponent belongs to the following text.
    std::string_view rest = "24e m";
    EXPECT_EQ(nearest_double(*take_decimal(rest)), 24.0);
    EXPECT_EQ(rest, "e m");
}

TEST(Rationals, ReckonAsGMPDoes) {
    RandomDecimals random(34);
    for (int i = 0; i < 20'000; ++i) {
        const int most_exponent = i % 4 == 0 ? 160 : 5;
        const std::string ta = random.any(most_exponent), tb = random.any(most_exponent),
                          tc = random.any(most_exponent);
        const Rational a = *rational_of(ta), b = *rational_of(tb), c = *rational_of(tc);
        const Exact A = Exact::of_decimal(ta), B = Exact::of_decimal(tb), C = Exact::of_decimal(tc);
        ASSERT_EQ(nearest_double(a + b), (A + B).nearest()) << ta << " + " << tb;
        ASSERT_EQ(nearest_double(a - b * c), (A - B * C).nearest()) << ta << " " << tb << " " << tc;
        if (C.is_zero()) continue;
        ASSERT_EQ(nearest_double((a - b) / c), ((A - B) / C).nearest())
            << ta << " " << tb << " " << tc;
        ASSERT_EQ(nearest_double(a / c + b / 7), (A / C + B / 7).nearest()) << ta << " " << tb;
        ASSERT_EQ(nearest_double(a / c - a / c), 0.0);
    }
    EXPECT_EQ(nearest_double(Rational(std::numeric_limits<std::int64_t>::min())), -0x1p63);
    for (int i = 0; i < 1000; ++i) {
        const double x = random.any_double();
        ASSERT_EQ(nearest_double(Rational(x)), x);
    }
}

// Also where the step has more digits than a pair of doubles, where terms cancel, and where
// products are exact middles, which the fast way leaves to the exact one.
TEST(Progressions, GiveTheDoublesNearestToFirstPlusKSteps) {
    RandomDecimals random(35);
    for (int i = 0; i < 20'000; ++i) {
        const std::string first_text = i % 5 == 0 ? "0" : random.any(i % 4 == 0 ? 300 : 3);
        const std::string step_text = i % 7 == 0    ? random.near_a_middle(random.ordinary_double())
                                      : i % 11 == 0 ? random.any(300)
                                                    : random.any(2);
        const Exact first = Exact::of_decimal(first_text), step = Exact::of_decimal(step_text);
        const Progression numbers(*rational_of(first_text), *rational_of(step_text));
        for (const std::int64_t k : {std::int64_t{0}, std::int64_t{1}, std::int64_t{2},
                                     random.between(3, 1000), random.between(1, 100'000'000)})
            ASSERT_EQ(numbers.at(k), (first + Exact(k) * step).nearest())
                << first_text << " + " << k << " * " << step_text;
    }
    const Progression to_zero(-1, *rational_of("0.1"));
    EXPECT_EQ(to_zero.at(10), 0.0);
    EXPECT_FALSE(std::signbit(to_zero.at(10)));
    EXPECT_EQ(to_zero.at(3), -0.7);
}

struct SI {
    const char* unit;
    const char* factor;  // over divisor, times π^power_of_pi
    std::int64_t divisor;
    int power_of_pi;
    const char* in;
};

// Every unit by its definition, with and without fractions and π.
TEST(Units, GiveTheNearestDoubleOfAnyNumber) {
    constexpr SI table[] = {
        {"g", "1", 1000, 0, "kg"},
        {"lb", "0.45359237", 1, 0, "kg"},
        {"oz", "0.028349523125", 1, 0, "kg"},
        {"in", "0.0254", 1, 0, "m"},
        {"ft", "0.3048", 1, 0, "m"},
        {"nm", "1", 1'000'000'000, 0, "m"},
        {"min", "60", 1, 0, "s"},
        {"yr", "31557600", 1, 0, "s"},
        {"g cm²", "1", 10'000'000, 0, "kg m²"},
        {"lb ft²", "0.0421401100938048", 1, 0, "kg m²"},
        {"g/cm³", "1000", 1, 0, "kg/m³"},
        {"mJ", "0.001", 1, 0, "N m"},
        {"deg", "1", 180, 1, "rad"},
        {"turns", "2", 1, 1, "rad"},
        {"rpm", "1", 30, 1, "rad/s"},
        {"deg/min", "1", 10'800, 1, "rad/s"},
        {"deg²", "1", 32'400, 2, "rad²"},
        {"1/deg", "180", 1, -1, "1/rad"},
        {"rad", "180", 1, -1, "deg"},
        {"turn", "360", 1, 0, "deg"},
        {"rpm", "6", 1, 0, "deg/s"},
    };
    RandomDecimals random(36);
    for (const SI& row : table) {
        const Exact factor = Exact::of_decimal(row.factor) / Exact(row.divisor);
        const Unit wanted = *unit_named(row.in);
        for (int i = 0; i < 1000; ++i) {
            const std::string number = random.any(i % 3 == 0 ? 310 : 4);
            ASSERT_EQ(measured_in(number + " " + row.unit, wanted),
                      (Exact::of_decimal(number) * factor).nearest(row.power_of_pi))
                << number << " " << row.unit;
            const std::int64_t whole = random.between(0, 999), above = random.between(0, 99'999),
                               below = random.between(1, 99'999);
            const std::string mixed = std::to_string(whole) + " " + std::to_string(above) + "/" +
                                      std::to_string(below) + " " + row.unit;
            ASSERT_EQ(
                measured_in(mixed, wanted),
                ((Exact(whole) + Exact(above) / Exact(below)) * factor).nearest(row.power_of_pi))
                << mixed;
        }
        // The middles of two doubles in SI, written in this unit.
        if (row.power_of_pi != 0) continue;
        for (int i = 0; i < 100; ++i) {
            const std::string number = random.near_a_middle(std::abs(random.any_double()));
            ASSERT_EQ(measured_in(number + " " + row.unit, wanted),
                      (Exact::of_decimal(number) * factor).nearest())
                << number << " " << row.unit;
        }
    }
}

// Longer products than anybody writes would take any time.
TEST(Units, AreProductsOfAtMostSixteen) {
    std::string sixteen = "m";
    for (int i = 1; i < 16; ++i) sixteen += " m^-1";
    EXPECT_TRUE(unit_named(sixteen));
    EXPECT_FALSE(unit_named(sixteen + " m"));
    std::string many;
    for (int i = 0; i < 100'000; ++i) many += "oz^9 ";
    EXPECT_FALSE(measured("1 " + many));
}

}  // namespace
}  // namespace poinsot::testing::rational_tests
