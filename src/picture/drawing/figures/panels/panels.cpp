#include "drawing/figures/panels/panels.h"

#include <variant>

namespace poinsot {

std::span<const PanelKind> panel_kinds() { return panel_rows; }

std::string_view default_panel(const Scene& scene, bool is_heavy_top) {
    if (!scene.construction.sweep.empty()) return "sweep";
    if (is_heavy_top) return "top";
    const bool has_construction = std::holds_alternative<NoTorque>(scene.torque) ||
                                  std::holds_alternative<DissipationTorque>(scene.torque) ||
                                  std::holds_alternative<DragTorque>(scene.torque);
    return has_construction ? "space" : "object";
}

}  // namespace poinsot
