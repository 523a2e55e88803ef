// Which motions a panel or a plot quantity can show, and what it needs in words: the end of the
// sentence "this panel needs …".
#pragma once

#include <string_view>

#include "drawing/stage/stage_context.h"

namespace poinsot {

inline bool any_motion(const StageContext&) { return true; }
inline bool keeps_momentum(const StageContext& stage) { return stage.rolling.has_value(); }
inline bool rolls(const StageContext& stage) {
    return stage.rolling.has_value() && !stage.rolling->dissipates;
}
inline bool is_heavy_top(const StageContext& stage) {
    return stage.motion.motion().heavy_top() != nullptr;
}

inline constexpr std::string_view needs_heavy_top = "a heavy symmetric top";
inline constexpr std::string_view needs_free_turning = "a torque-free body that turns";
inline constexpr std::string_view needs_turning =
    "a body that turns without torque; friction inside is allowed";

}  // namespace poinsot
