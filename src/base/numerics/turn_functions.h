// Phases stored in quarter turns as two words, and the elementary functions of the remainder after
// whole quarter turns. Implemented here, without the C library, so that the digits are the same on
// every machine.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "numerics/double_double.h"
#include "numerics/double_pair.h"

namespace poinsot {

// A phase in quarter turns: a whole number modulo 4 and a rest in [−½, ½]. The rest has a relative
// error of 1e-16, however small it is.
struct QuarterTurns {
    unsigned whole = 0;
    DoubleDouble rest;
};

// Adding and then subtracting this constant rounds a double below 2^51 to an integer; the low bits
// of the sum are the integer's low bits.
inline constexpr double rounding_shift = 0x1.8p52;
// The same for multiples of 1/64 and doubles below 2^45.
inline constexpr double rounding_shift_to_64ths = 0x1.8p46;
inline unsigned low_bits(double shifted) {
    return static_cast<unsigned>(std::bit_cast<std::uint64_t>(shifted));
}

// Two phases side by side. The rest is the sum of two words, and the second word is not always the
// smaller one.
struct QuarterTurnPair {
    std::array<unsigned, 2> whole{};
    Pair rest{0.0, 0.0};
    Pair rest_low{0.0, 0.0};

    QuarterTurns operator[](int i) const {
        return {whole[static_cast<std::size_t>(i)], two_sum(rest[i], rest_low[i])};
    }
};

// Two phases in 1/256 of a turn: a whole number modulo 256 and a rest, in quarter turns, of at most
// 1/128.
struct FineTurnPair {
    std::array<unsigned, 2> whole{};
    Pair rest{0.0, 0.0};
};
[[gnu::always_inline]] inline FineTurnPair fine(const QuarterTurnPair& turns) {
    const Pair shifted = (turns.rest + turns.rest_low) + rounding_shift_to_64ths;
    return {{(64 * turns.whole[0] + low_bits(shifted[0])) & 255U,
             (64 * turns.whole[1] + low_bits(shifted[1])) & 255U},
            (turns.rest - (shifted - rounding_shift_to_64ths)) + turns.rest_low};
}

// Two phases in quarter turns that grow linearly in time: start + time·rate, each number in two
// words.
class PhasePair {
 public:
    void set(int i, DoubleDouble rate, DoubleDouble start);
    DoubleDouble rate(int i) const { return {rate_[i], rate_low_[i]}; }
    DoubleDouble start(int i) const { return {start_[i], start_low_[i]}; }

    // The phases at this time. The product is computed to 106 bits (Dekker), so that no digit is
    // lost as time grows. Throws InputError if time·rate overflows.
    [[gnu::always_inline]] QuarterTurnPair at(double time) const {
        if (!(std::abs(time) < far_)) [[unlikely]]
            return at_distant(time);
        const DoubleDouble t = split(time);
        const Pair product = time * rate_;
        const Pair error = ((t.hi * rate_high_ - product) + t.hi * rate_rest_ + t.lo * rate_high_) +
                           t.lo * rate_rest_;
        // product + start in two words (Knuth).
        const Pair sum = product + start_;
        const Pair start_part = sum - product;
        const Pair sum_low = (product - (sum - start_part)) + (start_ - start_part);
        const Pair shifted = sum + rounding_shift;
        return {quarters(shifted), sum - (shifted - rounding_shift),
                sum_low + (error + (time * rate_low_ + start_low_))};
    }

 private:
    QuarterTurnPair at_distant(double time) const;
    static std::array<unsigned, 2> quarters(Pair shifted) {
        return {low_bits(shifted[0]) & 3U, low_bits(shifted[1]) & 3U};
    }

    Pair rate_{0.0, 0.0}, rate_low_{0.0, 0.0};
    Pair rate_high_{0.0, 0.0}, rate_rest_{0.0, 0.0};  // halves of the first word, for Dekker's
                                                      // product
    Pair start_{0.0, 0.0}, start_low_{0.0, 0.0};
    double far_ = 0.0;  // from this time on a phase could exceed 2^49 quarter turns
};

// The table and the coefficients for sine and cosine: (sin, cos) of n/256 of a turn, rounded, and
// the rounding errors; and the coefficients of the rest h, at most 1/128 (+ 2^−18) quarter turns,
// in
//     sin = h (s₀ + s₁h² + s₂h⁴),   cos − 1 = h² (c₀ + c₁h² + c₂h⁴),
// minimax to 2^−55.4 and 2^−61 relative. Each coefficient is stored twice, since Pairs are read
// from memory.
struct TurnTable {
    std::array<Pair, 256> rounded;
    std::array<Pair, 256> left;
    std::array<Pair, 3> sin_factors;
    std::array<Pair, 3> cos_factors;
};
extern const TurnTable turn_table;

// sin and cos − 1 of the rest, for one phase (Number = double) or for two at once (Pair).
template <class Number>
struct RestTurn {
    Number sin, cos_less_1;
    [[gnu::always_inline]] RestTurn(const Number& h, const std::array<Number, 3>& s,
                                    const std::array<Number, 3>& c) {
        const Number t = h * h;
        sin = h * s[0] + (h * t) * (s[1] + t * s[2]);
        cos_less_1 = t * c[0] + (t * t) * (c[1] + t * c[2]);
    }
};

// The sines and the cosines of two phases, with errors up to 0.6 · 2^−53.
struct SinCosPair {
    Pair sin;
    Pair cos;
};
[[gnu::always_inline]] inline SinCosPair sin_cos(const FineTurnPair& turns) {
    const RestTurn<Pair> rest(turns.rest, turn_table.sin_factors, turn_table.cos_factors);
    const auto [i, j] = turns.whole;
    const Pair sin = firsts(turn_table.rounded[i], turn_table.rounded[j]);
    const Pair cos = seconds(turn_table.rounded[i], turn_table.rounded[j]);
    Pair more_sin = sin * rest.cos_less_1 + cos * rest.sin;
    Pair more_cos = cos * rest.cos_less_1 - sin * rest.sin;
    more_sin += firsts(turn_table.left[i], turn_table.left[j]);
    more_cos += seconds(turn_table.left[i], turn_table.left[j]);
    return {sin + more_sin, cos + more_cos};
}

// (sin, cos) of one phase advanced by `turns` quarter turns. Precondition: |turns| ≤ 1.
[[gnu::always_inline]] inline Pair sin_cos(const QuarterTurns& phase, double turns = 0.0) {
    DoubleDouble rest = two_sum(phase.rest.hi, turns);
    rest.lo += phase.rest.lo;
    const double shifted = rest.hi + rounding_shift_to_64ths;
    const double h = (rest.hi - (shifted - rounding_shift_to_64ths)) + rest.lo;
    const auto& [s0, s1, s2] = turn_table.sin_factors;
    const auto& [c0, c1, c2] = turn_table.cos_factors;
    const RestTurn<double> small(h, {s0[0], s1[0], s2[0]}, {c0[0], c1[0], c2[0]});

    const unsigned i = (64 * phase.whole + low_bits(shifted)) & 255U;
    const Pair entry = turn_table.rounded[i];
    Pair more = both(small.cos_less_1) * entry + second_negated(both(small.sin)) * swapped(entry);
    more += turn_table.left[i];
    return entry + more;
}

// The table and the coefficients for powers of two: (2^(−j/128), 2^(j/128)), 1 − 2^(−j/128), and
// the coefficients of z … z⁵ in 2^(−z/128) − 1, |z| ≤ ½, minimax to 2^−56 relative.
struct PowerTable {
    std::array<Pair, 128> powers;
    std::array<double, 128> complements;
    std::array<Pair, 5> factors;
};
extern const PowerTable power_table;

// With y = y_high + y_low: powers = (2^(−y/128), factor·2^(y/128)) and complements = 1 − powers, to
// a relative error of a few 1e-16. factor_up is factor·2^512. Precondition: 0 ≤ y ≤ 128,000, and
// the second power is at most ½.
struct PowersOfHalf {
    Pair powers;
    Pair complements;
};
[[gnu::always_inline]] inline PowersOfHalf powers_of_half(double y_high, double y_low,
                                                          double factor_up) {
    const double shifted = y_high + rounding_shift;
    const double rest = (y_high - (shifted - rounding_shift)) + y_low;
    const unsigned j = low_bits(shifted) & 127U;
    const std::uint64_t halvings = low_bits(shifted) >> 7U;

    const auto& [p1, p2, p3, p4, p5] = power_table.factors;
    const Pair z = second_negated(both(rest));
    const Pair t = both(rest * rest);
    const Pair p = z * p1 + t * ((p2 + z * p3) + t * (p4 + z * p5));
    const Pair more = power_table.powers[j] * p;
    // 2^−halvings and 2^(halvings − 512).
    const double scale = std::bit_cast<double>((1023 - halvings) << 52U);
    const double scale_up = std::bit_cast<double>((511 + halvings) << 52U);
    const Pair powers = (power_table.powers[j] + more) * Pair{scale, scale_up * factor_up};
    const double complement = (1.0 - scale) + scale * (power_table.complements[j] - more[0]);
    return {powers, Pair{complement, 1.0 - powers[1]}};
}

}  // namespace poinsot
