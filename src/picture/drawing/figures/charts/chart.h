// A work-precision chart on logarithmic axes, drawn by the same renderer as the scenes.
#pragma once

#include <string>
#include <vector>

#include "drawing/figures/charts/chart_canvas.h"

namespace poinsot {

struct ChartPoint {
    double x = 1.0, y = 1.0;  // positive and finite; others are left out
    bool marked = false;      // on the Pareto front
    std::string name{};       // a caption at its lower left, for a front without points
};

struct ChartSeries {
    std::string name;  // set as a caption beside its last point
    std::vector<ChartPoint> points;
};

struct Chart {
    std::string title, x_label, y_label;  // captions
    std::vector<ChartSeries> series;
};

// Holds the geometry and text of a chart's drawing; drawings refer to it and must not outlive it.
class ChartSheet {
 public:
    // Throws InputError if no point can be shown.
    ChartSheet(const Chart& chart, const Theme& theme, FontSource fonts, int width_px,
               int height_px);
    ChartSheet(const ChartSheet&) = delete;
    ChartSheet& operator=(const ChartSheet&) = delete;

    Drawing drawing() const { return canvas_.drawing(); }

 private:
    struct Axis {
        double first_decade = 0.0, last_decade = 1.0;
        double first_px = 0.0, last_px = 1.0;
        double at(double value) const;
        bool is_narrow() const { return last_decade - first_decade < 1.99; }
        // The values at which grid lines are drawn.
        std::vector<double> ticks() const;
    };

    void add_axes(const Chart& chart);
    void add_series(const Chart& chart);
    static Axis axis_of(const Chart& chart, double ChartPoint::*coordinate);
    static std::string tick_text(const Axis& axis, double value);

    double px_;
    ChartCanvas canvas_;
    int width_px_, height_px_;
    Axis x_, y_;
};

}  // namespace poinsot
