// The plot panel: quantities of the motion against time over the whole film, with a cursor at the
// instant shown.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "construction/adaptive_curve.h"
#include "drawing/figures/charts/plot_quantity.h"
#include "drawing/figures/charts/plot_record.h"
#include "drawing/figures/charts/plotted_chart.h"
#include "drawing/figures/elements/ghost.h"
#include "drawing/stage/drawing_primitives.h"
#include "drawing/stage/possible_motions.h"
#include "drawing/stage/type/scene_symbols.h"
#include "measured/table_faults.h"
#include "text/languages.h"

namespace poinsot {

namespace {

constexpr Phrase thin_lines_note{"thin lines",   "dünne Linien",  "traits fins",
                                 "líneas finas", "linee sottili", "細線"};
constexpr Phrase begins_outside_note{"begins outside",         "beginnt außerhalb",
                                     "commence hors du cadre", "empieza fuera",
                                     "inizia fuori",           "始めは枠外"};

constexpr Phrase measured_word{"measured", "gemessen", "mesuré", "medido", "misurato", "測定値"};

constexpr double curve_width = 3.4;

// Lines of the comparison motion are thinner.
constexpr double beside_width = 2.2;
constexpr double beside_opacity = 0.9;

// The measured motion is drawn over the exact one. More rows than this are closer than pixels.
constexpr double measured_width = 2.2;
constexpr std::size_t most_measured_points = 4000;

// The range of an axis: the values with a margin.
Axis axis_for(const PlotQuantity& quantity, std::pair<double, double> range, int most_ticks) {
    auto [least, most] = range;
    if (quantity.decades)
        // If all values are rounding noise, the axis still shows their magnitude.
        return decade_axis(std::floor(least), std::max(most + 0.5, std::floor(least) + 4.0),
                           most_ticks);
    if (quantity.from_zero) {
        least = std::min(least, 0.0);
        most = std::max(most, 0.0);
    }
    const double margin = 0.06 * (most - least);
    return linear_axis(least < 0.0 || !quantity.from_zero ? least - margin : least,
                       most > 0.0 || !quantity.from_zero ? most + margin : most, most_ticks);
}

double dash_of(DashPattern style, const Panel& panel) {
    switch (style) {
        case DashPattern::dashed:
            return 13.0 * panel.px;
        case DashPattern::dotted:
            return 1.15 * curve_width * panel.px;
        default:
            return 0.0;
    }
}

// Removes the part of a curve before it enters its chart for the last time; the rest begins at the
// edge.
void cut_beginning(std::vector<CurveSample>& samples, const ChartArea& area) {
    const auto last_outside =
        std::find_if(samples.rbegin(), samples.rend(), [&area](const CurveSample& sample) {
            return !(sample.point.y() >= area.bottom && sample.point.y() <= area.top);
        });
    if (last_outside == samples.rend() || last_outside == samples.rbegin()) return;
    const auto before = last_outside.base() - 1;
    const Eigen::Vector3d& inside = (before + 1)->point;
    const double edge = before->point.y() < area.bottom ? area.bottom : area.top;
    const double share = (edge - before->point.y()) / (inside.y() - before->point.y());
    before->point += share * (inside - before->point);
    samples.erase(samples.begin(), before);
}

class PlotMaker {
 public:
    PlotMaker(Panel& panel, StageStore& store, const PlotQuantity& quantity)
        : panel_(&panel),
          store_(&store),
          quantity_(&quantity),
          record_(*panel.stage, panel.stage->motion, quantity) {
        // The angles of a stepped motion are not continuous and cannot be drawn as a curve.
        const StageContext& stage = *panel.stage;
        if (stage.comparison && !quantity.needs.euler_angles) {
            comparison_.emplace(stage, *stage.comparison, quantity);
            panel.shows_comparison = true;
        }
    }

    std::vector<PlottedChart> make() {
        const StageContext& stage = *panel_->stage;
        const double first = stage.film_first_s;
        const double last = stage.film_last_s;
        n_pieces_ = n_pieces_of(stage, panel_->box.width_px);
        // A first pass for the ranges, dense enough for a small error of the extremes.
        constexpr int per_piece = 4;
        for (int k = 0; k <= per_piece * n_pieces_; ++k) {
            const double time_s = first + (last - first) * k / (per_piece * n_pieces_);
            record_.at(time_s);
            if (comparison_) comparison_->at(time_s);
        }
        if (has_measured(stage) && quantity_->of_measured) read_measured_values();
        set_names();

        // Stacked charts have the same width of numbers.
        const std::size_t n_curves = quantity_->curves.size();
        const std::size_t n_charts = quantity_->stacked ? n_curves : 1;
        double left_px = 0.0;
        std::vector<Place> places;
        for (std::size_t i = 0; i < n_charts; ++i) {
            places.push_back(place_of(i, n_charts));
            left_px = std::max(left_px, PlotFrame::numbers_px(*panel_, *store_, places.back().y));
        }
        std::vector<PlottedChart> charts;
        charts.reserve(places.size());
        for (const Place& place : places) charts.push_back(chart_of(place, left_px));
        return charts;
    }

 private:
    // With the scene's own symbols and the words of the scene's language.
    std::string named_label(const Phrase& label) const {
        const Scene& scene = panel_->stage->scene;
        return named_by_scene(scene, phrase_in(scene.language, label));
    }
    std::string named_title(const Phrase& title) const {
        const Scene& scene = panel_->stage->scene;
        return title_named_by_scene(scene, phrase_in(scene.language, title));
    }

    // The same quantity of the rows of the measured motion.
    void read_measured_values() {
        const StageContext& stage = *panel_->stage;
        const std::vector<MeasuredRow>& rows = stage.scene.measured.motion.rows;
        const auto stretches = stretches_of(rows, stage.film_first_s, stage.film_last_s);
        std::size_t n_rows = 0;
        for (const auto& stretch : stretches) n_rows += stretch.size();
        const std::size_t every = (n_rows + most_measured_points - 1) / most_measured_points;
        for (const auto& stretch : stretches) {
            std::vector<std::pair<double, PlotValues>>& values = measured_.emplace_back();
            for (std::size_t i = 0; i < stretch.size(); ++i) {
                // Also the last, so that no stretch vanishes.
                if (i % every != 0 && i + 1 < stretch.size()) continue;
                FrameInput instant;
                instant.time_s = stretch[i].time_s;
                instant.state = stage.measured_state(stretch[i]);
                values.emplace_back(instant.time_s, shown_values(stage, *quantity_, instant));
            }
        }
    }

    // The word of a name that is one word in \mathrm{}; else empty.
    static std::string word_of(std::string_view name) {
        constexpr std::string_view begin = "\\mathrm{";
        if (!name.starts_with(begin) || !name.ends_with('}')) return "";
        const std::string_view word = name.substr(begin.size(), name.size() - begin.size() - 1);
        return word.find_first_of("\\{}_^$") == std::string_view::npos ? std::string(word) : "";
    }

    void set_names() {
        const auto set = [this](const std::string& name) {
            // A word is set in the letters of the titles.
            const std::string word = word_of(name);
            const TextBlock type =
                word.empty()
                    ? set_chart_type(*panel_, *store_, name, TypeMode::math, chart_name_size)
                    : set_chart_type(*panel_, *store_, word, TypeMode::text, chart_title_size);
            widest_name_ = std::max(widest_name_, type.width_px());
            return type;
        };
        for (const PlotCurve& curve : quantity_->curves) {
            const std::string name = named_label(curve.label);
            names_.push_back(set(name));
            // Residuals of both motions have the same name: the title says which lines are which.
            if (comparison_ && !quantity_->decades)
                names_beside_.push_back(set(fmt::format("{{{}}}_{{\\mathrm{{{}}}}}", name,
                                                        comparison_name(*panel_->stage))));
        }
    }

    // The region and the content of one of the charts.
    struct Place {
        ChartArea region;
        Axis y;
        std::size_t first_curve = 0, last_curve = 0;
        bool is_lowest = true;
        bool begins_outside = false;
    };

    int n_ticks(double px, double apart_px) const {
        return std::clamp(static_cast<int>(px / (apart_px * panel_->type_px)), 2, 10);
    }

    Place place_of(std::size_t i, std::size_t n_charts) const {
        Place place;
        place.first_curve = quantity_->stacked ? i : 0;
        place.last_curve = quantity_->stacked ? i : quantity_->curves.size() - 1;
        place.is_lowest = i + 1 == n_charts;

        // Charts have equal heights; the lowest also has the numbers of the time axis.
        const double margin = chart_margin * panel_->px;
        const double foot = (chart_number_size + 24.0) * panel_->type_px;
        const double top = panel_->box.height_px - 0.5 * margin - panel_->header_px;
        const double share = (top - 0.5 * margin - foot) / static_cast<double>(n_charts);
        place.region = {margin, 0.5 * margin, panel_->box.width_px - margin,
                        top - share * static_cast<double>(i)};
        if (!place.is_lowest) place.region.bottom = place.region.top - share + 14.0 * panel_->px;
        set_range(place, n_charts);
        return place;
    }

    // Sets the range of a chart; without the first instants if they would widen it too much.
    void set_range(Place& place, std::size_t n_charts) const {
        const StageContext& stage = *panel_->stage;
        constexpr double first_share = 0.01;
        double from_s = stage.film_first_s + first_share * (stage.film_last_s - stage.film_first_s);
        const auto range_of = [&place](const PlotRecord& record, double since_s) {
            return record.range(place.first_curve, place.last_curve, since_s);
        };
        place.begins_outside =
            is_ruined(*quantity_, range_of(record_, stage.film_first_s), range_of(record_, from_s));
        if (!place.begins_outside) from_s = stage.film_first_s;
        std::pair<double, double> range = range_of(record_, from_s);
        if (comparison_) range = common_range(*quantity_, range, range_of(*comparison_, from_s));
        for (const auto& stretch : measured_)
            for (const auto& [time_s, values] : stretch)
                for (std::size_t i = place.first_curve; i <= place.last_curve; ++i)
                    range = {std::min(range.first, values[i]), std::max(range.second, values[i])};
        place.y = axis_for(*quantity_, range,
                           n_ticks(place.region.height(), n_charts == 1 ? 75.0 : 60.0));
    }

    PlottedChart chart_of(const Place& place, double left_px) {
        const StageContext& stage = *panel_->stage;
        const TimeUnit unit = time_unit_of(stage.film_last_s - stage.film_first_s);
        const Axis x = time_axis(stage.film_first_s, stage.film_last_s, unit,
                                 n_ticks(place.region.width(), 120.0));
        const std::string unit_name = unit_of(stage, *quantity_).name;
        std::string y_title =
            quantity_->stacked
                ? axis_title(
                      fmt::format("${}$", named_label(quantity_->curves[place.first_curve].label)),
                      unit_name, place.y.exponent)
                : axis_title(named_title(quantity_->title), unit_name, place.y.exponent);
        std::string thin_lines = comparison_ ? comparison_name(stage) : "";
        if (!measured_.empty())
            thin_lines += fmt::format("{}{}", thin_lines.empty() ? "" : ", ",
                                      phrase_in(stage.scene.language, measured_word));
        if (!thin_lines.empty())
            y_title += fmt::format(";  {}: {}", phrase_in(stage.scene.language, thin_lines_note),
                                   thin_lines);
        if (place.begins_outside)
            y_title += fmt::format(";  {}", phrase_in(stage.scene.language, begins_outside_note));
        const std::string x_title = place.is_lowest ? axis_title("$t$", unit.name, x.exponent) : "";
        const double names_px = widest_name_ + 16.0 * panel_->px;
        PlottedChart plotted{.chart = PlotFrame(*panel_, *store_,
                                                {.region = place.region,
                                                 .x = x,
                                                 .y = place.y,
                                                 .x_title = x_title,
                                                 .y_title = y_title,
                                                 .left_px = left_px,
                                                 .right_px = names_px}),
                             .begins_outside = place.begins_outside};
        std::vector<EndName> names;
        for (std::size_t i = place.first_curve; i <= place.last_curve; ++i) {
            add_curve(plotted, i);
            add_measured(plotted, i);
            const PlottedCurve& curve = plotted.curves.back();
            names.push_back({names_[i], curve.end_y, curve.curve.colour});
            if (!comparison_) continue;
            // A curve that leaves the chart has no name.
            const std::optional<double> end_y = add_curve_beside(plotted, i);
            if (end_y && !names_beside_.empty())
                names.push_back({names_beside_[i], *end_y, curve.curve.colour});
        }
        place_names(plotted, names, *panel_);
        return plotted;
    }

    // One curve of a record over the film, in the chart's pixels.
    std::vector<CurveSample> sampled(const PlotFrame& chart, PlotRecord& record, std::size_t i) {
        const StageContext& stage = *panel_->stage;
        const auto point = [&](double t) { return chart.at(t, record.at(t)[i]); };
        if (!quantity_->decades)
            return sample_adaptively(point, {.first = stage.film_first_s,
                                             .last = stage.film_last_s,
                                             .n_pieces = n_pieces_,
                                             .tolerance = stage.curve_px,
                                             .max_points = 40'000})
                .samples;
        // Residuals are rounding noise, which cannot be sampled as a curve: one value every few
        // pixels.
        std::vector<CurveSample> values;
        constexpr double apart_px = 3.0;
        const int n = static_cast<int>(std::ceil(chart.area().width() / apart_px));
        for (int k = 0; k <= n; ++k) {
            const double time_s =
                stage.film_first_s + (stage.film_last_s - stage.film_first_s) * k / n;
            values.push_back({time_s, point(time_s), 0.0});
        }
        return values;
    }

    const CurveGeometry* keep(const std::vector<CurveSample>& samples) {
        CurveGeometry geometry;
        double off_px = 0.0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            geometry.points.push_back(samples[i].point);
            if (i > 0) off_px = std::max(off_px, samples[i].off);
        }
        return store_->keep(std::move(geometry), off_px,
                            fmt::format("the chart \"{}\"", quantity_->name));
    }

    Curve line_of(const PlotCurve& kind, double width_px) const {
        Curve curve;
        const LineStyle ink = kind.ink(panel_->stage->theme);
        curve.colour = ink;
        curve.width_px = width_px * ink.weight * panel_->px;
        curve.dash_px = dash_of(ink.line.value_or(kind.style), *panel_);
        curve.occlusion = Occlusion::none;
        curve.lasting = true;
        return curve;
    }

    void add_curve(PlottedChart& plotted, std::size_t i) {
        const PlotFrame& chart = plotted.chart;
        std::vector<CurveSample> samples = sampled(chart, record_, i);
        if (plotted.begins_outside) cut_beginning(samples, chart.area());
        PlottedCurve curve;
        curve.value = i;
        curve.curve = line_of(quantity_->curves[i], curve_width);
        curve.end_y = samples.back().point.y();
        curve.curve.geometry = keep(samples);
        plotted.curves.push_back(curve);
    }

    // Adds the same quantity of the measured motion; stretches are not joined.
    void add_measured(PlottedChart& plotted, std::size_t i) {
        const LineStyle& ink = panel_->stage->theme.measured;
        for (const auto& stretch : measured_) {
            if (stretch.size() < 2) continue;
            CurveGeometry geometry;
            for (const auto& [time_s, values] : stretch)
                geometry.points.push_back(plotted.chart.at(time_s, values[i]));
            Curve curve;
            curve.colour = ink;
            curve.width_px = measured_width * ink.weight * panel_->px;
            curve.occlusion = Occlusion::none;
            curve.lasting = true;
            curve.name.element = "measured";
            curve.geometry = store_->keep(std::move(geometry), 0.0, "the measured values");
            plotted.measured.push_back(curve);
        }
    }

    // Adds the same quantity of the comparison motion, up to where it leaves the chart; returns the
    // height of its end if it does not.
    std::optional<double> add_curve_beside(PlottedChart& plotted, std::size_t i) {
        const ChartArea& area = plotted.chart.area();
        std::vector<CurveSample> samples = sampled(plotted.chart, *comparison_, i);
        const auto inside = [&area](const CurveSample& sample) {
            const double y = sample.point.y();
            return y >= area.bottom - 1.0 && y <= area.top + 1.0;
        };
        if (plotted.begins_outside)
            samples.erase(samples.begin(), std::find_if(samples.begin(), samples.end(), inside));
        const auto outside = std::find_if_not(samples.begin(), samples.end(), inside);
        const bool leaves = outside != samples.end();
        samples.erase(outside, samples.end());
        if (samples.size() < 2) return std::nullopt;
        Curve curve = line_of(quantity_->curves[i], beside_width);
        curve.opacity = beside_opacity;
        curve.geometry = keep(samples);
        plotted.comparison.push_back(curve);
        if (leaves) return std::nullopt;
        return samples.back().point.y();
    }

    const Panel* panel_;
    StageStore* store_;
    const PlotQuantity* quantity_;
    PlotRecord record_;
    std::optional<PlotRecord> comparison_;
    std::vector<std::vector<std::pair<double, PlotValues>>> measured_;  // by time, without gaps
    int n_pieces_ = 16;
    std::vector<TextBlock> names_;
    std::vector<TextBlock> names_beside_;  // of the comparison motion
    double widest_name_ = 0.0;
};

}  // namespace

void make_plot_panel(Panel& panel, StageStore& store) {
    aim_at_pixels(panel);
    const PlotQuantity& quantity = plot_quantity_of(*panel.stage, panel.spec.quantity);
    panel.needs = quantity.needs;
    const std::vector<PlottedChart> charts = PlotMaker(panel, store, quantity).make();
    panel.draw = [&panel, &quantity, charts](const FrameInput& instant, ViewBuilder& builder) {
        const PlotValues values = shown_values(*panel.stage, quantity, instant);
        for (const PlottedChart& plotted : charts) {
            draw_chart(panel, plotted, instant.time_s, values, builder);
        }
    };
}

}  // namespace poinsot
