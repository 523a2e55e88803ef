#include "drawing/figures/charts/flight_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "drawing/figures/charts/plot_frame.h"

namespace poinsot {

namespace {

constexpr double sheet_px = 1600.0, side_px = 40.0, numbers_px = 96.0, head_px = 92.0;
constexpr double number_size = 25.0, name_size = 29.0, title_size = 38.0;
constexpr std::array<std::string_view, 3> component_names{"$\\omega_x$", "$\\omega_y$",
                                                          "$\\omega_z$"};

// y is down.
struct SheetBox {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

struct ValueRange {
    double least = 0.0, most = 0.0;
    void take(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    // With a margin of this share.
    Axis axis(int most_ticks, double margin = 0.06) const {
        const double by = margin * (most - least);
        return linear_axis(least - by, most + by, most_ticks);
    }
};

// Values in a box: grid, numbers and title.
class SheetFrame {
 public:
    SheetFrame(const SheetBox& box, Axis x, Axis y)
        : box_(box), x_(std::move(x)), y_(std::move(y)) {}

    double across(double x) const {
        return box_.left + (box_.right - box_.left) * (x - x_.first) / (x_.last - x_.first);
    }
    double down(double y) const {
        return box_.bottom - (box_.bottom - box_.top) * (y - y_.first) / (y_.last - y_.first);
    }
    Eigen::Vector3d at(double x, double y) const { return {across(x), down(y), 0.0}; }

    void draw(ChartCanvas& canvas, bool has_x_numbers, bool has_y_numbers) const {
        const Theme& theme = canvas.theme();
        for (const Tick& tick : y_.ticks) {
            const double y = down(tick.value);
            canvas.add_line({{box_.left, y, 0.0}, {box_.right, y, 0.0}}, 0.9, theme.grid);
            if (has_y_numbers)
                canvas.add_type(fmt::format("${}$", tick.label), number_size, {box_.left - 12.0, y},
                                {1.0, 0.5}, theme.text);
        }
        for (const Tick& tick : x_.ticks) {
            const double x = across(tick.value);
            canvas.add_line({{x, box_.bottom, 0.0}, {x, box_.bottom + 7.0, 0.0}}, 1.8, theme.text);
            if (has_x_numbers)
                canvas.add_type(fmt::format("${}$", tick.label), number_size,
                                {x, box_.bottom + 13.0}, {0.5, 0.0}, theme.text);
        }
        canvas.add_line({{box_.left, box_.top, 0.0},
                         {box_.left, box_.bottom, 0.0},
                         {box_.right, box_.bottom, 0.0}},
                        1.8, theme.text);
    }

 private:
    SheetBox box_;
    Axis x_, y_;
};

int n_columns_of(std::size_t n_flights) {
    if (n_flights <= 1) return 1;
    if (n_flights <= 4) return 2;
    return n_flights <= 9 ? 3 : n_flights <= 24 ? 4 : 6;
}

bool has_ratio_charts(const FlightChart& chart) {
    const auto n = std::count_if(chart.flights.begin(), chart.flights.end(),
                                 [](const ChartedFlight& flight) { return flight.ratios; });
    return chart.ratios && n >= 2;
}

constexpr double ratios_px = 400.0, foot_px = 84.0;

// The height of a flight's charts: those of few flights are large.
double cell_px(std::size_t n_flights) {
    const int n_columns = n_columns_of(n_flights);
    return n_columns == 1 ? 860.0 : n_columns == 2 ? 560.0 : n_columns == 3 ? 440.0 : 350.0;
}

int height_of(const FlightChart& chart) {
    const std::size_t n = chart.flights.size();
    const auto n_columns = static_cast<std::size_t>(n_columns_of(n));
    const std::size_t n_rows = (n + n_columns - 1) / n_columns;
    return static_cast<int>(head_px + (has_ratio_charts(chart) ? ratios_px : 0.0) +
                            static_cast<double>(n_rows) * cell_px(n) + foot_px);
}

// Half of the range of residuals that all but one in a hundred have: a row off by far would hide
// the others.
double residual_range(const FlightChart& chart) {
    std::vector<double> sizes;
    for (const ChartedFlight& flight : chart.flights)
        for (std::size_t i = 0; i < flight.times_s.size(); ++i)
            sizes.push_back(flight.residuals[i].cwiseAbs().maxCoeff());
    const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(0.99 * double(sizes.size() - 1));
    std::nth_element(sizes.begin(), at, sizes.end());
    return std::max(1.15 * *at, 1e-12);
}

void draw_ratio(ChartCanvas& canvas, const FlightChart& chart, int which, const SheetBox& box) {
    const Colour& colour = chart_hues[which == 0 ? 0 : 1];
    ValueRange range{1e300, -1e300};
    const double together = (*chart.ratios)[which], sd = (*chart.ratios_sd)[which];
    range.take(together - sd);
    range.take(together + sd);
    for (const ChartedFlight& flight : chart.flights) {
        if (!flight.ratios || flight.is_left_out) continue;
        range.take((*flight.ratios)[which] - (*flight.ratios_sd)[which]);
        range.take((*flight.ratios)[which] + (*flight.ratios_sd)[which]);
    }
    const double n = static_cast<double>(chart.flights.size());
    Axis numbers{0.4, n + 0.6, 0, {}};
    const int stride = n > 20 ? 5 : n > 10 ? 2 : 1;
    for (int k = stride == 1 ? 1 : stride; k <= static_cast<int>(n); k += stride)
        numbers.ticks.push_back({static_cast<double>(k), std::to_string(k)});
    const Axis values = range.axis(5);
    const SheetFrame frame(box, numbers, values);
    frame.draw(canvas, true, true);
    const Theme& theme = canvas.theme();
    canvas.add_type(axis_title(fmt::format("$I_{}/I_1$", which + 2), "", values.exponent),
                    name_size, {box.left - numbers_px + 12.0, box.top - 12.0}, {0.0, 1.0}, colour);
    canvas.add_type("flight", number_size, {box.right, box.bottom + 46.0}, {1.0, 0.0}, theme.text);
    for (const double off : {-sd, 0.0, sd})
        canvas.add_line({frame.at(0.4, together + off), frame.at(n + 0.6, together + off)},
                        off == 0.0 ? 3.0 : 1.5, theme.text, off == 0.0 ? 0.0 : 7.0);
    for (std::size_t i = 0; i < chart.flights.size(); ++i) {
        const ChartedFlight& flight = chart.flights[i];
        if (!flight.ratios) continue;
        const double x = static_cast<double>(i + 1), value = (*flight.ratios)[which];
        const double by = (*flight.ratios_sd)[which];
        const double low = std::clamp(value - by, values.first, values.last);
        const double high = std::clamp(value + by, values.first, values.last);
        if (high > low) canvas.add_line({frame.at(x, low), frame.at(x, high)}, 2.5, colour);
        if (value < values.first || value > values.last) continue;
        const Eigen::Vector3d at = frame.at(x, value);
        canvas.add_dot(at.x(), at.y(), 7.0, flight.is_left_out ? theme.halo : colour, colour, 2.5);
    }
}

struct SharedAxes {
    Axis omega, residual;
    double duration_s = 0.0;
    bool is_single = false, is_small = false;
};

void draw_flight(ChartCanvas& canvas, const ChartedFlight& flight, const SharedAxes& shared,
                 const SheetBox& cell, bool has_x_numbers, bool has_y_numbers) {
    const Theme& theme = canvas.theme();
    const double origin_s = shared.is_single ? 0.0 : flight.times_s.front();
    const double first_s = flight.times_s.front() - origin_s;
    const Axis times = linear_axis(first_s, first_s + shared.duration_s, shared.is_single ? 10 : 4);
    const double height = cell.bottom - cell.top;
    const double split = cell.top + 0.68 * height;
    const double gap = shared.is_single ? 62.0 : 26.0;
    const SheetFrame above({cell.left, cell.top, cell.right, split}, times, shared.omega);
    const SheetFrame below({cell.left, split + gap, cell.right, cell.bottom}, times,
                           shared.residual);
    above.draw(canvas, false, has_y_numbers);
    below.draw(canvas, has_x_numbers, has_y_numbers);
    if (!flight.name.empty())
        canvas.add_type(flight.name, number_size, {cell.right, cell.top - 4.0}, {1.0, 1.0},
                        theme.text);
    // So many dots are still separate.
    const std::size_t most_dots = shared.is_single ? 500 : shared.is_small ? 48 : 120;
    const std::size_t stride = (flight.times_s.size() + most_dots - 1) / most_dots;
    const double dot_px = shared.is_single ? 4.6 : 3.4, rim_px = shared.is_single ? 0.8 : 0.0;
    for (int k = 0; k < 3; ++k) {
        const Colour& colour = chart_hues[static_cast<std::size_t>(k)];
        std::vector<Eigen::Vector3d> line;
        for (std::size_t i = 0; i < flight.curve.size(); ++i)
            line.push_back(above.at(flight.curve_times_s[i] - origin_s, flight.curve[i][k]));
        canvas.add_line(std::move(line), shared.is_single ? 2.6 : 2.0, colour);
        for (std::size_t i = 0; i < flight.times_s.size(); i += stride) {
            const double t = flight.times_s[i] - origin_s;
            const Eigen::Vector3d at = above.at(t, flight.measured[i][k]);
            canvas.add_dot(at.x(), at.y(), dot_px, colour, theme.halo, rim_px);
            const double off = flight.residuals[i][k];
            if (off < shared.residual.first || off > shared.residual.last) continue;
            const Eigen::Vector3d residual = below.at(t, off);
            canvas.add_dot(residual.x(), residual.y(), dot_px, colour, theme.halo, rim_px);
        }
    }
}

// The names of the components, from the right.
void draw_legend(ChartCanvas& canvas, double right, double baseline) {
    for (std::size_t k = 3; k-- > 0;) {
        right -= canvas.add_type(std::string(component_names[k]), name_size, {right, baseline},
                                 {1.0, 0.7}, chart_hues[k]) +
                 12.0;
        canvas.add_dot(right - 22.0, baseline, 4.6, chart_hues[k], canvas.theme().halo, 0.8);
        canvas.add_line({{right - 44.0, baseline, 0.0}, {right, baseline, 0.0}}, 2.6,
                        chart_hues[k]);
        right -= 76.0;
    }
}

}  // namespace

FlightSheet::FlightSheet(const FlightChart& chart, const Theme& theme, FontSource fonts)
    : canvas_(theme, std::move(fonts), static_cast<int>(sheet_px), height_of(chart), 1.0) {
    canvas_.add_type(chart.title, title_size, {side_px, 22.0}, {0.0, 0.0}, theme.text);
    double top = head_px;
    if (has_ratio_charts(chart)) {
        const double middle = 0.5 * sheet_px;
        for (const int which : {0, 1})
            draw_ratio(canvas_, chart, which,
                       {(which == 0 ? side_px : middle + 20.0) + numbers_px, top + 50.0,
                        which == 0 ? middle - 20.0 : sheet_px - side_px, top + ratios_px - 84.0});
        top += ratios_px;
    }
    const std::size_t n = chart.flights.size();
    SharedAxes shared;
    shared.is_single = n == 1;
    shared.is_small = n_columns_of(n) > 3;
    ValueRange range;
    for (const ChartedFlight& flight : chart.flights) {
        shared.duration_s =
            std::max(shared.duration_s, flight.times_s.back() - flight.times_s.front());
        for (const Eigen::Vector3d& omega : flight.measured)
            for (int k = 0; k < 3; ++k) range.take(omega[k]);
    }
    shared.omega = range.axis(shared.is_single ? 7 : 4, 0.04);
    const double off = residual_range(chart);
    const std::string& residual_unit = chart.flights.front().residual_unit;
    shared.residual = linear_axis(-off, off, shared.is_single ? 5 : 3);

    const auto n_columns = static_cast<std::size_t>(n_columns_of(n));
    const double left = side_px + numbers_px, apart = 34.0;
    const double width = (sheet_px - side_px - left + apart) / static_cast<double>(n_columns);
    const double height = cell_px(n);
    canvas_.add_type(axis_title("$\\boldsymbol\\omega$", "rad/s", shared.omega.exponent), name_size,
                     {side_px, top + (shared.is_single ? 26.0 : 12.0)}, {0.0, 0.7}, theme.text);
    // Above the numbers of the flights.
    draw_legend(canvas_, sheet_px - side_px, top + (shared.is_single ? 22.0 : 8.0));
    double bottom = top;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t row = i / n_columns, column = i % n_columns;
        const double x = left + static_cast<double>(column) * width;
        const double y = top + static_cast<double>(row) * height;
        const SheetBox cell{x, y + 56.0, x + width - apart, y + height - 14.0};
        draw_flight(canvas_, chart.flights[i], shared, cell, i + n_columns >= n, column == 0);
        bottom = std::max(bottom, cell.bottom);
        if (!shared.is_single && row > 0) continue;
        if (column == 0 && shared.is_single)
            canvas_.add_type(
                axis_title("measured $-$ fitted", residual_unit, shared.residual.exponent),
                name_size, {side_px, cell.top + 0.68 * (cell.bottom - cell.top) + 32.0}, {0.0, 0.6},
                theme.text);
    }
    canvas_.add_type(shared.is_single
                         ? "$t$ / s"
                         : axis_title("time since the first row / s; below: measured $-$ fitted",
                                      residual_unit, shared.residual.exponent),
                     name_size, {sheet_px - side_px, bottom + 48.0}, {1.0, 0.0}, theme.text);
}

}  // namespace poinsot
