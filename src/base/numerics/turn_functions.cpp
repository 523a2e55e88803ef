#include "numerics/turn_functions.h"

#include <algorithm>

#include "error/error.h"
#include "numerics/elliptic_integrals.h"

namespace poinsot {

namespace {

// Sine and cosine of 1/256 of a turn, by their power series.
constexpr SinCosDD of_smallest_turn() {
    constexpr DoubleDouble pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
    const DoubleDouble x = pi * (1.0 / 128.0);
    SinCosDD sum;
    DoubleDouble term = 1.0;  // x^k/k!
    for (int k = 0; k <= 16; ++k) {
        DoubleDouble& part = k % 2 == 0 ? sum.cos : sum.sin;
        part = k % 4 < 2 ? part + term : part - term;
        term = term * x / (k + 1.0);
    }
    return sum;
}

// Computes each entry of the first octant from the previous one, which loses five of 106 bits in
// total; the other octants follow by symmetry.
constexpr TurnTable make_turn_table() {
    TurnTable table{};
    const auto set = [&table](unsigned n, DoubleDouble sin, DoubleDouble cos) {
        table.rounded[n % 256] = Pair{sin.hi, cos.hi};
        table.left[n % 256] = Pair{sin.lo, cos.lo};
    };
    const SinCosDD step = of_smallest_turn();
    SinCosDD z{0.0, 1.0};
    for (unsigned n = 0; n <= 32; ++n) {
        set(n, z.sin, z.cos);
        set(64 - n, z.cos, z.sin);
        set(64 + n, z.cos, -z.sin);
        set(128 - n, z.sin, -z.cos);
        set(128 + n, -z.sin, -z.cos);
        set(192 - n, -z.cos, -z.sin);
        set(192 + n, -z.cos, z.sin);
        set(256 - n, -z.sin, z.cos);
        z = {z.sin * step.cos + z.cos * step.sin, z.cos * step.cos - z.sin * step.sin};
    }
    set(0, 0.0, 1.0);
    table.sin_factors = {both(0x1.921fb54442d18p+0), both(-0x1.4abbce624643cp-1),
                         both(0x1.466b534b32bfdp-4)};
    table.cos_factors = {both(-0x1.3bd3cc9be45dep+0), both(0x1.03c1f081a4e2ep-2),
                         both(-0x1.55d3541c9225cp-6)};
    return table;
}

// 2^(±1/128) by the power series of exp.
constexpr DoubleDouble smallest_power(double sign) {
    constexpr DoubleDouble ln2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
    const DoubleDouble x = ln2 * (sign / 128.0);
    DoubleDouble sum = 1.0;
    DoubleDouble term = 1.0;  // x^k/k!
    for (int k = 1; k <= 12; ++k) {
        term = term * x / static_cast<double>(k);
        sum = sum + term;
    }
    return sum;
}

constexpr PowerTable make_power_table() {
    PowerTable table{};
    const DoubleDouble step_down = smallest_power(-1.0);
    const DoubleDouble step_up = smallest_power(1.0);
    DoubleDouble down = 1.0;
    DoubleDouble up = 1.0;
    for (std::size_t j = 0; j < 128; ++j) {
        table.powers[j] = Pair{down.hi, up.hi};
        table.complements[j] = (DoubleDouble(1.0) - down).rounded();
        down = down * step_down;
        up = up * step_up;
    }
    table.factors = {both(-0x1.62e42fefa39efp-8), both(0x1.ebfbdff82c3f9p-17),
                     both(-0x1.c6b08d704a2a2p-26), both(0x1.3b2abd4dfa444p-35),
                     both(-0x1.5d87fe76d60cbp-45)};
    return table;
}

}  // namespace

constinit const PowerTable power_table = make_power_table();
constinit const TurnTable turn_table = make_turn_table();

void PhasePair::set(int i, DoubleDouble rate, DoubleDouble start) {
    const DoubleDouble halves = split(rate.hi);
    rate_[i] = rate.hi;
    rate_low_[i] = rate.lo;
    rate_high_[i] = halves.hi;
    rate_rest_[i] = halves.lo;
    start_[i] = start.hi;
    start_low_[i] = start.lo;
    far_ = 0x1p49 / (std::abs(rate_[0]) + std::abs(rate_[1]));
}

QuarterTurnPair PhasePair::at_distant(double time) const {
    const bool far = !(std::abs(time) < 0x1p12 * far_);
    QuarterTurnPair turns;
    for (int i = 0; i < 2; ++i) {
        DoubleDouble product;
        double low = 0.0;
        if (far) {
            // Removes whole revolutions from each word; fmod is exact.
            int exponent = 0;
            product = two_product(std::frexp(time, &exponent), rate_[i]);
            const double high = std::ldexp(product.hi, exponent);
            if (!std::isfinite(high)) {
                throw InputError("omega t overflows at this time; choose a time nearer the start");
            }
            product.hi = std::fmod(high, 4.0);
            low = std::fmod(std::ldexp(product.lo, exponent), 4.0) +
                  std::fmod(time * rate_low_[i], 4.0);
        } else {
            // Up to 2^61 quarter turns, the whole part of the first word fits into an integer.
            product = two_product(time, rate_[i]);
            const auto whole = static_cast<std::int64_t>(product.hi);
            low = product.lo + time * rate_low_[i];
            product.hi = (product.hi - static_cast<double>(whole)) + static_cast<double>(whole % 4);
        }
        const DoubleDouble phase =
            two_sum(product.hi, start_[i]) + DoubleDouble(low + start_low_[i]);
        const double shifted = phase.hi + rounding_shift;
        const DoubleDouble rest = phase - (shifted - rounding_shift);
        turns.whole[static_cast<std::size_t>(i)] = low_bits(shifted) & 3U;
        turns.rest[i] = rest.hi;
        turns.rest_low[i] = rest.lo;
    }
    return turns;
}

}  // namespace poinsot
