#include "drawing/figures/charts/plotted_chart.h"

#include <cmath>

#include "drawing/stage/type/spread_apart.h"

namespace poinsot {

void place_names(PlottedChart& plotted, const std::vector<EndName>& names, const Panel& panel) {
    std::vector<double> ends;
    std::vector<double> heights;
    for (const EndName& name : names) {
        ends.push_back(name.end_y);
        heights.push_back(name.type.height_px());
    }
    const ChartArea& area = plotted.chart.area();
    // The title of the axis is below the lowest name.
    const double margin = 0.3 * chart_name_size * panel.type_px;
    const std::vector<double> middles =
        spread_apart(ends, heights, 8.0 * panel.px, area.bottom + 0.5 * margin, area.top + margin);
    const double left = area.right + 12.0 * panel.px;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Colour& colour = names[i].colour;
        plotted.names.push_back(
            chart_label(panel, names[i].type, left, middles[i], Anchor::left_middle, colour));
        if (std::abs(middles[i] - ends[i]) < 0.5 * heights[i]) continue;
        plotted.leaders.push_back(
            PlotFrame::line(panel, {area.right + 1.0 * panel.px, ends[i], 0.0},
                            {left - 3.0 * panel.px, middles[i], 0.0}, colour, 1.4));
    }
}

void draw_chart(const Panel& panel, const PlottedChart& plotted, double time_s,
                const PlotValues& values, ViewBuilder& builder) {
    plotted.chart.draw(builder);
    const ChartArea& area = plotted.chart.area();
    const double across = plotted.chart.at(time_s, 0.0).x();
    Curve cursor = PlotFrame::line(panel, {across, area.bottom, 0.0}, {across, area.top, 0.0},
                                   panel.stage->theme.text, 1.6);
    cursor.opacity = 0.55;
    builder.view.curves.push_back(cursor);
    builder.view.curves.insert(builder.view.curves.end(), plotted.comparison.begin(),
                               plotted.comparison.end());
    for (const PlottedCurve& curve : plotted.curves) {
        builder.view.curves.push_back(curve.curve);
    }
    builder.view.curves.insert(builder.view.curves.end(), plotted.measured.begin(),
                               plotted.measured.end());
    builder.view.curves.insert(builder.view.curves.end(), plotted.leaders.begin(),
                               plotted.leaders.end());
    builder.view.labels.insert(builder.view.labels.end(), plotted.names.begin(),
                               plotted.names.end());
    for (const PlottedCurve& curve : plotted.curves) {
        const Eigen::Vector3d at = plotted.chart.at(time_s, values[curve.value]);
        // A curve that starts outside of the chart has a dot only inside of it.
        if (plotted.begins_outside && !(at.y() >= area.bottom && at.y() <= area.top)) continue;
        builder.view.dots.push_back(PlotFrame::dot(panel, at, curve.curve.colour, 6.5));
    }
}

}  // namespace poinsot
