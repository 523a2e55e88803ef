// Which motions a panel or a plot quantity can show, and what it needs in words: the end of the
// sentence "this panel needs …".
#pragma once

#include <numbers>
#include <string_view>

#include "drawing/stage/stage_context.h"
#include "mechanics/top/heavy_top.h"

namespace poinsot {

inline bool any_motion(const StageContext&) { return true; }
// Whether the scene names a measured motion.
inline bool has_measured(const StageContext& stage) { return stage.scene.measured.given(); }
// Whether no torque but that of the air changes L.
inline bool keeps_momentum(const StageContext& stage) { return stage.rolling.has_value(); }
inline bool rolls(const StageContext& stage) {
    return stage.rolling.has_value() && !stage.rolling->dissipates;
}
inline bool is_heavy_top(const StageContext& stage) {
    return stage.motion.motion().heavy_top() != nullptr;
}
// 1 if e3 of a heavy top stays at the upward vertical, −1 if it stays at the downward one, 0 if
// neither. While it is vertical, only φ + ψ or φ − ψ has a meaning: the angle from x to e1.
inline int vertical_axis(const StageContext& stage) {
    if (!is_heavy_top(stage)) return 0;
    const TopNutation& nutation = stage.motion.motion().heavy_top()->nutation();
    if (nutation.theta_max_rad == 0.0) return 1;
    return nutation.theta_min_rad == std::numbers::pi ? -1 : 0;
}

inline constexpr std::string_view needs_measured = "a measured motion, in [measured]";
inline constexpr std::string_view needs_heavy_top = "a heavy symmetric top";
inline constexpr std::string_view needs_free_turning = "a torque-free body that turns";
inline constexpr std::string_view needs_turning =
    "a body that turns without torque; internal friction is allowed, and drag without [beside]";

}  // namespace poinsot
