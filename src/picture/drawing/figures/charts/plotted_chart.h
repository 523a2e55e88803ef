// A chart with its curves and their names, prepared for drawing at any instant.
#pragma once

#include <cstddef>
#include <vector>

#include "drawing/figures/charts/plot_frame.h"
#include "drawing/figures/charts/plot_quantity.h"

namespace poinsot {

// A curve of the plot, with the index of the value that its dot follows.
struct PlottedCurve {
    Curve curve;
    std::size_t value = 0;
    double end_y = 0.0;  // height of its end, in the chart's pixels
};

// A name at the right end of a curve.
struct EndName {
    TextBlock type;
    double end_y = 0.0;
    Colour colour;
};

struct PlottedChart {
    PlotFrame chart;
    std::vector<PlottedCurve> curves{};
    std::vector<Curve> comparison{};
    std::vector<Curve> measured{};  // of the measured motion, in stretches without gaps
    std::vector<Label> names{};
    std::vector<Curve> leaders{};  // from a curve's end to a name that was moved away from it
    bool begins_outside = false;   // whether its range excludes the first instants
};

// Places the names beside the ends of their curves, and moves them apart if the ends lie close.
void place_names(PlottedChart& plotted, const std::vector<EndName>& names, const Panel& panel);

// Adds the chart with a cursor at this time and a dot on every curve.
void draw_chart(const Panel& panel, const PlottedChart& plotted, double time_s,
                const PlotValues& values, ViewBuilder& builder);

}  // namespace poinsot
