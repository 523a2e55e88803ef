#include "drawing/figures/charts/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "error/error.h"

namespace poinsot {

namespace {

bool can_show(const ChartPoint& point) {
    return point.x > 0.0 && point.y > 0.0 && std::isfinite(point.x) && std::isfinite(point.y);
}

// 1, 2 and 5 times every power of ten within these decades.
std::vector<double> one_two_five(double first_decade, double last_decade) {
    std::vector<double> values;
    for (double d = first_decade; d < last_decade; d += 1.0) {
        for (const double digit : {1.0, 2.0, 5.0}) values.push_back(digit * std::pow(10.0, d));
    }
    values.push_back(std::pow(10.0, last_decade));
    return values;
}

}  // namespace

double ChartSheet::Axis::at(double value) const {
    const double part = (std::log10(value) - first_decade) / (last_decade - first_decade);
    return first_px + part * (last_px - first_px);
}

ChartSheet::Axis ChartSheet::axis_of(const Chart& chart, double ChartPoint::*coordinate) {
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const ChartSeries& series : chart.series) {
        for (const ChartPoint& point : series.points) {
            if (!can_show(point)) continue;
            least = std::min(least, point.*coordinate);
            most = std::max(most, point.*coordinate);
        }
    }
    if (!(most > 0.0)) throw InputError("the chart has no finite point to show");
    // Whole decades around all points, at least one; ranges of less than two decades begin and end
    // at 1, 2 or 5 times a power of ten.
    Axis axis;
    axis.first_decade = std::floor(std::log10(least));
    axis.last_decade = std::max(axis.first_decade + 1.0, std::ceil(std::log10(most)));
    if (axis.last_decade - axis.first_decade > 2.01) return axis;
    const std::vector<double> steps = one_two_five(axis.first_decade, axis.last_decade);
    const auto first = std::find_if(steps.rbegin(), steps.rend(),
                                    [=](double step) { return step <= 0.95 * least; });
    const auto last =
        std::find_if(steps.begin(), steps.end(), [=](double step) { return step >= 1.05 * most; });
    if (first != steps.rend()) axis.first_decade = std::log10(*first);
    if (last != steps.end()) axis.last_decade = std::log10(*last);
    return axis;
}

std::vector<double> ChartSheet::Axis::ticks() const {
    std::vector<double> values;
    if (is_narrow()) {
        for (const double value : one_two_five(std::floor(first_decade), std::ceil(last_decade))) {
            const double decade = std::log10(value);
            if (decade > first_decade - 1e-9 && decade < last_decade + 1e-9) {
                values.push_back(value);
            }
        }
        return values;
    }
    // At most nine numbers per axis.
    const double stride = std::max(1.0, std::ceil((last_decade - first_decade) / 8.0));
    for (double d = first_decade; d <= last_decade; d += stride) {
        values.push_back(std::pow(10.0, d));
    }
    return values;
}

std::string ChartSheet::tick_text(const Axis& axis, double value) {
    if (axis.is_narrow()) return fmt::format("${:g}$", value);
    return fmt::format("$10^{{{:.0f}}}$", std::log10(value));
}

ChartSheet::ChartSheet(const Chart& chart, const Theme& theme, FontSource fonts, int width_px,
                       int height_px)
    : px_(height_px / 1080.0),
      canvas_(theme, std::move(fonts), width_px, height_px, px_),
      width_px_(width_px),
      height_px_(height_px),
      x_(axis_of(chart, &ChartPoint::x)),
      y_(axis_of(chart, &ChartPoint::y)) {
    x_.first_px = 150.0 * px_;
    x_.last_px = width_px - 190.0 * px_;
    y_.first_px = height_px - 130.0 * px_;
    y_.last_px = 110.0 * px_;
    add_axes(chart);
    add_series(chart);
}

void ChartSheet::add_axes(const Chart& chart) {
    const Colour& grid = canvas_.theme().grid;
    for (const double value : x_.ticks()) {
        const double x = x_.at(value);
        canvas_.add_line({{x, y_.first_px, 0.0}, {x, y_.last_px, 0.0}}, 0.8, grid, 0.0);
        canvas_.add_type(tick_text(x_, value), 24.0, {x, y_.first_px + 14.0 * px_}, {0.5, 0.0},
                         canvas_.theme().text);
    }
    for (const double value : y_.ticks()) {
        const double y = y_.at(value);
        canvas_.add_line({{x_.first_px, y, 0.0}, {x_.last_px, y, 0.0}}, 0.8, grid, 0.0);
        canvas_.add_type(tick_text(y_, value), 24.0, {x_.first_px - 14.0 * px_, y}, {1.0, 0.5},
                         canvas_.theme().text);
    }
    canvas_.add_line({{x_.first_px, y_.last_px, 0.0},
                      {x_.first_px, y_.first_px, 0.0},
                      {x_.last_px, y_.first_px, 0.0}},
                     1.8, canvas_.theme().text, 0.0);
    canvas_.add_type(chart.title, 36.0, {x_.first_px, 24.0 * px_}, {0.0, 0.0},
                     canvas_.theme().text);
    canvas_.add_type(chart.y_label, 26.0, {x_.first_px - 90.0 * px_, y_.last_px - 18.0 * px_},
                     {0.0, 1.0}, canvas_.theme().text);
    canvas_.add_type(chart.x_label, 26.0, {x_.last_px, y_.first_px + 62.0 * px_}, {1.0, 0.0},
                     canvas_.theme().text);
}

void ChartSheet::add_series(const Chart& chart) {
    std::size_t index = 0;
    for (const ChartSeries& series : chart.series) {
        const Colour& colour = chart_hues[index % chart_hues.size()];
        const double dash = index >= chart_hues.size() ? 9.0 : 0.0;
        ++index;
        std::vector<Eigen::Vector3d> line;
        for (const ChartPoint& point : series.points) {
            if (!can_show(point)) continue;
            line.emplace_back(x_.at(point.x), y_.at(point.y), 0.0);
            // Points of the front are discs, the others rings.
            canvas_.add_dot(line.back().x(), line.back().y(), point.marked ? 8.0 : 6.0,
                            point.marked ? colour : canvas_.theme().halo, colour, 2.5);
            canvas_.request_name(point.name, line.back(), {-0.6, 1.0}, colour);
        }
        if (line.empty()) continue;
        // The name is beyond the line's last point, on the side where the line ends; a single point
        // has its name above it, since similar points are beside it.
        const double side = line.back().x() < line.front().x() ? -1.0 : 1.0;
        canvas_.request_name(
            series.name, line.back(),
            line.size() > 1 ? Eigen::Vector2d(side, 0.25) : Eigen::Vector2d(0.0, -1.0), colour);
        if (line.size() > 1) canvas_.add_line(std::move(line), 3.0, colour, dash);
    }
}

}  // namespace poinsot
