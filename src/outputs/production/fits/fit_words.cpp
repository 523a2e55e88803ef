#include "production/fits/fit_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "measured/joint_fit.h"
#include "measured/table_faults.h"

namespace poinsot {

namespace {

// The air's torque.
void add_drag(const FittedMotion& fit, std::vector<std::string>& lines) {
    const auto& rates = fit.drag_rates;
    const auto& sd = fit.drag_rates_sd;
    if (fit.drag == DragModel::none) return;
    if (fit.drag == DragModel::linear) {
        lines.push_back(fmt::format("damping of L: {} 1/s", with_sd(rates[0], sd[0])));
        return;
    }
    if (fit.drag == DragModel::growing)
        lines.push_back(fmt::format(
            "drag growing, torque −γ e^(κt) L from the first row on: γ = {} 1/s, κ = {} 1/s",
            with_sd(rates[0], sd[0]), with_sd(rates[1], sd[1])));
    else
        lines.push_back(
            fmt::format("drag {}, torques −γ_i I_i {}: γ = {}, {}, {} {}", name_of(fit.drag),
                        fit.drag == DragModel::axes ? "ω_i" : "|ω_i| ω_i", with_sd(rates[0], sd[0]),
                        with_sd(rates[1], sd[1]), with_sd(rates[2], sd[2]),
                        fit.drag == DragModel::axes ? "1/s" : "1/rad"));
    lines.push_back(fmt::format("linear drag, −γL, would leave a residual of {:.3g} {}",
                                fit.linear_residual, fit.unit()));
}

}  // namespace

std::string with_sd(double value, double sd) {
    if (!(sd > 1e-15) || !(std::abs(value) < 1e9))
        return fmt::format("{:.15g} ± {:.2g}", value, sd);
    const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(sd))), 0, 15);
    return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, sd, decimals);
}

void add_fit(JsonObject& answer, const FittedMotion& fit) {
    const auto list = [](const Eigen::Vector3d& v) { return json_numbers(v[0], v[1], v[2]); };
    answer.add("rows", fit.n_rows).add("first_time_s", fit.first_time_s);
    answer.json("moments", list(fit.moments)).json("moments_sd", list(fit.moments_sd));
    answer.json("axes", json_of(fit.instrument_from_principal));
    answer.json("axes_sd_rad", list(fit.axes_sd_rad));
    answer.json("omega_rad_s", list(fit.omega_rad_s))
        .json("omega_sd_rad_s", list(fit.omega_sd_rad_s));
    if (fit.I1_kg_m2) answer.add("I1_kg_m2", *fit.I1_kg_m2);
    answer.add("drag", std::string(name_of(fit.drag)));
    answer.json("drag_rates", list(fit.drag_rates)).json("drag_rates_sd", list(fit.drag_rates_sd));
    if (fit.drag == DragModel::linear)
        answer.add("damping_1_s", fit.drag_rates[0]).add("damping_sd_1_s", fit.drag_rates_sd[0]);
    if (fit.attitude) {
        const Eigen::Quaterniond& q = *fit.attitude;
        answer.json("attitude", json_numbers(q.w(), q.x(), q.y(), q.z()))
            .json("attitude_sd_rad", list(fit.attitude_sd_rad));
    }
    add_residual(answer, fit);
    answer.add(fit.attitude ? "noise_rad" : "noise_rad_s", fit.noise);
    answer.add("residual_correlation", fit.correlation);
}

std::string json_of(const Eigen::Matrix3d& matrix) {
    std::vector<std::string> rows;
    rows.reserve(3);
    for (int i = 0; i < 3; ++i)
        rows.push_back(json_numbers(matrix(i, 0), matrix(i, 1), matrix(i, 2)));
    return json_list(rows);
}

void add_residual(JsonObject& answer, const FittedMotion& fit) {
    answer.add(fit.attitude ? "residual_rad" : "residual_rad_s", fit.residual);
}

template <typename Fit>
std::vector<std::string> body_lines(const Fit& fit, std::string_view before) {
    const auto& m = fit.moments;
    std::vector<std::string> lines{
        fit.I1_kg_m2
            ? fmt::format("moments {:.9g}, {:.9g}, {:.9g} kg m², as given", *fit.I1_kg_m2,
                          *fit.I1_kg_m2 * m[1], *fit.I1_kg_m2 * m[2])
            : fmt::format("{}I2/I1 = {}, I3/I1 = {} (standard deviations)", before,
                          with_sd(m[1], fit.moments_sd[1]), with_sd(m[2], fit.moments_sd[2]))};
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d e = fit.instrument_from_principal.col(k);
        lines.push_back(fmt::format("e{} = ({:.4f}, {:.4f}, {:.4f}) in the instrument's axes",
                                    k + 1, e[0], e[1], e[2]));
    }
    lines.push_back(fmt::format("axes uncertain by {:.2g}, {:.2g}, {:.2g} rad about e1, e2, e3",
                                fit.axes_sd_rad[0], fit.axes_sd_rad[1], fit.axes_sd_rad[2]));
    // ω alone cannot tell: Euler's equations also have a solution for the mirrored rows.
    if (!fit.I1_kg_m2)
        lines.emplace_back(
            "the instrument's axes x, y, z are taken as right-handed; of left-handed ones, the "
            "same "
            "rows give another body");
    return lines;
}
template std::vector<std::string> body_lines(const FittedMotion& fit, std::string_view before);
template std::vector<std::string> body_lines(const JointFit& fit, std::string_view before);

std::vector<std::string> notes_of(const FittedMotion& fit, const MeasuredMotion& measured) {
    const auto& m = fit.moments;
    std::vector<std::string> notes;
    constexpr double least_sds = 3.0;
    if (excess_of(fit) > least_sds * std::hypot(fit.moments_sd[1], fit.moments_sd[2]))
        notes.push_back(
            fmt::format("I1 > I2 + I3 by {:.2g}, which no rigid body has: check the units, the "
                        "axes and the time span of the table",
                        excess_of(fit)));
    if (1.0 - m[1] <= least_sds * fit.moments_sd[1])
        notes.emplace_back("I1 = I2 within the uncertainty, so that e1 and e2 are arbitrary");
    if (m[1] - m[2] <= least_sds * std::hypot(fit.moments_sd[1], fit.moments_sd[2]))
        notes.emplace_back("I2 = I3 within the uncertainty, so that e2 and e3 are arbitrary");
    if (fit.residual > least_sds * fit.noise)
        notes.push_back(fmt::format(
            "the residual is larger than the noise of the rows, {:.2g} {}: the body was not quite "
            "free; residuals are alike from row to row (correlation {:.2f}), which the standard "
            "deviations allow for",
            fit.noise, fit.unit(), fit.correlation));
    if (fit.attitude) notes.emplace_back("the table has no ω, so that its attitudes are fitted");
    if (std::string gaps = in_words(gaps_of(measured.rows)); !gaps.empty())
        notes.push_back(std::move(gaps));
    for (const Saturation& saturation : saturations_of(measured.rows))
        notes.push_back(in_words(saturation));
    if (std::string doubt = unit_doubt_of(measured.rows); !doubt.empty())
        notes.push_back(std::move(doubt));
    return notes;
}

std::vector<std::string> result_lines(const FittedMotion& fit) {
    std::vector<std::string> lines = body_lines(fit);
    lines.push_back(fmt::format("ω at {:g} s = ({}, {}, {}) rad/s", fit.first_time_s,
                                with_sd(fit.omega_rad_s[0], fit.omega_sd_rad_s[0]),
                                with_sd(fit.omega_rad_s[1], fit.omega_sd_rad_s[1]),
                                with_sd(fit.omega_rad_s[2], fit.omega_sd_rad_s[2])));
    add_drag(fit, lines);
    lines.push_back(fmt::format("{} rows, residual {:.3g} {} a component", fit.n_rows, fit.residual,
                                fit.unit()));
    return lines;
}

}  // namespace poinsot
