#include "drawing/figures/charts/plot_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/stage/drawing_primitives.h"
#include "text/languages.h"

namespace poinsot {

namespace {

// In px at 1080 rows.
constexpr double tick_length = 7.0, number_gap = 9.0;

// If text does not fit, numbers are dropped first: names are more important.
constexpr int rank_of_numbers = rank_of_caption + 1;

// Widens an empty or infinite range to a finite one.
void widen(double& first, double& last) {
    if (!std::isfinite(first) || !std::isfinite(last)) {
        first = 0.0;
        last = 1.0;
    }
    const double middle = 0.5 * first + 0.5 * last;
    const double least = std::max(1e-12 * std::abs(middle), 1e-300);
    if (last - first < least) {
        const double half = middle != 0.0 ? 0.5 * std::abs(middle) : 1.0;
        first = middle - half;
        last = middle + half;
    }
}

// The smallest step of 1, 2 or 5 times a power of ten that is not less than a value: its digit and
// its power.
struct Step {
    int digit;
    int power;
    double size() const { return digit * std::pow(10.0, power); }
};
Step step_above(double least) {
    int power = static_cast<int>(std::floor(std::log10(least)));
    for (;; ++power) {
        for (const int digit : {1, 2, 5}) {
            const Step step{digit, power};
            if (step.size() >= least * (1.0 - 1e-9)) return step;
        }
    }
}

}  // namespace

Axis linear_axis(double first, double last, int most_ticks) {
    widen(first, last);
    Axis axis{first, last, 0, {}};
    // Two numbers do not determine a scale.
    constexpr int least_ticks = 3;
    const auto n_within = [&](double size) {
        return std::floor(last / size + 1e-9) - std::ceil(first / size - 1e-9) + 1.0;
    };
    Step step = step_above((last - first) / std::max(1, most_ticks));
    while (n_within(step.size()) < least_ticks) step = step_above(0.4 * step.size());

    // Very large or small numbers are given in units of a power of ten, unless that needs too many
    // digits.
    const double largest = std::max(std::abs(first), std::abs(last));
    const int power = static_cast<int>(std::floor(std::log10(largest)));
    if ((power >= 4 || power <= -3) && power - step.power <= 4) axis.exponent = power;
    const int n_decimals = std::max(0, axis.exponent - step.power);

    const auto k_first = std::ceil(first / step.size() - 1e-9);
    const auto k_last = std::floor(last / step.size() + 1e-9);
    for (double k = k_first; k <= k_last; ++k) {
        // The number is k·digit·10^(power − exponent), without the step's rounding error.
        const double number = k * step.digit * std::pow(10.0, step.power - axis.exponent);
        const double value = k * step.digit * std::pow(10.0, step.power);
        axis.ticks.push_back({std::clamp(value, first, last),
                              k == 0.0 ? "0" : fmt::format("{:.{}f}", number, n_decimals)});
    }
    return axis;
}

Axis time_axis(double first_s, double last_s, const TimeUnit& unit, int most_ticks) {
    Axis axis = linear_axis(first_s / unit.seconds, last_s / unit.seconds, most_ticks);
    axis.first *= unit.seconds;
    axis.last *= unit.seconds;
    for (Tick& tick : axis.ticks) tick.value *= unit.seconds;
    return axis;
}

Axis decade_axis(double first, double last, int most_ticks) {
    widen(first, last);
    Axis axis{first, last, 0, {}};
    const double step = std::max(1.0, std::ceil((last - first) / std::max(1, most_ticks)));
    for (double k = std::ceil(first / step) * step; k <= last; k += step) {
        axis.ticks.push_back({k, fmt::format("10^{{{}}}", static_cast<int>(k))});
    }
    return axis;
}

std::string axis_title(std::string_view quantity, std::string_view unit, int exponent) {
    const std::string power = exponent == 0 ? "" : fmt::format("$10^{{{}}}$", exponent);
    if (unit.empty() && power.empty()) return std::string(quantity);
    if (unit.empty()) return fmt::format("{} / {}", quantity, power);
    if (!power.empty()) return fmt::format("{} / ({} {})", quantity, power, unit);
    const bool compound = unit.find_first_of(" /") != std::string_view::npos;
    return compound ? fmt::format("{} / ({})", quantity, unit)
                    : fmt::format("{} / {}", quantity, unit);
}

void aim_at_pixels(Panel& panel) {
    Camera camera;
    camera.target = {0.5 * panel.box.width_px, 0.5 * panel.box.height_px, 0.0};
    camera.eye = camera.target + Eigen::Vector3d(0.0, 0.0, 1000.0);
    camera.up = Eigen::Vector3d::UnitY();
    camera.orthographic = true;
    // Numbers are the smallest text of a chart: names and margins are scaled with them.
    panel.type_px = std::max(panel.type_px * panel.stage->scene.style.chart_scale.value_or(1.0),
                             least_type_px(*panel.stage) / chart_number_size);
    camera.height_units = panel.box.height_px;
    aim(panel, camera);
}

TextBlock set_chart_type(const Panel& panel, StageStore& store, std::string_view text,
                         TypeMode mode, double size_px) {
    // On paper, names and titles have the size of all names.
    const StageContext& stage = *panel.stage;
    const double name_px = label_size * stage.scene.type_scale *
                           stage.scene.style.chart_scale.value_or(1.0) * paper_type_px(stage);
    const bool is_name = is_on_paper(stage) && size_px > chart_number_size;
    return store.set(text, {.size_px = is_name ? name_px : size_px * panel.type_px, .mode = mode});
}

Label chart_label(const Panel& panel, const TextBlock& type, double x, double y, Anchor anchor,
                  const Colour& colour) {
    const StageContext& stage = *panel.stage;
    const double width = type.width_px(), height = type.height_px();
    Eigen::Vector2d corner(panel.box.x_px + x, panel.box.y_px + panel.box.height_px - y);
    switch (anchor) {
        case Anchor::left_middle:
            corner.y() -= 0.5 * height;
            break;
        case Anchor::right_middle:
            corner -= Eigen::Vector2d(width, 0.5 * height);
            break;
        case Anchor::top_centre:
            corner.x() -= 0.5 * width;
            break;
        case Anchor::bottom_left:
            corner.y() -= height;
            break;
        case Anchor::bottom_right:
            corner -= Eigen::Vector2d(width, height);
            break;
    }
    Label label;
    label.mask = type.mask;
    label.top_left_px = {stage.at_whole_pixel(corner.x()), stage.at_whole_pixel(corner.y())};
    label.colour = colour;
    label.halo_colour = stage.theme.halo;
    label.halo_px = 2.0 * panel.px;
    label.rank = rank_of_charts;
    const bool right = anchor == Anchor::right_middle || anchor == Anchor::bottom_right;
    label.held_at = right ? 1.0 : anchor == Anchor::top_centre ? 0.5 : 0.0;
    return label;
}

Curve PlotFrame::line(const Panel& panel, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                      const LineStyle& colour, double width_px) {
    Curve curve = line_between(panel, a, b, colour, width_px);
    curve.occlusion = Occlusion::none;
    return curve;
}

Dot PlotFrame::dot(const Panel& panel, const Eigen::Vector3d& at, const Colour& colour,
                   double radius_px) {
    Dot mark = dot_at(panel, at, colour, radius_px);
    mark.occlusion = Occlusion::none;
    return mark;
}

namespace {

// Every n-th tick along an axis gets a number, so that numbers are `least_px` apart.
std::size_t label_stride(const Axis& axis, double height_px, double least_px) {
    if (axis.ticks.size() < 2) return 1;
    const double apart_px =
        height_px * (axis.ticks[1].value - axis.ticks[0].value) / (axis.last - axis.first);
    const double n = std::ceil(least_px / std::max(apart_px, 1e-9));
    return static_cast<std::size_t>(std::clamp(n, 1.0, static_cast<double>(axis.ticks.size())));
}

// Index of the first tick with a number, such that the tick at 0 has one.
std::size_t first_label(const Axis& axis, std::size_t stride) {
    for (std::size_t i = 0; i < axis.ticks.size(); ++i)
        if (axis.ticks[i].value == 0.0) return i % stride;
    return 0;
}

// The number of a tick, with the decimal mark of the scene's language.
TextBlock set_tick_number(const Panel& panel, StageStore& store, const Tick& tick) {
    const std::string_view mark = decimal_mark_in_formula(panel.stage->scene.language);
    return set_chart_type(panel, store, with_decimal_mark(tick.label, mark), TypeMode::math,
                          chart_number_size);
}

}  // namespace

PlotFrame::PlotFrame(const Panel& panel, StageStore& store, const PlotLayout& layout)
    : area_(layout.region), x_(layout.x), y_(layout.y) {
    const auto& [region, x, y, x_title, y_title, left_px, right_px] = layout;
    const Theme& theme = panel.stage->theme;
    const double gap = number_gap * panel.type_px;
    const double tick_px = tick_length * panel.px;
    const double number_px = chart_number_size * panel.type_px;
    const StageContext& stage = *panel.stage;

    // Space for numbers at the left, for one row of them below, and for a title above.
    area_.left += left_px;
    area_.right -= right_px;
    if (!x_title.empty()) area_.bottom += tick_px + gap + 0.75 * number_px;
    const TextBlock y_type =
        set_chart_type(panel, store, y_title, TypeMode::text, chart_title_size);
    if (y_type.mask->height > 0) area_.top -= y_type.height_px() + 1.6 * gap;
    area_.right = std::max(area_.right, area_.left + 1.0);
    area_.top = std::max(area_.top, area_.bottom + 1.0);

    // Numbers and grid lines of the values, as many as fit.
    const std::size_t stride = label_stride(y, area_.height(), 1.1 * number_px);
    const std::size_t first = first_label(y, stride);
    for (std::size_t i = first; i < y.ticks.size(); i += stride) {
        const Tick& tick = y.ticks[i];
        const double height = at(x.first, tick.value).y();
        Curve rule =
            line(panel, {area_.left, height, 0.0}, {area_.right, height, 0.0}, theme.rule, 1.0);
        rule.opacity = 0.45;
        lines_.push_back(rule);
        const TextBlock number = set_tick_number(panel, store, tick);
        labels_.push_back(
            chart_label(panel, number, area_.left - gap, height, Anchor::right_middle, theme.text));
        labels_.back().rank = rank_of_numbers;
    }
    // A long title starts further left, as far as there is space: beside another panel also a
    // little way above it.
    const double least_left = panel.box.x_px > 0 ? -0.2 * panel.box.width_px : 0.0;
    const double title_left =
        std::max(std::min(region.left, panel.box.width_px - y_type.width_px() - gap), least_left);
    labels_.push_back(chart_label(panel, y_type, title_left, area_.top + 1.3 * gap,
                                  Anchor::bottom_left, theme.text));

    // The horizontal axis, its ticks, its numbers on one line, and its title in place of the last
    // numbers.
    lines_.push_back(line(panel, {area_.left, area_.bottom, 0.0}, {area_.right, area_.bottom, 0.0},
                          theme.text, 1.6));
    const double baseline = area_.bottom - tick_px - gap - 0.7 * number_px;
    double free_from = area_.left;
    for (const Tick& tick : x.ticks) {
        const double across = at(tick.value, y.first).x();
        lines_.push_back(line(panel, {across, area_.bottom, 0.0},
                              {across, area_.bottom - tick_px, 0.0}, theme.text, 1.6));
        if (x_title.empty()) continue;
        const TextBlock type = set_tick_number(panel, store, tick);
        Label number = chart_label(panel, type, across, 0.0, Anchor::top_centre, theme.text);
        number.rank = rank_of_numbers;
        number.top_left_px.y() =
            stage.at_whole_pixel(panel.box.y_px + panel.box.height_px - baseline) -
            type.baseline_px;
        labels_.push_back(number);
        free_from = across + 0.5 * type.width_px();
    }
    if (x_title.empty()) return;
    // The title is at the right end of the row of numbers; numbers that it would cover are omitted.
    const TextBlock type = set_chart_type(panel, store, x_title, TypeMode::text, chart_title_size);
    Label title = chart_label(panel, type, region.right, 0.0, Anchor::bottom_right, theme.text);
    title.top_left_px.y() =
        stage.at_whole_pixel(panel.box.y_px + panel.box.height_px - baseline) - type.baseline_px;
    if (title.top_left_px.x() - panel.box.x_px < free_from + gap) {
        title.top_left_px.x() =
            std::min(region.right - type.width_px(), area_.right + gap) + panel.box.x_px;
        if (title.top_left_px.x() - panel.box.x_px < free_from + gap) labels_.pop_back();
    }
    labels_.push_back(title);
}

double PlotFrame::numbers_px(const Panel& panel, StageStore& store, const Axis& y) {
    double widest = 0.0;
    for (const Tick& tick : y.ticks) {
        const TextBlock type = set_tick_number(panel, store, tick);
        widest = std::max(widest, type.width_px());
    }
    return widest + number_gap * panel.type_px + tick_length * panel.px;
}

Eigen::Vector3d PlotFrame::at(double x, double y) const {
    return {area_.left + area_.width() * (x - x_.first) / (x_.last - x_.first),
            area_.bottom + area_.height() * (y - y_.first) / (y_.last - y_.first), 0.0};
}

void PlotFrame::draw(ViewBuilder& builder) const {
    builder.view.curves.insert(builder.view.curves.end(), lines_.begin(), lines_.end());
    builder.view.labels.insert(builder.view.labels.end(), labels_.begin(), labels_.end());
}

}  // namespace poinsot
