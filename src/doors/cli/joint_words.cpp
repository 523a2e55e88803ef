#include "cli/joint_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "production/fits/fit_words.h"
#include "text/json_text.h"

namespace poinsot {

namespace {

std::string json_triple(const Eigen::Vector3d& v) { return json_numbers(v[0], v[1], v[2]); }

struct Departures {
    std::vector<double> values;
    void add(double value) { values.push_back(std::abs(value)); }
    double mean() const {
        double sum = 0.0;
        for (const double value : values) sum += value;
        return sum / static_cast<double>(values.size());
    }
    double median() const {
        std::vector<double> sorted = values;
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
    }
};

// How far the periods and flips of all flights are off.
std::vector<std::string> summary_of(const FlightPredictions& predictions) {
    Departures periods, flips;
    for (const auto& prediction : predictions) {
        if (!prediction) continue;
        if (prediction->period_s && prediction->measured_period_s)
            periods.add(prediction->period_s->value / *prediction->measured_period_s - 1.0);
        if (prediction->flip_s && prediction->measured_flip_s)
            flips.add(prediction->flip_s->value - *prediction->measured_flip_s);
    }
    std::vector<std::string> lines;
    if (!periods.values.empty())
        lines.push_back(fmt::format(
            "predicted periods are off by {:.2g} % (mean), {:.2g} % (median) in {} flights",
            100.0 * periods.mean(), 100.0 * periods.median(), periods.values.size()));
    if (!flips.values.empty())
        lines.push_back(
            fmt::format("predicted flips are off by {:.2g} s (mean), {:.2g} s (median) in {} "
                        "flights",
                        flips.mean(), flips.median(), flips.values.size()));
    return lines;
}

}  // namespace

std::string words_of(const Prediction& prediction) {
    std::string text = fmt::format(
        "{} rows predict the other {} to {:.2g} {} (root mean square of {}; largest {:.2g} {}, at "
        "{:.6g} s)",
        prediction.n_fitted, prediction.n_rest, prediction.rms,
        prediction.has_attitude ? "rad" : "rad/s",
        prediction.has_attitude ? "the angle between the attitudes" : "|Δω|", prediction.largest,
        prediction.has_attitude ? "rad" : "rad/s", prediction.largest_at_s);
    if (prediction.period_s) {
        text += fmt::format("; period {} s",
                            with_sd(prediction.period_s->value, prediction.period_s->sd));
        if (prediction.measured_period_s)
            text += fmt::format(" (all rows: {:.4g} s)", *prediction.measured_period_s);
    }
    if (prediction.flip_s) {
        text +=
            fmt::format("; flip at {} s", with_sd(prediction.flip_s->value, prediction.flip_s->sd));
        text += prediction.measured_flip_s
                    ? fmt::format(" (measured: {:.6g} s)", *prediction.measured_flip_s)
                    : " (after the last row)";
    }
    return text;
}

std::string json_of(const Prediction& prediction) {
    JsonObject made;
    const bool is_rad = prediction.has_attitude;
    made.add("rows", prediction.n_fitted)
        .add("rows_predicted", prediction.n_rest)
        .add(is_rad ? "residual_rad" : "residual_rad_s", prediction.residual)
        .add(is_rad ? "rms_rad" : "rms_rad_s", prediction.rms)
        .add(is_rad ? "largest_rad" : "largest_rad_s", prediction.largest)
        .add("largest_at_s", prediction.largest_at_s);
    if (prediction.period_s)
        made.add("period_s", prediction.period_s->value)
            .add("period_sd_s", prediction.period_s->sd);
    if (prediction.measured_period_s) made.add("measured_period_s", *prediction.measured_period_s);
    if (prediction.flip_s)
        made.add("flip_s", prediction.flip_s->value).add("flip_sd_s", prediction.flip_s->sd);
    if (prediction.measured_flip_s) made.add("measured_flip_s", *prediction.measured_flip_s);
    return made.line();
}

std::vector<std::string> words_of(const JointFit& joint,
                                  const std::vector<const TableFlight*>& flights,
                                  const FlightPredictions& predictions) {
    std::vector<std::string> lines;
    lines.push_back(fmt::format(
        "{} flights of one body, {} left out; residuals with this body, ratios of each flight "
        "alone:",
        joint.n_used, joint.flights.size() - joint.n_used));
    for (std::size_t i = 0; i < flights.size(); ++i) {
        const JointFlight& flight = joint.flights[i];
        std::string line =
            fmt::format("{}: |ω| = {:.1f} rad/s, residual {:.3g} {}", flights[i]->name,
                        flight.rate_rad_s, flight.residual, flight.attitude ? "rad" : "rad/s");
        if (flight.own && !flight.own->I1_kg_m2)
            line += fmt::format(", I2/I1 = {}, I3/I1 = {}",
                                with_sd(flight.own->moments[1], flight.own->moments_sd[1]),
                                with_sd(flight.own->moments[2], flight.own->moments_sd[2]));
        if (!flight.own) line += ", alone it does not tell the body";
        if (!flight.left_out.empty()) line += fmt::format("; left out: {}", flight.left_out);
        lines.push_back(line);
        if (i < predictions.size() && predictions[i])
            lines.push_back("  " + words_of(*predictions[i]));
    }
    for (std::string& line : body_lines(joint, "together: ")) lines.push_back(std::move(line));
    if (joint.shares_drag) {
        const auto& rates = joint.drag_rates;
        const auto& sd = joint.drag_rates_sd;
        const std::string unit = joint.drag == DragModel::quadratic ? "1/rad" : "1/s";
        lines.push_back(
            joint.drag == DragModel::linear
                ? fmt::format("drag linear, shared: γ = {} {}", with_sd(rates[0], sd[0]), unit)
            : joint.drag == DragModel::growing
                ? fmt::format("drag growing, shared: γ = {}, κ = {} 1/s", with_sd(rates[0], sd[0]),
                              with_sd(rates[1], sd[1]))
                : fmt::format("drag {}, shared: γ = {}, {}, {} {}", name_of(joint.drag),
                              with_sd(rates[0], sd[0]), with_sd(rates[1], sd[1]),
                              with_sd(rates[2], sd[2]), unit));
    } else if (joint.drag != DragModel::none) {
        lines.push_back(fmt::format("drag {}, each flight its own", name_of(joint.drag)));
    }
    std::string residuals;
    if (joint.residual_rad_s) residuals += fmt::format("{:.3g} rad/s", *joint.residual_rad_s);
    if (joint.residual_rad)
        residuals += fmt::format("{}{:.3g} rad", residuals.empty() ? "" : " and, of attitudes, ",
                                 *joint.residual_rad);
    lines.push_back(fmt::format("{} rows, residual {} a component", joint.n_rows, residuals));
    lines.push_back(fmt::format(
        "rule: a flight is left out if a ratio or an axis of its own fit lies more than {:g} "
        "deviations from the median (its standard deviation and 1.4826 times the median distance, "
        "added as squares) and the body of the most typical flight leaves more than {:g} times "
        "its residual, or if no motion of this body comes within 5 % of |ω|, or "
        "within 0.1 rad of its attitudes",
        outlier_deviations, outlier_residuals));
    for (const std::string& line : summary_of(predictions)) lines.push_back(line);
    return lines;
}

std::string json_of(const JointFit& joint, const std::vector<const TableFlight*>& flights,
                    const FlightPredictions& predictions) {
    std::vector<std::string> list;
    for (std::size_t i = 0; i < flights.size(); ++i) {
        const JointFlight& flight = joint.flights[i];
        JsonObject one;
        one.add("name", flights[i]->name)
            .add("number", flights[i]->number)
            .add("begin_s", flights[i]->measured.rows.front().time_s)
            .add("end_s", flights[i]->measured.rows.back().time_s)
            .add("rate_rad_s", flight.rate_rad_s)
            .add(flight.attitude ? "residual_rad" : "residual_rad_s", flight.residual)
            .json("omega_rad_s", json_triple(flight.omega_rad_s))
            .json("drag_rates", json_triple(flight.drag_rates));
        if (flight.own)
            one.json("moments", json_triple(flight.own->moments))
                .json("moments_sd", json_triple(flight.own->moments_sd));
        if (!flight.left_out.empty()) one.add("left_out", flight.left_out);
        if (i < predictions.size() && predictions[i])
            one.json("prediction", json_of(*predictions[i]));
        list.push_back(one.line());
    }
    JsonObject answer;
    answer.json("flights", json_lines(list, 2)).add("flights_used", joint.n_used);
    answer.add("rows", joint.n_rows);
    answer.json("moments", json_triple(joint.moments))
        .json("moments_sd", json_triple(joint.moments_sd));
    if (joint.I1_kg_m2) answer.add("I1_kg_m2", *joint.I1_kg_m2);
    answer.json("axes", json_of(joint.instrument_from_principal));
    answer.json("axes_sd_rad", json_triple(joint.axes_sd_rad));
    answer.add("drag", std::string(name_of(joint.drag))).add("shares_drag", joint.shares_drag);
    if (joint.shares_drag)
        answer.json("drag_rates", json_triple(joint.drag_rates))
            .json("drag_rates_sd", json_triple(joint.drag_rates_sd));
    if (joint.residual_rad_s) answer.add("residual_rad_s", *joint.residual_rad_s);
    if (joint.residual_rad) answer.add("residual_rad", *joint.residual_rad);
    return answer.lines();
}

}  // namespace poinsot
