// A work-precision chart on logarithmic axes, drawn by the same renderer as the scenes.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "drawing/stage/type/labels.h"
#include "drawing/style/theme.h"
#include "shapes/views.h"

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

    Drawing drawing() const;

 private:
    struct Axis {
        double first_decade = 0.0, last_decade = 1.0;
        double first_px = 0.0, last_px = 1.0;
        double at(double value) const;
        bool is_narrow() const { return last_decade - first_decade < 1.99; }
        // The values at which grid lines are drawn.
        std::vector<double> ticks() const;
    };

    void add_line(std::vector<Eigen::Vector3d> points, double width_px, const Colour& colour,
                  double dash_px);
    void add_type(const std::string& text, double size_px, double x_px, double y_px, double align_x,
                  double align_y, const Colour& colour);
    void add_axes(const Chart& chart);
    void add_series(const Chart& chart);
    static Axis axis_of(const Chart& chart, double ChartPoint::*coordinate);
    static std::string tick_text(const Axis& axis, double value);
    void request_name(const std::string& name, const Eigen::Vector3d& beside,
                      const Eigen::Vector2d& away, const Colour& colour);

    const Theme* theme_;
    int width_px_, height_px_;
    double px_;
    Axis x_, y_;
    TextCache type_case_;
    std::deque<CurveGeometry> geometries_;
    std::vector<Curve> curves_;
    std::vector<Dot> dots_;
    std::vector<Label> labels_;
    std::vector<LabelRequest> requests_;
};

}  // namespace poinsot
