// Frame rates as exact ratios.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace poinsot {

// Numerator and denominator without common factor.
using RateRatio = std::pair<std::int64_t, std::int64_t>;

// Returns the ratio that a decimal stands for: 29.97 → 30000/1001, and so on for the broadcasting
// rates, otherwise the decimal itself to three places. None if that fails or the rate is not in
// [0.001, 1000].
std::optional<RateRatio> rate_of_decimal(double frames_per_s);

// Returns the rate of "30", "29.97" or "30000/1001". None for other texts or a rate outside [0.001,
// 1000].
std::optional<RateRatio> rate_of_text(std::string_view text);

// "30" or "30000/1001".
std::string text_of_rate(const RateRatio& rate);

}  // namespace poinsot
