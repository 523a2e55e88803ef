#include "drawing/figures/panels/panels.h"

#include "error/error.h"
#include "text/nearest.h"

namespace poinsot {

std::span<const PanelKind> panel_kinds() { return panel_rows; }

const PanelKind& panel_kind_named(std::string_view name) {
    if (const PanelKind* row = find_row(panel_rows, name)) return *row;
    throw InputError(unknown("panel", name, names_of(panel_rows)));
}

std::string_view default_panel(const StageContext& stage) {
    if (sweeps(stage)) return "sweep";
    if (is_heavy_top(stage)) return "top";
    const auto& torque = stage.motion.motion().problem().torque;
    const bool keeps_L = std::holds_alternative<NoTorque>(torque) ||
                         std::holds_alternative<DissipationTorque>(torque);
    return keeps_L ? "space" : "object";
}

}  // namespace poinsot
