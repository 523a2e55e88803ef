#include "drawing/figures/charts/chart_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "drawing/figures/charts/plot_frame.h"
#include "drawing/figures/charts/plot_quantity.h"

namespace poinsot {

namespace {

// The row of a plot's quantity, as plot_quantity_of finds it; null for an unknown name, which is
// rejected later.
const PlotQuantity* quantity_of(const Scene& scene, const PanelSpec& panel) {
    const std::string_view usual = scene.start.top ? "euler_angles" : "omega";
    const std::string_view name = panel.quantity.empty() ? usual : panel.quantity;
    for (const PlotQuantity& row : plot_quantities())
        if (row.name == name) return &row;
    return nullptr;
}

}  // namespace

double rows_of_charts(const Scene& scene, const PanelSpec& panel, double px,
                      const LeastSizes& least) {
    const double type_px = std::max(px * scene.type_scale * scene.style.chart_scale.value_or(1.0),
                                    least.type_px / chart_number_size);
    std::size_t n_charts = 1;
    std::size_t n_names = 2;  // E and V of a potential
    if (panel.kind == "plot") {
        const PlotQuantity* quantity = quantity_of(scene, panel);
        if (quantity == nullptr) return 0.0;
        n_charts = quantity->stacked ? quantity->curves.size() : 1;
        n_names = quantity->stacked ? 1 : quantity->curves.size();
    } else if (panel.kind != "potential") {
        return 0.0;
    }
    // A scale needs five numbers, or three where charts are stacked. Numbers, and names at the ends
    // of curves, are a third of their height apart.
    constexpr double line = 4.0 / 3.0;
    const double n_numbers = n_charts > 1 ? 3.0 : 5.0;
    const double numbers = n_numbers * line * chart_number_size;
    const double names = static_cast<double>(n_names) * line * chart_name_size;
    // Each chart has its title above; the numbers of the time axis are below all, the panel's name
    // on top.
    const double title = chart_title_size + 24.0;
    const double foot = chart_number_size + 24.0;
    const double header = 1.7 * chart_title_size;
    const double n = static_cast<double>(n_charts);
    return (n * (std::max(numbers, names) + title) + foot + header + chart_margin) * type_px;
}

int rows_added_by_charts(const Scene& scene, int width_px, int room_px, double px,
                         const LeastSizes& least) {
    if (scene.panels.size() < 2) return 0;
    double all = 0.0;
    for (const double row : scene.grid.rows) all += row;
    double needed = 0.0;
    for (const PanelSpec& panel : scene.panels) {
        double share = 0.0;
        for (int row = panel.row; row < panel.row + panel.rows; ++row)
            share += scene.grid.rows[static_cast<std::size_t>(row)];
        needed = std::max(needed, rows_of_charts(scene, panel, px, least) * all / share);
    }
    constexpr double highest = 5.0 / 3.0;
    if (needed > highest * width_px) return 0;
    return std::max(0, static_cast<int>(std::ceil(needed)) - room_px);
}

}  // namespace poinsot
