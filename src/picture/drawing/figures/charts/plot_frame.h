// Charts in a panel: axes with round tick values, and the mapping from values to positions. A
// chart's view is orthographic with one unit per pixel, x right, y up, and the origin in the
// panel's lower left corner.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/stage/panel.h"
#include "drawing/stage/type/time_unit.h"
#include "text/languages.h"

namespace poinsot {

struct Tick {
    double value = 0.0;
    std::string label;  // a formula
};

// The range of values along one side of a chart.
struct Axis {
    double first = 0.0, last = 1.0;
    int exponent = 0;  // tick labels are in units of 10^exponent
    std::vector<Tick> ticks;
};

// Ticks at multiples of 1, 2 or 5 times a power of ten within [first, last]: at least three, at
// most `most_ticks` + 1. An empty or infinite range is widened about its middle.
Axis linear_axis(double first, double last, int most_ticks);

// An axis of seconds, with ticks at round numbers of a unit and labels in that unit.
Axis time_axis(double first_s, double last_s, const TimeUnit& unit, int most_ticks);

// For values that are logarithms to base 10: ticks at whole powers.
Axis decade_axis(double first, double last, int most_ticks);

// "$\omega$ / (rad/s)", with the axis's power of ten: "$\omega$ / ($10^{-8}$ rad/s)". A quantity
// without a unit gets only the power.
std::string axis_title(std::string_view quantity, std::string_view unit, int exponent);

// A rectangle of the panel in its own pixels, y up.
struct ChartArea {
    double left = 0.0, bottom = 0.0, right = 0.0, top = 0.0;
    double width() const { return right - left; }
    double height() const { return top - bottom; }
};

// The point of a chart label's box that lies at the given position.
enum class Anchor { left_middle, right_middle, top_centre, bottom_left, bottom_right };

struct PlotLayout {
    ChartArea region;  // of the panel
    Axis x, y;
    std::string x_title;  // empty: the numbers below the axis are omitted, too
    std::string y_title;
    double left_px = 0.0;   // width for the numbers of y, see PlotFrame::numbers_px
    double right_px = 0.0;  // width for names at the ends of curves
};

// The frame of a chart in a panel, and the panel's camera for it.
class PlotFrame {
 public:
    // Lays the axes out; the area that remains after numbers and titles is the chart's.
    PlotFrame(const Panel& panel, StageStore& store, const PlotLayout& layout);

    // Width of the numbers of an axis at the left of a frame.
    static double numbers_px(const Panel& panel, StageStore& store, const Axis& y);

    const ChartArea& area() const { return area_; }
    const Axis& x() const { return x_; }
    const Axis& y() const { return y_; }

    // The position of a value, in the view's axes.
    Eigen::Vector3d at(double x, double y) const;

    // Axes, grid and titles.
    void draw(ViewBuilder& builder) const;

    // A line across the view that is never hidden.
    static Curve line(const Panel& panel, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                      const LineStyle& colour, double width_px);
    // A dot that is never hidden.
    static Dot dot(const Panel& panel, const Eigen::Vector3d& at, const Colour& colour,
                   double radius_px);

 private:
    ChartArea area_;
    Axis x_, y_;
    std::vector<Curve> lines_;
    std::vector<Label> labels_;
};

// Aims the panel's camera so that one unit of the view is one pixel.
void aim_at_pixels(Panel& panel);

// Sets text for a chart: numbers are smaller than names.
TextBlock set_chart_type(const Panel& panel, StageStore& store, std::string_view text,
                         TypeMode mode, double size_px);

// Text at a point of the chart's view.
Label chart_label(const Panel& panel, const TextBlock& type, double x, double y, Anchor anchor,
                  const Colour& colour);

constexpr double chart_margin = 40.0;       // px at the sides, half of it above and below
constexpr double chart_number_size = 23.0;  // px per em at 1080 rows
constexpr double chart_title_size = 26.0;
constexpr double chart_name_size = 31.0;

// The title of an axis of energies.
constexpr Phrase energy_title{"energy", "Energie", "énergie", "energía", "energia", "エネルギー"};

}  // namespace poinsot
