// Two doubles in one SIMD register of x86-64 or AArch64: one instruction computes both. This is the
// compilers' own vector type because it also splits and joins in one instruction; Eigen's arrays go
// through memory for that, which stalls.
#pragma once

#include <bit>
#include <cstdint>

namespace poinsot {

using Pair [[gnu::vector_size(16)]] = double;

constexpr Pair both(double x) { return Pair{x, x}; }
inline Pair swapped(Pair x) { return Pair{x[1], x[0]}; }
// The pair of the first elements, and of the second elements.
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

// Pairs as complex numbers (re, im): i·x, and the product.
inline Pair times_i(Pair x) { return first_negated(swapped(x)); }
inline Pair complex_product(Pair x, Pair y) { return both(x[0]) * y + both(x[1]) * times_i(y); }
inline double squared_length(Pair x) { return x[0] * x[0] + x[1] * x[1]; }

}  // namespace poinsot
