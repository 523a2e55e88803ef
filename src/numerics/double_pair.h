// Two doubles side by side, as one register of every x86-64 and AArch64 holds them: one instruction
// does for both. A vector type of the compilers, for which taking apart and joining are one
// instruction, too; Eigen's arrays go through memory there, and that stalls.
#pragma once

#include <bit>
#include <cstdint>

namespace poinsot {

using Pair [[gnu::vector_size(16)]] = double;

constexpr Pair both(double x) { return Pair{x, x}; }
inline Pair swapped(Pair x) { return Pair{x[1], x[0]}; }
// The first, or the second, of each.
inline Pair firsts(Pair x, Pair y) { return Pair{x[0], y[0]}; }
inline Pair seconds(Pair x, Pair y) { return Pair{x[1], y[1]}; }

// (−x₀, x₁) and (x₀, −x₁).
using PairBits [[gnu::vector_size(16)]] = std::uint64_t;
inline constexpr std::uint64_t sign_bit = std::uint64_t{1} << 63U;
inline Pair first_negated(Pair x) {
    return std::bit_cast<Pair>(std::bit_cast<PairBits>(x) ^ PairBits{sign_bit, 0});
}
inline Pair second_negated(Pair x) {
    return std::bit_cast<Pair>(std::bit_cast<PairBits>(x) ^ PairBits{0, sign_bit});
}

// Pairs as complex numbers (re, im): the product, and i·x.
inline Pair times_i(Pair x) { return first_negated(swapped(x)); }
inline Pair complex_product(Pair x, Pair y) { return both(x[0]) * y + both(x[1]) * times_i(y); }
inline double squared_length(Pair x) { return x[0] * x[0] + x[1] * x[1]; }

}  // namespace poinsot
