// Which motions a panel or a plot quantity can show, and what it needs in words: the end of the
// sentence "this panel needs …".
#pragma once

#include <string_view>

#include "drawing/stage/stage_context.h"
#include "mechanics/top/heavy_top.h"

namespace poinsot {

inline bool any_motion(const StageContext&) { return true; }
inline bool keeps_momentum(const StageContext& stage) { return stage.rolling.has_value(); }
inline bool rolls(const StageContext& stage) {
    return stage.rolling.has_value() && !stage.rolling->dissipates;
}
inline bool is_heavy_top(const StageContext& stage) {
    return stage.motion.motion().heavy_top() != nullptr;
}
// Whether e3 of a heavy top stays at the upward vertical, where φ and ψ have a meaning only in
// their sum.
inline bool stays_upright(const StageContext& stage) {
    return is_heavy_top(stage) &&
           stage.motion.motion().heavy_top()->nutation().theta_max_rad == 0.0;
}

inline constexpr std::string_view needs_heavy_top = "a heavy symmetric top";
inline constexpr std::string_view needs_free_turning = "a torque-free body that turns";
inline constexpr std::string_view needs_turning =
    "a body that turns without torque; friction inside is allowed";

}  // namespace poinsot
