#include "scene/loop_text.h"

#include <array>
#include <charconv>
#include <numeric>

namespace poinsot {

namespace {

constexpr std::array<std::string_view, 3> changes{"omega_body_1", "omega_body_2", "omega_body_3"};
constexpr int most_in_ratio = 1000;

}  // namespace

std::optional<LoopRatio> loop_ratio_of(std::string_view text) {
    LoopRatio ratio;
    const char* const end = text.data() + text.size();
    const auto [slash, no_turns] = std::from_chars(text.data(), end, ratio.turns);
    if (no_turns != std::errc{}) return std::nullopt;
    if (slash != end) {
        if (*slash != '/') return std::nullopt;
        const auto [last, no_periods] = std::from_chars(slash + 1, end, ratio.periods);
        if (no_periods != std::errc{} || last != end) return std::nullopt;
    }
    if (ratio.turns < 1 || ratio.turns > most_in_ratio || ratio.periods < 1 ||
        ratio.periods > most_in_ratio) {
        return std::nullopt;
    }
    const int common = std::gcd(ratio.turns, ratio.periods);
    return LoopRatio{ratio.turns / common, ratio.periods / common};
}

std::span<const std::string_view> loop_values() { return changes; }

}  // namespace poinsot
