// Phases kept in quarter turns, two words long, and the elementary functions of what is left of
// them after whole quarter turns are taken off. Written out, without the C library, so that the
// digits are the same on every machine.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "mechanics/double_double.h"

namespace poinsot {

// A rate in two words, its first word split in advance for exact products.
struct TwoWordRate {
    DoubleDouble value;
    DoubleDouble halves;

    TwoWordRate() = default;
    explicit TwoWordRate(DoubleDouble rate) : value(rate), halves(split(rate.hi)) {}
};

// A phase in quarter turns: a whole number modulo 4 and a rest in [−½, ½] to a relative error of
// 1e-16, however small.
struct QuarterTurns {
    unsigned whole = 0;
    double rest = 0.0;
    double rest_low = 0.0;  // what rounding left of the rest
};

// Adding this and taking it off rounds a double below 2^51 to an integer whose low bits it shows.
inline constexpr double rounding_shift = 0x1.8p52;

// start + time·rate with the product to 106 bits. Precondition: |time·rate| < 2^50.
inline QuarterTurns quarter_turns(double time, DoubleDouble time_halves, const TwoWordRate& rate,
                                  DoubleDouble start) {
    const double product = time * rate.value.hi;
    const DoubleDouble& x = time_halves;
    const DoubleDouble& y = rate.halves;
    const double error = ((x.hi * y.hi - product) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo;
    const DoubleDouble sum = two_sum(product, start.hi);
    const double shifted = sum.hi + rounding_shift;
    const double low = sum.lo + (error + (time * rate.value.lo + start.lo));
    const DoubleDouble rest = two_sum(sum.hi - (shifted - rounding_shift), low);
    return {static_cast<unsigned>(std::bit_cast<std::uint64_t>(shifted)) & 3U, rest.hi, rest.lo};
}

// The same for any time. Throws InputError if time·rate overflows.
QuarterTurns distant_quarter_turns(double time, const TwoWordRate& rate, DoubleDouble start);

// The same in one word: the error grows by one rounding of the phase.
inline QuarterTurns quarter_turns_one_word(double time, const TwoWordRate& rate,
                                           DoubleDouble start) {
    const double phase = time * rate.value.hi + start.hi;
    const double shifted = phase + rounding_shift;
    return {static_cast<unsigned>(std::bit_cast<std::uint64_t>(shifted)) & 3U,
            phase - (shifted - rounding_shift), 0.0};
}

struct SinCos {
    double sin;
    double cos;
};

// sin and cos of h quarter turns, |h| ≤ ½ (+ 2^−12). Minimax polynomials: sin to 2^−58 relative,
// cos to 2^−62 absolute.
inline SinCos sin_cos_of_rest(double h) {
    const double t = h * h;
    const double t2 = t * t;
    const double t4 = t2 * t2;
    const double s = (-0x1.4abbce625be41p-1 + 0x1.466bc677586edp-4 * t) +
                     (-0x1.32d2cce2d3d6bp-8 + 0x1.50782fc8c2f21p-13 * t) * t2 +
                     (-0x1.e3006234d2c99p-19 + 0x1.e3ee5254720b9p-25 * t) * t4;
    const double c =
        (0x1.3bd3cc9be45dep+0 + -0x1.03c1f081b5abap-2 * t) +
        (0x1.55d3c7e3ca4ecp-6 + -0x1.e1f506850a02ap-11 * t) * t2 +
        ((0x1.a6d1edad34e2ap-16 + -0x1.f9cd1a5d80e8ep-22 * t) + 0x1.b2a13325e4906p-28 * t2) * t4;
    return {0x1.921fb54442d18p+0 * h + (h * t) * s, 1.0 - t * c};
}

// Turned on by whole quarter turns.
inline SinCos turned(SinCos rest, unsigned whole) {
    constexpr std::array<double, 4> sin_sign{1.0, 1.0, -1.0, -1.0};
    constexpr std::array<double, 4> cos_sign{1.0, -1.0, -1.0, 1.0};
    const std::array<double, 2> parts{rest.sin, rest.cos};
    return {sin_sign[whole] * parts[whole & 1U], cos_sign[whole] * parts[(whole & 1U) ^ 1U]};
}

// e = 2^−y and 1 − e, both to a few 1e-16 relative.
struct PowerOfHalf {
    double power;
    double complement;
};

// 2^−(y + y_low) for y ≥ 0.
PowerOfHalf power_of_half(double y, double y_low);

}  // namespace poinsot
