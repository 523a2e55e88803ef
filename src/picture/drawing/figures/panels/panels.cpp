#include "drawing/figures/panels/panels.h"

namespace poinsot {

std::span<const PanelKind> panel_kinds() { return panel_rows; }

std::string_view default_panel(const Scene& scene, bool is_heavy_top) {
    if (!scene.construction.sweep.empty()) return "sweep";
    if (is_heavy_top) return "top";
    return rolls(scene.torque) ? "space" : "object";
}

}  // namespace poinsot
