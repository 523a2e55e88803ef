// The values of film.loop.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace poinsot {

// "p/q": p turns of the herpolhode about L in q periods of the polhode, in lowest terms.
struct LoopRatio {
    int turns = 0;
    int periods = 1;
};

// None if the text is not a ratio of positive integers up to 1000.
std::optional<LoopRatio> loop_ratio_of(std::string_view text);

// "omega_body_1", "omega_body_2", "omega_body_3": the start values that a loop may change,
// components of start.omega_rad_s.
std::span<const std::string_view> loop_values();

}  // namespace poinsot
