#include "production/session/paper_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include "drawing/figures/charts/chart_fit.h"
#include "drawing/stage/overlay.h"
#include "drawing/stage/panel_kind.h"
#include "drawing/stage/type/type_sizes.h"

namespace poinsot {

namespace {

// The height of a stacked panel in units of its width.
constexpr double wide_share = 0.62, half_share = 0.85;

// The share of the grid's width that a panel has.
double share_of(const Scene& scene, const PanelSpec& panel) {
    const std::vector<double>& columns = scene.grid.columns;
    const double all = std::accumulate(columns.begin(), columns.end(), 0.0);
    const auto first =
        columns.begin() + std::min<std::ptrdiff_t>(panel.column, std::ssize(columns));
    const auto last = first + std::min<std::ptrdiff_t>(panel.columns, columns.end() - first);
    return std::accumulate(first, last, 0.0) / all;
}

// Whether a panel is a column of the grid beside others that share one, or one of two drawings or
// of a drawing and a chart side by side, in which a body would be smaller than half of the page.
bool needs_own_row(const Scene& scene, const PanelSpec& panel) {
    const PanelKind& kind = panel_kind_named(panel.kind);
    const bool is_drawing = kind.camera != CameraUse::none || (kind.uses & uses_azimuth) != 0;
    constexpr double enough = 0.7;
    const bool is_small = scene.panels.size() == 2 && is_drawing && share_of(scene, panel) < enough;
    const bool is_column =
        panel.rows > 1 && panel.columns < static_cast<int>(scene.grid.columns.size());
    return is_small || is_column;
}

// Whether the page is a column of text: then half of its width is enough for a panel, but a panel
// beside two others would be high and narrow.
bool wants_stack(const Scene& scene, const PrintSize& paper) {
    constexpr double most_ems = 40.0;  // 120 mm with labels of 8.5 points
    return paper.width_px < most_ems * label_size * paper.line_scale &&
           std::any_of(scene.panels.begin(), scene.panels.end(),
                       [&](const PanelSpec& panel) { return needs_own_row(scene, panel); });
}

// Gives each panel that needs it a row of its own and puts the others below in pairs, in reading
// order. Returns the height of the grid in pixels.
double stack_panels(const PrintSize& paper, Scene& scene) {
    std::vector<PanelSpec*> alone, others;
    for (PanelSpec& panel : scene.panels)
        (needs_own_row(scene, panel) ? alone : others).push_back(&panel);
    std::stable_sort(others.begin(), others.end(), [](const PanelSpec* a, const PanelSpec* b) {
        return std::pair(a->row, a->column) < std::pair(b->row, b->column);
    });
    const auto height_of = [&](const PanelSpec& panel, double share) {
        return std::max(share * paper.width_px,
                        rows_of_charts(scene, panel, paper.line_scale, paper.least));
    };
    std::vector<double> heights_px;
    const auto place = [&](PanelSpec& panel, int column, int columns) {
        panel.row = static_cast<int>(heights_px.size()) - 1;
        panel.column = column;
        panel.columns = columns;
        panel.rows = 1;
    };
    for (PanelSpec* panel : alone) {
        heights_px.push_back(height_of(*panel, wide_share));
        place(*panel, 0, 2);
    }
    for (std::size_t k = 0; k < others.size(); k += 2) {
        const bool is_alone = k + 1 == others.size();
        const double share = is_alone ? wide_share : 0.5 * half_share;
        heights_px.push_back(height_of(*others[k], share));
        if (!is_alone)
            heights_px.back() = std::max(heights_px.back(), height_of(*others[k + 1], share));
        place(*others[k], 0, is_alone ? 2 : 1);
        if (!is_alone) place(*others[k + 1], 1, 1);
    }
    scene.grid.columns = {1.0, 1.0};
    scene.grid.rows.clear();
    double all_px = 0.0;
    for (const double height_px : heights_px) {
        // Relative to the first, to a thousandth: the grid is part of the record.
        scene.grid.rows.push_back(std::round(1000.0 * height_px / heights_px[0]) / 1000.0);
        all_px += height_px;
    }
    return all_px;
}

// The width of the narrowest panel in pixels.
double narrowest_panel(const Scene& scene, const PrintSize& paper) {
    double least = 1.0;
    for (const PanelSpec& panel : scene.panels) least = std::min(least, share_of(scene, panel));
    return least * paper.width_px;
}

// Notes panels that are too narrow for their names and axes.
void note_narrow_panels(const Scene& scene, const PrintSize& paper,
                        std::vector<std::string>& notes) {
    constexpr double least_ems = 10.0;  // 30 mm with labels of 8.5 points
    const double narrowest_px = narrowest_panel(scene, paper);
    if (narrowest_px >= std::min(least_ems * label_size * paper.line_scale, 1.0 * paper.width_px))
        return;
    const double mm_per_px = 1000.0 / paper.pixels_per_metre;
    notes.push_back(fmt::format(
        "on a page {:.3g} mm wide, the narrowest panel is {:.2g} mm wide; give a larger width, or "
        "put the panels in more rows ([grid])",
        mm_per_px * paper.width_px, mm_per_px * narrowest_px));
}

}  // namespace

void lay_out_on_paper(const PrintChoices& print, const FontSource& fonts, Scene& scene,
                      std::vector<std::string>& notes) {
    const auto paper = print_size_of(print, scene.film.width_px, scene.film.height_px);
    if (!paper) return;
    scene.film.width_px = paper->width_px;
    scene.film.height_px = paper->height_px;
    if (!print.width_mm || print.height_mm) {
        note_narrow_panels(scene, *paper, notes);
        return;
    }
    // Title, caption and charts have text whose size is fixed in points.
    const double px = paper->line_scale;
    int& height_px = scene.film.height_px;
    const int overlays_px = rows_of_overlays(scene, fonts, paper->width_px, px, paper->least);
    if (wants_stack(scene, *paper)) {
        height_px = overlays_px + static_cast<int>(std::ceil(stack_panels(*paper, scene)));
        notes.push_back(fmt::format(
            "on a page {:g} mm wide, large panels have a row of their own, and the others stand in "
            "pairs; --height-mm keeps the scene's grid",
            *print.width_mm));
    } else {
        note_narrow_panels(scene, *paper, notes);
        height_px += rows_added_by_type(scene, fonts, paper->width_px, px, paper->least);
        height_px +=
            rows_added_by_charts(scene, paper->width_px, height_px - overlays_px, px, paper->least);
    }
    // The figure has three quarters of the page or more.
    constexpr int least_heights = 4;  // of the overlays
    height_px = std::max(height_px, least_heights * overlays_px);
}

}  // namespace poinsot
