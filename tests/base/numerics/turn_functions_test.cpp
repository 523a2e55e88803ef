// The elementary functions of phases, against double-double functions that use other series.
#include "numerics/turn_functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "numerics/elliptic_integrals.h"

namespace poinsot {
namespace {

constexpr double unit = 0x1p-53;

// Error of sin and cos of a phase, in units of 2^−53: absolute, or relative where |sin| or |cos| is
// below `small`.
double error_in_units(Pair sin_cos_value, const QuarterTurns& phase, double small = 0.0) {
    SinCosDD truth = sin_cos(phase.rest * pi_dd * 0.5);
    for (unsigned quarter = 0; quarter < phase.whole; ++quarter) truth = {truth.cos, -truth.sin};
    const auto error = [small](double value, DoubleDouble exact) {
        const double size = std::abs(exact.hi) < small ? std::abs(exact.hi) : 1.0;
        return std::abs((DoubleDouble(value) - exact).rounded()) / size / unit;
    };
    return std::max(error(sin_cos_value[0], truth.sin), error(sin_cos_value[1], truth.cos));
}

double worst_of_random_phases() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> rest(-0.5, 0.5);
    double worst = 0.0;
    for (int i = 0; i < 200'000; ++i) {
        const QuarterTurns phase{static_cast<unsigned>(i) % 4U, rest(random)};
        worst = std::max(worst, error_in_units(sin_cos(phase), phase));
        // The same phase as the first of a pair.
        const QuarterTurnPair pair{{phase.whole, 1}, Pair{phase.rest.hi, 0.25}, Pair{0.0, 0.0}};
        const SinCosPair two = sin_cos(fine(pair));
        worst = std::max(worst, error_in_units(firsts(two.sin, two.cos), phase));
    }
    return worst;
}

TEST(TurnFunctions, SineAndCosineAreAccurateTo0p6Ulp) { EXPECT_LE(worst_of_random_phases(), 0.60); }

TEST(TurnFunctions, SineAndCosineKeepRelativeAccuracyAtZeros) {
    for (const double h : {1e-3, 1e-5, 1e-9, 1e-100, 1e-300, -1e-4, -1e-200}) {
        for (unsigned whole = 0; whole < 4; ++whole) {
            const QuarterTurns phase{whole, h};
            EXPECT_LE(error_in_units(sin_cos(phase), phase, 0x1p-8), 2.0) << h << whole;
        }
    }
    const Pair at_zero = sin_cos(QuarterTurns{});
    EXPECT_EQ(at_zero[0], 0.0);
    EXPECT_EQ(at_zero[1], 1.0);
}

TEST(TurnFunctions, PowersAndComplementsKeepRelativeAccuracy) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> exponent(-30.0, std::log2(128'000.0));
    double worst = 0.0;
    double worst_up = 0.0;
    for (int i = 0; i < 100'000; ++i) {
        const double y = std::exp2(exponent(random));
        const PowersOfHalf value = powers_of_half(y, 0.0, 0x1p-100);
        const DoubleDouble down = exp(ln2_dd * (-y / 128.0));
        const auto relative = [](double x, DoubleDouble truth) {
            return std::abs(((DoubleDouble(x) - truth) / truth).rounded()) / unit;
        };
        worst = std::max({worst, relative(value.powers[0], down),
                          relative(value.complements[0], DoubleDouble(1.0) - down)});
        if (y > 70'000.0) continue;  // 2^(−100−512+547)
        worst_up = std::max(worst_up, relative(value.powers[1], DoubleDouble(0x1p-612) / down));
    }
    EXPECT_LE(worst, 4.0);
    EXPECT_LE(worst_up, 4.0);
}

// Phases grow without rounding error: compared with the product in double-double, whole quarter
// turns removed.
TEST(TurnFunctions, PhasesLoseNoDigitsAtLongTimes) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> digits(-15.0, 18.0);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int i = 0; i < 10'000; ++i) {
        PhasePair phases;
        const auto two_words = [&] {
            const double high = number(random);
            return DoubleDouble{high, 0x1p-54 * high * number(random)};
        };
        const DoubleDouble rate = two_words();
        const DoubleDouble start = two_words();
        phases.set(0, rate, start);
        phases.set(1, DoubleDouble(0.0), DoubleDouble(0.0));
        const double time = number(random) * std::pow(10.0, digits(random));
        const DoubleDouble truth = rate * time + start;
        const auto off = [&](unsigned whole, DoubleDouble rest) {
            // The difference modulo four quarter turns, in both words.
            DoubleDouble difference = truth - rest - DoubleDouble(whole);
            for (int word = 0; word < 2; ++word) {
                difference = difference - 4.0 * std::nearbyint(difference.hi / 4.0);
            }
            return std::abs(difference.rounded());
        };
        const QuarterTurns exact = phases.at(time)[0];
        // The rounding of the rest is exact; of the 106 bits of the phase, 2^−100 remain accurate.
        EXPECT_LE(off(exact.whole, exact.rest), 0x1p-100 * (1.0 + std::abs(truth.hi)));
    }
}

}  // namespace
}  // namespace poinsot
