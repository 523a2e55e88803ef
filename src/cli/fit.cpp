// poinsot fit DATA.csv: the body and the motion behind a measured ω(t).
#include "measured/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>

#include "cli/command.h"
#include "cli/options.h"
#include "cli/progress_bar.h"
#include "error/error.h"
#include "measured/files/measured_file.h"
#include "measured/table_faults.h"
#include "mechanics/free/free_rotation.h"
#include "production/session/slow_work_notice.h"
#include "scene/parse_scene.h"
#include "scene/toml_text.h"
#include "system/files/atomic_file.h"
#include "system/files/file_kind.h"
#include "text/json_text.h"
#include "text/numbers.h"
#include "text/printable.h"
#include "text/utf8.h"

namespace poinsot {

namespace {

struct FitChoices {
    std::vector<std::string> files;
    std::string output;
    std::string moments, drag;
    bool json = false;
};

// "4,3,1.5".
Eigen::Vector3d moments_in(const std::string& text) {
    std::vector<double> moments;
    for (std::string_view rest = text;;) {
        const std::size_t comma = rest.find(',');
        moments.push_back(number_of<double>(rest.substr(0, comma)).value_or(0.0));
        if (comma == std::string_view::npos) break;
        rest.remove_prefix(comma + 1);
    }
    const bool all_positive = std::all_of(moments.begin(), moments.end(), [](double moment) {
        return moment > 0.0 && std::isfinite(moment);
    });
    if (moments.size() != 3 || !all_positive)
        throw InputError(
            fmt::format("--moments {}: give three positive numbers in kg m², as in "
                        "--moments 4,3,1.5",
                        printable(text)));
    return {moments[0], moments[1], moments[2]};
}

std::optional<DragModel> drag_named(const std::string& text) {
    if (text.empty()) return std::nullopt;
    for (const DragModel drag :
         {DragModel::none, DragModel::linear, DragModel::axes, DragModel::quadratic})
        if (text == name_of(drag)) return drag;
    throw InputError(
        fmt::format("--drag {}: give none, linear, axes or quadratic", printable(text)));
}

// As many decimals as the standard deviation has a say in.
std::string with_sd(double value, double sd) {
    if (!(sd > 1e-15) || !(std::abs(value) < 1e9))
        return fmt::format("{:.15g} ± {:.2g}", value, sd);
    const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(sd))), 0, 15);
    return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, sd, decimals);
}

// By how much I1 exceeds I2 + I3, in units of I1; no body has more than 0.
double excess_of(const FittedMotion& fit) {
    const double excess = 1.0 - fit.moments[1] - fit.moments[2];
    constexpr double rounding = 1e-12;  // of a plate's moments
    return std::abs(excess) < rounding ? 0.0 : excess;
}

std::string json_of(const FittedMotion& fit) {
    const auto list = [](const Eigen::Vector3d& v) { return json_numbers(v[0], v[1], v[2]); };
    const auto axis = [&fit, &list](int k) { return list(fit.instrument_from_principal.col(k)); };
    JsonObject answer;
    answer.add("rows", fit.n_rows).add("first_time_s", fit.first_time_s);
    answer.json("moments", list(fit.moments)).json("moments_sd", list(fit.moments_sd));
    answer.json("axes", json_list(std::vector<std::string>{axis(0), axis(1), axis(2)}));
    answer.json("axes_sd_rad", list(fit.axes_sd_rad));
    answer.json("omega_rad_s", list(fit.omega_rad_s))
        .json("omega_sd_rad_s", list(fit.omega_sd_rad_s));
    if (fit.I1_kg_m2) answer.add("I1_kg_m2", *fit.I1_kg_m2);
    answer.add("drag", std::string(name_of(fit.drag)));
    answer.json("drag_rates", list(fit.drag_rates)).json("drag_rates_sd", list(fit.drag_rates_sd));
    if (fit.drag == DragModel::linear)
        answer.add("damping_1_s", fit.drag_rates[0]).add("damping_sd_1_s", fit.drag_rates_sd[0]);
    answer.add("residual_rad_s", fit.residual_rad_s).add("noise_rad_s", fit.noise_rad_s);
    answer.add("residual_correlation", fit.correlation);
    return answer.lines();
}

// The air's torque.
void add_drag(const FittedMotion& fit, std::vector<std::string>& lines) {
    const auto& rates = fit.drag_rates;
    const auto& sd = fit.drag_rates_sd;
    if (fit.drag == DragModel::none) return;
    if (fit.drag == DragModel::linear) {
        lines.push_back(fmt::format("damping of L: {} 1/s", with_sd(rates[0], sd[0])));
        return;
    }
    lines.push_back(
        fmt::format("drag {}, torques −γ_i I_i {}: γ = {}, {}, {} {}", name_of(fit.drag),
                    fit.drag == DragModel::axes ? "ω_i" : "|ω_i| ω_i", with_sd(rates[0], sd[0]),
                    with_sd(rates[1], sd[1]), with_sd(rates[2], sd[2]),
                    fit.drag == DragModel::axes ? "1/s" : "1/rad"));
    lines.push_back(fmt::format("linear drag, −γL, would leave a residual of {:.3g} rad/s",
                                fit.linear_residual_rad_s));
}

// What was found, a line each: for the console, and as comments of the scene.
std::vector<std::string> words_of(const FittedMotion& fit, const MeasuredMotion& measured) {
    const auto& m = fit.moments;
    std::vector<std::string> lines{
        fit.I1_kg_m2
            ? fmt::format("moments {:.9g}, {:.9g}, {:.9g} kg m², as given", *fit.I1_kg_m2,
                          *fit.I1_kg_m2 * m[1], *fit.I1_kg_m2 * m[2])
            : fmt::format("I2/I1 = {}, I3/I1 = {} (standard deviations)",
                          with_sd(m[1], fit.moments_sd[1]), with_sd(m[2], fit.moments_sd[2]))};
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d e = fit.instrument_from_principal.col(k);
        lines.push_back(fmt::format("e{} = ({:.4f}, {:.4f}, {:.4f}) in the instrument's axes",
                                    k + 1, e[0], e[1], e[2]));
    }
    lines.push_back(fmt::format("axes uncertain by {:.2g}, {:.2g}, {:.2g} rad about e1, e2, e3",
                                fit.axes_sd_rad[0], fit.axes_sd_rad[1], fit.axes_sd_rad[2]));
    constexpr double least_sds = 3.0;
    if (1.0 - m[1] <= least_sds * fit.moments_sd[1])
        lines.emplace_back("note: I1 = I2 within the uncertainty, so that e1 and e2 are arbitrary");
    if (m[1] - m[2] <= least_sds * std::hypot(fit.moments_sd[1], fit.moments_sd[2]))
        lines.emplace_back("note: I2 = I3 within the uncertainty, so that e2 and e3 are arbitrary");
    lines.push_back(fmt::format("ω at {:g} s = ({}, {}, {}) rad/s", fit.first_time_s,
                                with_sd(fit.omega_rad_s[0], fit.omega_sd_rad_s[0]),
                                with_sd(fit.omega_rad_s[1], fit.omega_sd_rad_s[1]),
                                with_sd(fit.omega_rad_s[2], fit.omega_sd_rad_s[2])));
    add_drag(fit, lines);
    lines.push_back(
        fmt::format("{} rows, residual {:.3g} rad/s a component", fit.n_rows, fit.residual_rad_s));
    if (fit.residual_rad_s > least_sds * fit.noise_rad_s)
        lines.push_back(fmt::format(
            "note: the residual is larger than the noise of the rows, {:.2g} rad/s: {}; "
            "residuals are alike from row to row (correlation {:.2f}), which the standard "
            "deviations "
            "allow for",
            fit.noise_rad_s,
            measured.has_omega ? "the body was not quite free"
                               : "the body was not quite free, or the attitudes are "
                                 "too far apart for differences",
            fit.correlation));
    if (excess_of(fit) > least_sds * std::hypot(fit.moments_sd[1], fit.moments_sd[2]))
        lines.push_back(fmt::format(
            "note: I1 > I2 + I3 by {:.2g}, which no rigid body has: check the units, the "
            "axes and the time span of the table",
            excess_of(fit)));
    if (!measured.has_omega)
        lines.emplace_back(
            "note: the table has no ω; it was computed from the differences of its attitudes");
    if (const std::string gaps = in_words(gaps_of(measured.rows)); !gaps.empty())
        lines.push_back(fmt::format("note: {}", gaps));
    for (const Saturation& saturation : saturations_of(measured.rows))
        lines.push_back(fmt::format("note: {}", in_words(saturation)));
    return lines;
}

// The path by which a scene names a file.
std::filesystem::path seen_from(const std::filesystem::path& scene,
                                const std::filesystem::path& file) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::weakly_canonical(fs::absolute(scene).parent_path());
    const fs::path whole = fs::weakly_canonical(fs::absolute(file));
    const fs::path path = whole.lexically_relative(folder);
    return path.empty() ? whole : path;
}

// A scene is UTF-8 without control characters but line ends and tabs, and could not be read with
// another name in it.
void check_name_in_scene(const std::filesystem::path& scene, const std::filesystem::path& file) {
    const std::string name = seen_from(scene, file).string();
    for (std::string_view rest = name; !rest.empty();) {
        const Utf8Character character = first_character(rest);
        const bool layout = character.code == '\n' || character.code == '\t';
        if (!character.valid || (is_control(character.code) && !layout))
            throw InputError(fmt::format(
                "{}: a scene cannot name this file, because its path is not UTF-8 or has control "
                "characters; rename it, or leave -o out",
                printable(file.string())));
        rest.remove_prefix(character.size);
    }
}

// A scene of the fitted motion, without its drag, with the table beside it. Its times are those
// of the table: the motion is followed back to t = 0. ω(t) tells moments up to a common factor
// only: I1 = 1 kg m² unless they were given.
std::string scene_of(const FittedMotion& fit, const std::filesystem::path& scene,
                     const std::filesystem::path& file, const MeasuredMotion& measured) {
    std::string text = fmt::format("# Fitted to {}.\n", printable(file.filename().string()));
    for (const std::string& line : words_of(fit, measured)) text += fmt::format("# {}\n", line);
    text += "# The scene leaves the drag out.\n";
    const InertiaTensor inertia = InertiaTensor::from_matrix(fit.tensor(), Physicality::waived);
    const RotationState first{fit.first_time_s, measured.rows.front().space_from_body,
                              fit.omega_rad_s};
    const RotationState start = FreeRotation(inertia, first).at(0.0);
    const Eigen::Vector3d moments = inertia.moments_kg_m2() / inertia.moments_kg_m2().maxCoeff();
    if (moments[0] < moments[1] || moments[1] < moments[2])
        text += fmt::format(
            "# The scene numbers the axes otherwise: I1, I2, I3 = {:.4g}, {:.4g}, {:.4g}, in units "
            "of the largest.\n",
            moments[0], moments[1], moments[2]);
    text += fmt::format("\n[body]\ntensor_kg_m2 = {}{}\n", toml_text(fit.tensor()),
                        fit.I1_kg_m2 ? "" : "  # I1 = 1: a common factor has no effect on ω");
    if (excess_of(fit) > 0.0) text += "allow_unphysical = true\n";
    text += fmt::format("\n[start]\nomega_rad_s = {}\n", toml_text(start.omega_body));
    const Eigen::Quaterniond& q = start.space_from_body;
    if (measured.has_attitude)
        text +=
            fmt::format("attitude = {}\n", toml_text(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z())));
    text += fmt::format("\n[measured]\nfile = {}\n",
                        toml_text(std::string_view(seen_from(scene, file).string())));
    // A still shows all points. A film that would be short or long lasts ten seconds.
    const double span_s = measured.rows.back().time_s - fit.first_time_s;
    text += fmt::format("\n[film]\nstart_s = {}\nduration_s = {}\nstill_s = {}\n",
                        toml_text(fit.first_time_s), toml_text(span_s),
                        toml_text(measured.rows.back().time_s));
    constexpr double short_s = 5.0, long_s = 60.0, length_s = 10.0;
    if (span_s < short_s || span_s > long_s)
        text += fmt::format("speed = {}\n", toml_text(span_s / length_s));
    return text;
}

int run(const FitChoices& choices) {
    const std::filesystem::path file = choices.files.at(0);
    if (!choices.output.empty() && suffix_of(choices.output) != ".toml")
        throw InputError(fmt::format("-o {}: the output is a scene; end its name in .toml",
                                     printable(choices.output)));
    if (!choices.output.empty()) check_name_in_scene(choices.output, file);
    std::optional<Eigen::Vector3d> moments;
    if (!choices.moments.empty()) moments = moments_in(choices.moments);
    const std::optional<DragModel> drag = drag_named(choices.drag);
    MeasuredMotion measured;
    FittedMotion fit;
    {
        ProgressBar bar(false);
        const SlowWorkNotice notice(fmt::format("{}: fitting", printable(file.string(), 40)),
                                    bar.sink());
        measured = load_measured(file);
        add_omega_by_differences(measured);
        try {
            fit = fit_motion(measured.rows, moments, drag);
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: {}", printable(file.string()), error.what()));
        }
    }
    if (!choices.output.empty())
        write_whole(choices.output, scene_of(fit, choices.output, file, measured));
    if (choices.json) {
        fmt::print("{}", json_of(fit));
        return 0;
    }
    for (const std::string& line : words_of(fit, measured)) fmt::print("{}\n", line);
    if (choices.output.empty()) return 0;
    fmt::print("{}\n", printable(choices.output));
    if (std::filesystem::file_size(file) > most_table_bytes)
        fmt::print("note: a scene shows tables of at most {} MiB; cut this one for it\n",
                   most_table_bytes >> 20);
    if (const std::filesystem::path path = seen_from(choices.output, file);
        path.is_absolute() || path.begin()->string() == "..")
        fmt::print(
            "note: the table is not in the scene's folder; move it there, or draw the scene with "
            "--allow-outside\n");
    return 0;
}

CommandLine fit_line(std::any& storage) {
    auto& c = storage.emplace<FitChoices>();
    return {&c.files,
            {output_option(c.output,
                           "FILE.toml: write a scene of the fitted body and motion, with "
                           "the measured points"),
             {"--moments",
              "I,I,I: the principal moments in kg m², if they are known; then only the axes, the "
              "start and the drag are fitted",
              &c.moments},
             {"--drag",
              "MODEL: none, linear, axes or quadratic, the torque of the air, −γL, −γ_i I_i ω_i or "
              "−γ_i I_i |ω_i| ω_i along the principal axes; default: linear where this describes "
              "the rows to their noise, else axes or quadratic",
              &c.drag},
             json_option(c.json)},
            [&c] { return run(c); }};
}

}  // namespace

extern const Command fit_command{
    "fit",
    "DATA.csv",
    1,
    1,
    "find the body behind a measured ω(t) or attitude: ratios of moments, principal axes, start "
    "and drag",
    fit_line,
    {{{"poinsot fit gyro.csv",
       "prints what a gyroscope's table says about the body, with uncertainties"},
      {"poinsot fit gyro.csv -o thrown.toml",
       "also writes a scene of that body and its motion; `poinsot still thrown.toml` shows the "
       "measured points"}}}};

}  // namespace poinsot
