// A chart with its curves and their names, ready to be drawn at any instant.
#pragma once

#include <cstddef>
#include <vector>

#include "drawing/charts/plot_frame.h"
#include "drawing/charts/plot_quantity.h"

namespace poinsot {

// A curve of the plot, with the number that its dot follows.
struct PlottedCurve {
    Curve curve;
    std::size_t value = 0;
    double end_y = 0.0;  // where it ends, in the chart's pixels
};

struct PlottedChart {
    PlotFrame chart;
    std::vector<PlottedCurve> curves;
    std::vector<Curve> beside;
    std::vector<Label> names;
    std::vector<Curve> leaders;   // from a curve's end to a name that had to move away
    bool begins_outside = false;  // whether its range leaves out the first instants
};

// Sets the names beside the ends of their curves, moved apart where the ends lie close; types are
// in the order of the quantity's curves.
void place_names(PlottedChart& plotted, const std::vector<SetType>& types, const Panel& panel);

// The chart with a cursor at this time and a dot on every curve.
void draw_chart(const Panel& panel, const PlottedChart& plotted, double time_s,
                const PlotValues& values, Sheet& sheet);

}  // namespace poinsot
