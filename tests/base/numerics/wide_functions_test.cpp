// Elementary functions of wide double-double numbers, compared with MPFR.
#include "numerics/wide_functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <random>

namespace poinsot::wide_functions_tests {
namespace {

using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<120>,
                                           boost::multiprecision::et_off>;

Real exact(const WideDouble& x) {
    const DoubleDouble significand = x.significand();
    return ldexp(Real(significand.hi) + Real(significand.lo), x.exponent());
}
double relative_error(const WideDouble& got, const Real& expected) {
    return static_cast<double>(abs(exact(got) - expected) / abs(expected));
}

// A random number of either sign with digits in both words, |x| from 2^low to 2^high.
WideDouble random_wide(std::mt19937_64& random, int low, int high) {
    std::uniform_real_distribution<double> significand(0.5, 1.0);
    std::uniform_int_distribution<int> exponent(low, high);
    const double hi = (random() % 2 == 0 ? 1.0 : -1.0) * significand(random);
    return WideDouble(fast_two_sum(hi, std::ldexp(significand(random), -54)), exponent(random));
}

TEST(WideFunctions, ExponentialAndHyperbolicFunctionsAgreeWithMpfr) {
    std::mt19937_64 random(1);
    double worst = 0.0;
    for (int n = 0; n < 4000; ++n) {
        // e^x reaches 2^±23,000, far beyond the range of a double; its relative error grows with
        // |x|.
        const WideDouble x = random_wide(random, n % 2 == 0 ? -1100 : -8, 14);
        const WideSinCos h = sinh_cosh(x);
        const double size = std::max(1.0, std::abs(x.rounded()));
        worst = std::max({worst, relative_error(exp(x), exp(exact(x))) / size,
                          relative_error(h.sin, sinh(exact(x))) / size,
                          relative_error(h.cos, cosh(exact(x))) / size});
    }
    EXPECT_LE(worst, 1e-29);
    EXPECT_EQ(exp(WideDouble()).rounded(), 1.0);
    EXPECT_TRUE(sinh_cosh(WideDouble()).sin.is_zero());
}

TEST(WideFunctions, SineAndCosineAgreeWithMpfr) {
    std::mt19937_64 random(2);
    double worst = 0.0, worst_small = 0.0;
    for (int n = 0; n < 4000; ++n) {
        const WideDouble x = random_wide(random, n % 2 == 0 ? -1100 : -8, 10);
        const WideSinCos turn = sin_cos(x);
        // The error is relative to the angle: reducing many turns costs as many digits.
        const double size = std::max(1.0, std::abs(x.rounded()));
        worst = std::max({worst, static_cast<double>(abs(exact(turn.sin) - sin(exact(x)))) / size,
                          static_cast<double>(abs(exact(turn.cos) - cos(exact(x)))) / size});
        if (abs(x) < WideDouble(1.0))
            worst_small = std::max(worst_small, relative_error(turn.sin, sin(exact(x))));
    }
    // The double nearest to a quarter turn; its cosine is 6e-17.
    const WideDouble quarter(std::acos(0.0));
    EXPECT_LE(relative_error(sin_cos(quarter).cos, cos(exact(quarter))), 1e-29);
    EXPECT_LE(relative_error(sin_cos(quarter * 3.0).cos, cos(exact(quarter * 3.0))), 1e-29);
    EXPECT_LE(worst, 1e-30);
    EXPECT_LE(worst_small, 1e-29);
}

TEST(WideFunctions, ArctangentsAgreeWithMpfr) {
    std::mt19937_64 random(3);
    double worst = 0.0;
    for (int n = 0; n < 4000; ++n) {
        const int range = n % 2 == 0 ? 1100 : 3;
        const WideDouble y = random_wide(random, -range, range);
        const WideDouble x = random_wide(random, -range, range);
        worst = std::max(worst, relative_error(atan2(y, x), atan2(exact(y), exact(x))));
    }
    EXPECT_LE(worst, 1e-29);
    const double pi = std::acos(-1.0);
    EXPECT_EQ(atan2(0.0, 2.0).rounded(), 0.0);
    EXPECT_EQ(atan2(0.0, -2.0).rounded(), pi);
    EXPECT_EQ(atan2(2.0, 0.0).rounded(), 0.5 * pi);
    EXPECT_EQ(atan2(-2.0, 0.0).rounded(), -0.5 * pi);
    EXPECT_EQ(atan2(0.0, 0.0).rounded(), 0.0);
}

TEST(WideFunctions, PowersEqualRepeatedProducts) {
    const WideDouble x(1.0 / 3.0);
    WideDouble product = 1.0;
    for (int n = 0; n <= 90; ++n, product = product * x)
        EXPECT_LE(relative_error(power(x, n), exact(product)), 1e-29) << n;
    EXPECT_EQ(power(WideDouble(), 0).rounded(), 1.0);
    EXPECT_TRUE(power(WideDouble(), 2).is_zero());
}

}  // namespace
}  // namespace poinsot::wide_functions_tests
