// Phases kept in quarter turns, two words long, and the elementary functions of what is left of
// them after whole quarter turns are taken off. Written out, without the C library, so that the
// digits are the same on every machine.
#pragma once

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "mechanics/double_double.h"

namespace poinsot {

// A phase in quarter turns: a whole number modulo 4 and a rest in [−½, ½] to a relative error of
// 1e-16, however small.
struct QuarterTurns {
    unsigned whole = 0;
    double rest = 0.0;
    double rest_low = 0.0;  // what rounding left of the rest
};

// Adding this and taking it off rounds a double below 2^51 to an integer whose low bits it shows.
inline constexpr double rounding_shift = 0x1.8p52;
inline unsigned low_bits(double shifted) {
    return static_cast<unsigned>(std::bit_cast<std::uint64_t>(shifted));
}

// Two phases side by side: one instruction does for both.
using Pair = Eigen::Array2d;

struct QuarterTurnPair {
    Pair rest{0.0, 0.0};
    Pair rest_low{0.0, 0.0};
    std::array<unsigned, 2> whole{};

    QuarterTurns operator[](int i) const {
        return {whole[static_cast<std::size_t>(i)], rest[i], rest_low[i]};
    }
};

// Two phases in quarter turns that grow with time: start + time·rate, each number in two words.
class PhasePair {
 public:
    void set(int i, DoubleDouble rate, DoubleDouble start);
    DoubleDouble rate(int i) const { return {rate_[i], rate_low_[i]}; }
    DoubleDouble start(int i) const { return {start_[i], start_low_[i]}; }

    // With the product to 106 bits (Dekker). Throws InputError if time·rate overflows.
    QuarterTurnPair at(double time) const {
        if (!(std::abs(time) < far_)) [[unlikely]] {
            const QuarterTurnPair turns = at_distant(time);
            return {turns.rest, turns.rest_low, turns.whole};
        }
        const DoubleDouble t = split(time);
        const Pair product = time * rate_;
        const Pair error = ((t.hi * rate_high_ - product) + t.hi * rate_rest_ + t.lo * rate_high_) +
                           t.lo * rate_rest_;
        // product + start in two words (Knuth).
        const Pair sum = product + start_;
        const Pair start_part = sum - product;
        const Pair sum_low = (product - (sum - start_part)) + (start_ - start_part);
        const Pair low = sum_low + (error + (time * rate_low_ + start_low_));
        const Pair shifted = sum + rounding_shift;
        const Pair high = sum - (shifted - rounding_shift);
        const Pair rest = high + low;
        const Pair low_part = rest - high;
        const Pair rest_low = (high - (rest - low_part)) + (low - low_part);
        return {rest, rest_low, {low_bits(shifted[0]) & 3U, low_bits(shifted[1]) & 3U}};
    }

    // The same in one word: the error grows by one rounding of the phase.
    QuarterTurnPair at_in_one_word(double time) const {
        if (!(std::abs(time) < far_)) [[unlikely]] {
            const QuarterTurnPair turns = at_distant(time);
            return {turns.rest, turns.rest_low, turns.whole};
        }
        const Pair phase = time * rate_ + start_;
        const Pair shifted = phase + rounding_shift;
        const Pair rest = phase - (shifted - rounding_shift);
        return {rest, Pair::Zero(), {low_bits(shifted[0]) & 3U, low_bits(shifted[1]) & 3U}};
    }

 private:
    QuarterTurnPair at_distant(double time) const;

    Pair rate_{0.0, 0.0}, rate_low_{0.0, 0.0};
    Pair rate_high_{0.0, 0.0}, rate_rest_{0.0, 0.0};  // the first word's halves
    Pair start_{0.0, 0.0}, start_low_{0.0, 0.0};
    double far_ = 0.0;  // from here on a phase could pass 2^49 quarter turns
};

// The phase moved on by |turns| < 2^50.
inline QuarterTurns moved_on(const QuarterTurns& phase, double turns) {
    const DoubleDouble sum = two_sum(phase.rest, turns);
    const double shifted = sum.hi + rounding_shift;
    const DoubleDouble rest = two_sum(sum.hi - (shifted - rounding_shift), sum.lo + phase.rest_low);
    return {(phase.whole + low_bits(shifted)) & 3U, rest.hi, rest.lo};
}

struct SinCos {
    double sin;
    double cos;
};

// (sin, cos) of h quarter turns, |h| ≤ ½ (+ 2^−12), side by side: (πh/2, 1) + (h, −1)·h²·(minimax
// polynomials in h²), sin to 2^−58 relative, cos to 2^−62 absolute.
inline Pair sin_cos_of_rest(double h) {
    // Pairs are read whole from memory: written word by word first, they would stall.
    alignas(16) static constexpr double table[11][2] = {
        {-0x1.4abbce625be41p-1, 0x1.3bd3cc9be45dep+0},
        {0x1.466bc677586edp-4, -0x1.03c1f081b5abap-2},
        {-0x1.32d2cce2d3d6bp-8, 0x1.55d3c7e3ca4ecp-6},
        {0x1.50782fc8c2f21p-13, -0x1.e1f506850a02ap-11},
        {-0x1.e3006234d2c99p-19, 0x1.a6d1edad34e2ap-16},
        {0x1.e3ee5254720b9p-25, -0x1.f9cd1a5d80e8ep-22},
        {0.0, 0x1.b2a13325e4906p-28},
        {0x1.921fb54442d18p+0, 0.0},
        {0.0, 1.0},
        {1.0, 0.0},
        {0.0, -1.0}};
    const auto row = [](int n) { return Eigen::Map<const Pair, Eigen::Aligned16>(&table[n][0]); };
    const double t = h * h;
    const double t2 = t * t;
    const double t4 = t2 * t2;
    const Pair sum = (row(0) + row(1) * t) + (row(2) + row(3) * t) * t2 +
                     ((row(4) + row(5) * t) + row(6) * t2) * t4;
    return (row(7) * h + row(8)) + ((row(9) * h + row(10)) * t) * sum;
}

// Turned on by whole quarter turns: each of sin and cos times 0, 1 or −1, and the other one.
inline SinCos turned(const Pair& sin_cos, unsigned whole) {
    alignas(16) static constexpr double same[4][2] = {
        {1.0, 1.0}, {0.0, 0.0}, {-1.0, -1.0}, {0.0, 0.0}};
    alignas(16) static constexpr double other[4][2] = {
        {0.0, 0.0}, {1.0, -1.0}, {0.0, 0.0}, {-1.0, 1.0}};
    using Row = Eigen::Map<const Pair, Eigen::Aligned16>;
    const Pair result = sin_cos * Row(&same[whole][0]) + sin_cos.reverse() * Row(&other[whole][0]);
    return {result[0], result[1]};
}
inline SinCos sin_cos(const QuarterTurns& phase) {
    return turned(sin_cos_of_rest(phase.rest), phase.whole);
}

// e = 2^−y and 1 − e, both to a few 1e-16 relative.
struct PowerOfHalf {
    double power;
    double complement;
};

// 2^−(y + y_low) for y ≥ 0.
PowerOfHalf power_of_half(double y, double y_low);

}  // namespace poinsot
