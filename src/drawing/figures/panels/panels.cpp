#include "drawing/figures/panels/panels.h"

#include <variant>

namespace poinsot {

std::span<const PanelKind> panel_kinds() { return panel_rows; }

std::string_view default_panel(const Scene& scene, bool is_heavy_top) {
    if (!scene.construction.sweep.empty()) return "sweep";
    if (is_heavy_top) return "top";
    const bool keeps_L = std::holds_alternative<NoTorque>(scene.torque) ||
                         std::holds_alternative<DissipationTorque>(scene.torque);
    return keeps_L ? "space" : "object";
}

}  // namespace poinsot
