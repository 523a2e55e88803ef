#include "mechanics/turn_functions.h"

#include <algorithm>

#include "error/error.h"

namespace poinsot {

void PhasePair::set(int i, DoubleDouble rate, DoubleDouble start) {
    const DoubleDouble halves = split(rate.hi);
    rate_[i] = rate.hi;
    rate_low_[i] = rate.lo;
    rate_high_[i] = halves.hi;
    rate_rest_[i] = halves.lo;
    start_[i] = start.hi;
    start_low_[i] = start.lo;
    far_ = 0x1p49 / rate_.abs().sum();
}

QuarterTurnPair PhasePair::at_distant(double time) const {
    int exponent = 0;
    const double significand = std::frexp(time, &exponent);
    QuarterTurnPair turns;
    for (int i = 0; i < 2; ++i) {
        const DoubleDouble product = two_product(significand, rate_[i]);
        const double high = std::ldexp(product.hi, exponent);
        if (!std::isfinite(high)) {
            throw InputError("omega t overflows at this time; choose a time nearer the start");
        }
        // Whole revolutions come off each word exactly.
        const double low = std::fmod(std::ldexp(product.lo, exponent), 4.0) +
                           std::fmod(time * rate_low_[i], 4.0) + start_low_[i];
        const DoubleDouble phase = two_sum(std::fmod(high, 4.0), start_[i]) + DoubleDouble(low);
        const double whole = std::nearbyint(phase.hi);
        const DoubleDouble rest = phase - whole;
        turns.whole[static_cast<std::size_t>(i)] =
            static_cast<unsigned>(static_cast<int>(whole)) & 3U;
        turns.rest[i] = rest.hi;
        turns.rest_low[i] = rest.lo;
    }
    return turns;
}

PowerOfHalf power_of_half(double y, double y_low) {
    // 2^(−j/16) and 1 − 2^(−j/16).
    static constexpr std::array<double, 16> power{
        0x1.0000000000000p+0, 0x1.ea4afa2a490dap-1, 0x1.d5818dcfba487p-1, 0x1.c199bdd85529cp-1,
        0x1.ae89f995ad3adp-1, 0x1.9c49182a3f090p-1, 0x1.8ace5422aa0dbp-1, 0x1.7a11473eb0187p-1,
        0x1.6a09e667f3bcdp-1, 0x1.5ab07dd485429p-1, 0x1.4bfdad5362a27p-1, 0x1.3dea64c123422p-1,
        0x1.306fe0a31b715p-1, 0x1.2387a6e756238p-1, 0x1.172b83c7d517bp-1, 0x1.0b5586cf9890fp-1};
    static constexpr std::array<double, 16> complement{
        0x0.0000000000000p+0, 0x1.5b505d5b6f268p-5, 0x1.53f391822dbc7p-4, 0x1.f332113d56b1fp-4,
        0x1.45d819a94b14bp-3, 0x1.8edb9f5703dc0p-3, 0x1.d4c6af7557c93p-3, 0x1.0bdd71829fcf2p-2,
        0x1.2bec333018867p-2, 0x1.4a9f0456f57adp-2, 0x1.6804a5593abb2p-2, 0x1.842b367db97bcp-2,
        0x1.9f203eb9c91d6p-2, 0x1.b8f0b23153b8fp-2, 0x1.d1a8f87055d0ap-2, 0x1.e954f260cede1p-2};

    // Only the separatrix goes this far: through the subnormal numbers to zero.
    if (y > 1000.0) [[unlikely]] {
        return {y > 1100.0 ? 0.0 : 0x1p-600 * power_of_half(y - 600.0, y_low).power, 1.0};
    }
    const double shifted = 16.0 * y + rounding_shift;
    const auto n = static_cast<unsigned>(std::bit_cast<std::uint64_t>(shifted)) & 0x3fffU;
    const double z = (y - 0.0625 * (shifted - rounding_shift)) + y_low;
    // 2^−z − 1 for |z| ≤ 1/32, minimax to 2^−60 relative.
    const double z2 = z * z;
    const double p = -0x1.62e42fefa39efp-1 * z +
                     z2 * ((0x1.ebfbdff82c594p-3 + -0x1.c6b08d704a0c5p-5 * z) +
                           ((0x1.3b2ab6fb09802p-7 + -0x1.5d87fe77f4a15p-10 * z) +
                            (0x1.430a4993f002cp-13 + -0x1.ffcde873dcc9ep-17 * z) * z2) *
                               z2);
    const unsigned j = n & 15U;
    const double fraction = power[j] + power[j] * p;
    const unsigned halvings = n >> 4U;
    if (halvings == 0) return {fraction, complement[j] - power[j] * p};
    const double scale = std::bit_cast<double>((std::uint64_t{1023} - halvings) << 52U);
    const double e = fraction * scale;
    return {e, 1.0 - e};
}

}  // namespace poinsot
