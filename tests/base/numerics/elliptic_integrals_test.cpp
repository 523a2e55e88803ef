// Tests of double-double and wide double-double arithmetic, expansions, and the elliptic integrals
// computed with them.
#include "numerics/elliptic_integrals.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <random>

#include "error/error.h"
#include "numerics/expansion.h"

namespace poinsot {
namespace {

using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<120>,
                                           boost::multiprecision::et_off>;

Real exact(DoubleDouble x) { return Real(x.hi) + Real(x.lo); }
Real exact(const WideDouble& x) {
    return boost::multiprecision::ldexp(exact(x.significand()), x.exponent());
}
double relative_error(const Real& got, const Real& expected) {
    return static_cast<double>(abs(got - expected) / abs(expected));
}

// A double-double with digits in both words.
DoubleDouble random_pair(std::mt19937_64& random) {
    std::uniform_real_distribution<double> significand(0.5, 2.0);
    return fast_two_sum(significand(random), std::ldexp(significand(random), -54));
}

TEST(DoubleDouble, OperationsAreAccurateTo103Bits) {
    std::mt19937_64 random(1);
    double worst = 0.0;
    for (int n = 0; n < 20000; ++n) {
        const DoubleDouble a = random_pair(random);
        const DoubleDouble b = random_pair(random);
        worst = std::max({worst, relative_error(exact(a * b), exact(a) * exact(b)),
                          relative_error(exact(a / b), exact(a) / exact(b)),
                          relative_error(exact(a + b), exact(a) + exact(b)),
                          relative_error(exact(sqrt(a)), sqrt(exact(a)))});
        // The same under cancellation.
        const DoubleDouble near = a + DoubleDouble(std::ldexp(1.0, -60));
        worst = std::max(worst, relative_error(exact(near - a), exact(near) - exact(a)));
    }
    EXPECT_LE(worst, 0x1p-103);  // measured 2^-104.4
}

TEST(DoubleDouble, SumsAndProductsOfDoublesAreExact) {
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    for (int n = 0; n < 10000; ++n) {
        const double a = std::ldexp(normal(random), n % 90);
        const double b = normal(random);
        EXPECT_EQ(exact(two_sum(a, b)), Real(a) + Real(b));
        EXPECT_EQ(exact(two_product(a, b)), Real(a) * Real(b));
    }
}

TEST(WideDouble, NeitherOverflowsNorLosesDigits) {
    const WideDouble tiny = WideDouble(1e-300) * WideDouble(3e-300);
    EXPECT_EQ(relative_error(exact(tiny), Real(1e-300) * Real(3e-300)), 0.0);
    EXPECT_LE(relative_error(exact(sqrt(tiny)), sqrt(Real(1e-300) * Real(3e-300))), 1e-31);
    EXPECT_EQ(sqrt(tiny * tiny).rounded(), tiny.rounded());
    EXPECT_EQ((tiny / WideDouble(1e-300)).rounded(), 3e-300);
    const WideDouble huge = WideDouble(1e300) * WideDouble(1e300);
    EXPECT_TRUE(std::isinf(huge.rounded()));
    EXPECT_EQ((huge / WideDouble(1e300)).rounded(), 1e300);
    EXPECT_EQ((WideDouble(5e-324) * WideDouble(0.5)).exponent(), -1074);
    EXPECT_TRUE((tiny - tiny).is_zero());
    EXPECT_LT(WideDouble(-1.0), tiny);
}

TEST(Expansion, GivesTheSignOfACancellingDifference) {
    // (1 + ε)² − (1 + 2ε) = ε², which is 52 bits below the last bit of a double.
    const double epsilon = 0x1p-52;
    const Expansion square = Expansion(1.0 + epsilon).times(1.0 + epsilon);
    EXPECT_EQ(square.plus(-1.0 - 2.0 * epsilon).value().hi, epsilon * epsilon);
    EXPECT_EQ(square.plus(square.times(-1.0)).value().hi, 0.0);
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    for (int n = 0; n < 1000; ++n) {
        const double a = normal(random);
        const double b = normal(random);
        const double c = normal(random);
        const DoubleDouble d = two_sum(normal(random), 1e-10 * normal(random));
        const Expansion product = Expansion(a).times(b).times(c).times(d);
        const Real expected = Real(a) * b * c * exact(d);
        EXPECT_LE(relative_error(exact(product.value()), expected), 1e-31);
        // After subtracting its leading double, the rest still has full precision.
        const double leading = product.value().hi;
        EXPECT_LE(relative_error(exact(product.plus(-leading).value()), expected - leading), 1e-31);
    }
}

// Legendre's relation E K′ + E′K − K K′ = π/2 (DLMF 19.7.1), with E = cel(k′, 1, 1, k′²).
TEST(EllipticIntegrals, ObeyLegendresRelation) {
    for (const double k_complement : {0.999, 0.8, 0.5, 0.1, 1e-3, 1e-6}) {
        const WideDouble kc = k_complement;
        const WideDouble k = sqrt((WideDouble(1.0) - kc) * (WideDouble(1.0) + kc));
        const WideDouble K = complete_first_kind(kc);
        const WideDouble K_other = complete_first_kind(k);
        const WideDouble E = bulirsch_cel(kc, 1.0, 1.0, kc * kc);
        const WideDouble E_other = bulirsch_cel(k, 1.0, 1.0, k * k);
        const WideDouble sum = E * K_other + E_other * K - K * K_other;
        EXPECT_LE(relative_error(exact(sum), exact(pi_dd) / 2), 1e-29) << k_complement;
    }
}

TEST(EllipticIntegrals, SatisfyIdentitiesAndKnownValues) {
    for (const double k_complement : {1.0, 0.9, 0.3, 1e-2, 1e-8, 1e-100, 1e-300}) {
        const WideDouble kc = k_complement;
        const Real K = exact(complete_first_kind(kc));
        EXPECT_LE(relative_error(exact(carlson_rf(0.0, kc * kc, 1.0)), K), 1e-29);
        EXPECT_LE(relative_error(exact(bulirsch_cel(kc, 1.0, 1.0, 1.0)), K), 1e-29);
        // cel is linear in a and b, and has closed forms for p = 1 and p = k′².
        const WideDouble parts = bulirsch_cel(kc, 2.0, 1.0, 0.0) + bulirsch_cel(kc, 2.0, 0.0, 2.0);
        EXPECT_LE(relative_error(exact(parts), K), 1e-29);
    }
    // K → ln(4/k′): the remainder is of order k′².
    const Real K = exact(complete_first_kind(WideDouble(1e-200)));
    EXPECT_LE(relative_error(K, log(4 / Real(1e-200))), 1e-30);
    // R_F(x, x, x) = 1/√x and homogeneity.
    EXPECT_LE(relative_error(exact(carlson_rf(2.0, 2.0, 2.0)), 1 / sqrt(Real(2))), 1e-31);
    const Real one = exact(carlson_rf(0.3, 0.7, 1.9));
    const Real four = exact(carlson_rf(4 * 0.3, 4 * 0.7, 4 * 1.9));
    EXPECT_LE(relative_error(four, one / 2), 1e-30);
    // R_F(0, 1, 1) = π/2.
    EXPECT_LE(relative_error(exact(carlson_rf(0.0, 1.0, 1.0)), exact(pi_dd) / 2), 1e-30);
}

TEST(EllipticIntegrals, ElementaryFunctionsAgreeWithMpfr) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> wide(-700.0, 700.0);
    std::uniform_real_distribution<double> angle(-3.14, 3.14);
    for (int n = 0; n < 2000; ++n) {
        const DoubleDouble x = wide(random);
        // Below x = −600 the low word of the result is subnormal.
        if (x.hi > -600.0) {
            EXPECT_LE(relative_error(exact(exp(x)), exp(exact(x))), 1e-28);
        }
        const DoubleDouble y = angle(random);
        const SinCosDD z = sin_cos(y);
        EXPECT_LE(static_cast<double>(abs(exact(z.sin) - sin(exact(y)))), 1e-30);
        EXPECT_LE(static_cast<double>(abs(exact(z.cos) - cos(exact(y)))), 1e-30);
    }
    EXPECT_EQ(exp(DoubleDouble(-800.0)).hi, 0.0);
    EXPECT_EQ(exp(DoubleDouble(0.0)).hi, 1.0);
}

// Of NaN, and at the edge of the domain, no sequence of means converges.
TEST(EllipticIntegrals, RefuseArgumentsWithoutAValue) {
    const WideDouble nan = std::nan(""), infinite = HUGE_VAL, one = 1.0, zero = 0.0;
    for (const WideDouble& bad : {nan, infinite}) {
        EXPECT_THROW(complete_first_kind(bad), InputError);
        EXPECT_THROW(bulirsch_cel(bad, one, one, one), InputError);
        EXPECT_THROW(bulirsch_cel(one, bad, one, one), InputError);
        EXPECT_THROW(carlson_rf(bad, one, one), InputError);
        EXPECT_THROW(carlson_rf(one, bad, one), InputError);
        EXPECT_THROW(carlson_rf(one, one, bad), InputError);
    }
    EXPECT_THROW(complete_first_kind(zero), InputError);
    EXPECT_THROW(bulirsch_cel(zero, one, one, one), InputError);
    EXPECT_THROW(carlson_rf(zero, zero, one), InputError);
    EXPECT_THROW(carlson_rf(zero, zero, zero), InputError);
}

// K = R_F(0, k′², 1) = ln(4/k′) for k′ far below double's range.
TEST(EllipticIntegrals, ConvergeFarBelowTheSmallestDouble) {
    for (const int exponent : {-1000, -4000, -100000}) {
        const WideDouble tiny = ldexp(WideDouble(1.0), exponent);
        const Real expected = log(Real(4)) - exponent * log(Real(2));
        EXPECT_LE(relative_error(exact(complete_first_kind(tiny)), expected), 1e-29) << exponent;
        EXPECT_LE(relative_error(exact(carlson_rf(0.0, square(tiny), 1.0)), expected), 1e-29)
            << exponent;
    }
}

}  // namespace
}  // namespace poinsot
