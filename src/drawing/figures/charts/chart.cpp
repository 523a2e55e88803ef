#include "drawing/figures/charts/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "error/error.h"
#include "shapes/identity.h"

namespace poinsot {

namespace {

bool can_show(const ChartPoint& point) {
    return point.x > 0.0 && point.y > 0.0 && std::isfinite(point.x) && std::isfinite(point.y);
}

// Hues after Okabe & Ito (2008); further series repeat them with dashed lines.
constexpr std::array<Colour, 6> hues{{{0.04, 0.37, 0.65},
                                      {0.81, 0.29, 0.07},
                                      {0.00, 0.50, 0.36},
                                      {0.61, 0.17, 0.53},
                                      {0.54, 0.35, 0.00},
                                      {0.18, 0.53, 0.77}}};

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
    : theme_(&theme),
      width_px_(width_px),
      height_px_(height_px),
      px_(height_px / 1080.0),
      x_(axis_of(chart, &ChartPoint::x)),
      y_(axis_of(chart, &ChartPoint::y)),
      type_case_(std::move(fonts)) {
    x_.first_px = 150.0 * px_;
    x_.last_px = width_px - 190.0 * px_;
    y_.first_px = height_px - 130.0 * px_;
    y_.last_px = 110.0 * px_;
    add_axes(chart);
    add_series(chart);
}

void ChartSheet::add_line(std::vector<Eigen::Vector3d> points, double width_px,
                          const Colour& colour, double dash_px) {
    CurveGeometry& geometry = geometries_.emplace_back();
    geometry.id = next_identity();
    // y is down in the picture's pixels and up in the view.
    for (Eigen::Vector3d& point : points) point.y() = height_px_ - point.y();
    geometry.points = std::move(points);
    Curve curve;
    curve.geometry = &geometry;
    curve.width_px = width_px * px_;
    curve.colour = colour;
    curve.dash_px = dash_px * px_;
    curve.occlusion = Occlusion::none;
    curves_.push_back(curve);
}

void ChartSheet::add_type(const std::string& text, double size_px, double x_px, double y_px,
                          double align_x, double align_y, const Colour& colour) {
    const TextBlock type = type_case_.set(text, {.size_px = size_px * px_, .mode = TypeMode::text});
    if (type.mask->width == 0) return;
    Label label;
    label.mask = type.mask;
    label.top_left_px = {std::round(x_px - align_x * type.mask->width),
                         std::round(y_px - align_y * type.mask->height)};
    label.colour = colour;
    labels_.push_back(label);
}

void ChartSheet::add_axes(const Chart& chart) {
    const Colour& grid = theme_->grid;
    for (const double value : x_.ticks()) {
        const double x = x_.at(value);
        add_line({{x, y_.first_px, 0.0}, {x, y_.last_px, 0.0}}, 0.8, grid, 0.0);
        add_type(tick_text(x_, value), 24.0, x, y_.first_px + 14.0 * px_, 0.5, 0.0, theme_->text);
    }
    for (const double value : y_.ticks()) {
        const double y = y_.at(value);
        add_line({{x_.first_px, y, 0.0}, {x_.last_px, y, 0.0}}, 0.8, grid, 0.0);
        add_type(tick_text(y_, value), 24.0, x_.first_px - 14.0 * px_, y, 1.0, 0.5, theme_->text);
    }
    add_line({{x_.first_px, y_.last_px, 0.0},
              {x_.first_px, y_.first_px, 0.0},
              {x_.last_px, y_.first_px, 0.0}},
             1.8, theme_->text, 0.0);
    add_type(chart.title, 36.0, x_.first_px, 24.0 * px_, 0.0, 0.0, theme_->text);
    add_type(chart.y_label, 26.0, x_.first_px - 90.0 * px_, y_.last_px - 18.0 * px_, 0.0, 1.0,
             theme_->text);
    add_type(chart.x_label, 26.0, x_.last_px, y_.first_px + 62.0 * px_, 1.0, 0.0, theme_->text);
}

void ChartSheet::add_series(const Chart& chart) {
    std::size_t index = 0;
    for (const ChartSeries& series : chart.series) {
        const Colour& colour = hues[index % hues.size()];
        const double dash = index >= hues.size() ? 9.0 : 0.0;
        ++index;
        std::vector<Eigen::Vector3d> line;
        for (const ChartPoint& point : series.points) {
            if (!can_show(point)) continue;
            line.emplace_back(x_.at(point.x), y_.at(point.y), 0.0);
            // Points of the front are discs, the others rings.
            Dot dot;
            dot.at = {line.back().x(), height_px_ - line.back().y(), 0.0};
            dot.radius_px = (point.marked ? 8.0 : 6.0) * px_;
            dot.colour = point.marked ? colour : theme_->halo;
            dot.rim_colour = colour;
            dot.rim_px = 2.5 * px_;
            dot.occlusion = Occlusion::none;
            dots_.push_back(dot);
            request_name(point.name, line.back(), {-0.6, 1.0}, colour);
        }
        if (line.empty()) continue;
        // The name is beyond the line's last point, on the side where the line ends; a single point
        // has its name above it, since similar points are beside it.
        const double side = line.back().x() < line.front().x() ? -1.0 : 1.0;
        request_name(series.name, line.back(),
                     line.size() > 1 ? Eigen::Vector2d(side, 0.25) : Eigen::Vector2d(0.0, -1.0),
                     colour);
        if (line.size() > 1) add_line(std::move(line), 3.0, colour, dash);
    }
}

void ChartSheet::request_name(const std::string& name, const Eigen::Vector3d& beside,
                              const Eigen::Vector2d& away, const Colour& colour) {
    if (name.empty()) return;
    LabelRequest request;
    request.type = type_case_.set(name, {.size_px = 26.0 * px_, .mode = TypeMode::text});
    request.anchor_px = beside.head<2>();
    request.away = away;
    request.gap_px = 12.0 * px_;
    request.colour = colour;
    if (request.type.mask->width > 0) requests_.push_back(request);
}

Drawing ChartSheet::drawing() const {
    View view;
    view.width_px = width_px_;
    view.height_px = height_px_;
    view.background = theme_->background;
    view.background.top = view.background.bottom;
    view.camera.orthographic = true;
    view.camera.height_units = height_px_;
    view.camera.target = {0.5 * width_px_, 0.5 * height_px_, 0.0};
    view.camera.eye = view.camera.target + Eigen::Vector3d(0.0, 0.0, height_px_);
    view.camera.up = Eigen::Vector3d::UnitY();
    view.curves = curves_;
    view.dots = dots_;
    view.labels = labels_;
    LabelRules rules;
    rules.halo = theme_->halo;
    rules.halo_px = 3.0 * px_;
    rules.margin_px = 0.0;
    place_labels(requests_, rules, view);

    Drawing drawing;
    drawing.width_px = width_px_;
    drawing.height_px = height_px_;
    drawing.background = view.background;
    drawing.views.push_back(std::move(view));
    return drawing;
}

}  // namespace poinsot
