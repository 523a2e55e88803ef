#include "cli/check_against.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "cli/chart_file.h"
#include "error/error.h"
#include "measured/departure.h"
#include "measured/files/measured_file.h"
#include "production/session/files/open_session.h"
#include "system/files/file_kind.h"
#include "text/json_text.h"
#include "text/label_text.h"
#include "text/numbers.h"
#include "text/printable.h"
#include "text/units.h"

namespace poinsot {

namespace {

// The first and last instant of a table, which the motion must cover.
std::vector<double> span_of(const std::string& file) {
    std::vector<double> span_s;
    read_measured(
        file, [](const MeasuredColumns&) {},
        [&span_s](const MeasuredRow& row) {
            if (span_s.empty()) span_s = {row.time_s, row.time_s};
            span_s.back() = row.time_s;
        });
    return span_s;
}

// An angle, or a distance in the picture as the angle that makes it.
double tolerance_rad(const std::string& text, const Accuracy& accuracy) {
    if (text.empty()) return accuracy.motion_rad();
    std::string_view digits = text;
    std::optional<double> angle;
    if (digits.ends_with("px")) {
        digits.remove_suffix(2);
        while (digits.ends_with(' ')) digits.remove_suffix(1);
        angle = number_of<double>(digits);
        if (angle) *angle /= accuracy.px_per_rad;
    } else {
        angle = measured_in(text, *unit_named("rad"));
    }
    if (!angle || !(*angle >= 0.0) || !std::isfinite(*angle))
        throw InputError(
            fmt::format("--tolerance {}: not a tolerance; give pixels of the picture, as \"0.5 "
                        "px\", or an angle, as "
                        "\"0.01 rad\" or \"1 deg\"",
                        printable(text)));
    return *angle;
}

std::string percent(double share) { return fmt::format("{:.3g} %", 100.0 * share); }

void print_words(const std::string& file, const Session& session, const Departure& departure,
                 double error_rad, double allowed_rad) {
    const double px_per_rad = session.accuracy.px_per_rad;
    const DepartureAt& last = departure.last();
    fmt::print("{} against {}: {} rows from {:g} to {:g} s\n", printable(file),
               printable(session.scene.name), departure.n_rows(), departure.first_time_s(),
               last.time_s);
    const auto at = [](const Peak& peak) { return fmt::format("at {:g} s", peak.time_s); };
    if (last.attitude_rad)
        fmt::print(
            "attitude: off by up to {:.3g} rad, {:.3g} px in the picture, {}; in the end {:.3g} "
            "rad\n",
            departure.attitude_rad().value, departure.attitude_rad().value * px_per_rad,
            at(departure.attitude_rad()), *last.attitude_rad);
    if (last.omega_share)
        fmt::print("ω: off by up to {} of itself {}\n", percent(departure.omega_share().value),
                   at(departure.omega_share()));
    if (last.energy_share)
        fmt::print("T, which is constant: off by up to {} {}; in the end {:+.3g} %\n",
                   percent(departure.energy_share().value), at(departure.energy_share()),
                   100.0 * *last.energy_share);
    if (last.momentum_share)
        fmt::print("|L|, which is constant: off by up to {} {}; in the end {:+.3g} %\n",
                   percent(departure.momentum_share().value), at(departure.momentum_share()),
                   100.0 * *last.momentum_share);
    if (last.momentum_tilt_rad)
        fmt::print("direction of L, which is constant: tilted by up to {:.3g} rad {}\n",
                   departure.momentum_tilt_rad().value, at(departure.momentum_tilt_rad()));
    const std::string_view outcome = error_rad <= allowed_rad ? "passes" : "fails";
    // Without attitudes, the error is a share of ω.
    if (last.attitude_rad)
        fmt::print("{}: {:.3g} rad ({:.3g} px), {:.3g} rad ({:.3g} px) allowed\n", outcome,
                   error_rad, error_rad * px_per_rad, allowed_rad, allowed_rad * px_per_rad);
    else
        fmt::print("{}: {:.3g} of |ω|, {:.3g} allowed\n", outcome, error_rad, allowed_rad);
}

void add_peak(JsonObject& answer, const std::string& name, const Peak& peak,
              const std::optional<double>& last) {
    if (!last) return;
    answer.json(
        name,
        JsonObject().add("largest", peak.value).add("at_s", peak.time_s).add("last", *last).line());
}

void print_json(const std::string& file, const Session& session, const Departure& departure,
                double error_rad, double allowed_rad) {
    const DepartureAt& last = departure.last();
    JsonObject answer;
    answer.add("file", file).add("rows", departure.n_rows());
    answer.add("first_time_s", departure.first_time_s()).add("last_time_s", last.time_s);
    add_peak(answer, "attitude_rad", departure.attitude_rad(), last.attitude_rad);
    add_peak(answer, "omega_share", departure.omega_share(), last.omega_share);
    add_peak(answer, "energy_share", departure.energy_share(), last.energy_share);
    add_peak(answer, "momentum_share", departure.momentum_share(), last.momentum_share);
    add_peak(answer, "momentum_tilt_rad", departure.momentum_tilt_rad(), last.momentum_tilt_rad);
    answer.add("error_rad", error_rad).add("error_px", error_rad * session.accuracy.px_per_rad);
    answer.add("allowed_rad", allowed_rad).add("passes", error_rad <= allowed_rad);
    fmt::print("{}", answer.lines());
}

Chart chart_of(const std::string& file, const Session& session, const Departure& departure) {
    Chart chart;
    chart.title = fmt::format(
        "{} against {}", as_caption(std::filesystem::path(file).filename().string()),
        session.scene.title.empty() ? as_caption(session.scene.name) : session.scene.title);
    chart.x_label = "time since the first row / s";
    chart.y_label = "error / rad, or a share";
    const auto add = [&](const std::string& name, std::optional<double> DepartureAt::*value) {
        // The largest of every eighth of an octave.
        ChartSeries series{name, {}};
        int place = 0;
        for (const DepartureAt& at : departure.outline()) {
            const double time_s = at.time_s - departure.first_time_s();
            if (!(at.*value) || !(time_s > 0.0) || *(at.*value) == 0.0) continue;
            const double error = std::abs(*(at.*value));
            const int here = static_cast<int>(std::floor(8.0 * std::log2(time_s)));
            if (series.points.empty() || here != place)
                series.points.push_back({time_s, error, false, ""});
            else if (error > series.points.back().y)
                series.points.back().y = error;
            place = here;
        }
        if (!series.points.empty()) chart.series.push_back(std::move(series));
    };
    add("attitude", &DepartureAt::attitude_rad);
    add("$\\boldsymbol\\omega$", &DepartureAt::omega_share);
    add("$T$", &DepartureAt::energy_share);
    add("$|\\mathbf{L}|$", &DepartureAt::momentum_share);
    add("tilt of $\\mathbf{L}$", &DepartureAt::momentum_tilt_rad);
    return chart;
}

}  // namespace

int check_against(const SceneRequest& request, const AgainstChoices& choices, const Task& task) {
    if (!choices.chart.empty() && suffix_of(choices.chart) != ".png")
        throw InputError(fmt::format("--chart {}: the chart is a PNG; end its name in .png",
                                     printable(choices.chart)));
    SceneRequest covering = request;
    covering.times_s = span_of(choices.file);
    const Session session = open_session(covering, task);
    tell_notes(session, task);
    const double allowed_rad = tolerance_rad(choices.tolerance, session.accuracy);

    Departure departure(session.motion);
    MeasuredColumns columns;
    read_measured(
        choices.file, [&columns](const MeasuredColumns& these) { columns = these; },
        [&](const MeasuredRow& row) {
            departure.add(row, columns.has_omega, columns.has_attitude);
        });
    // Without attitudes the tip of ω tells, as an angle.
    const double error_rad =
        columns.has_attitude ? departure.attitude_rad().value : departure.omega_share().value;
    if (!choices.chart.empty())
        write_chart(chart_of(choices.file, session, departure), {}, choices.chart);
    if (choices.json)
        print_json(choices.file, session, departure, error_rad, allowed_rad);
    else
        print_words(choices.file, session, departure, error_rad, allowed_rad);
    return error_rad <= allowed_rad ? 0 : 1;
}

}  // namespace poinsot
