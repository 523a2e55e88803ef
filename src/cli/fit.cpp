// poinsot fit DATA.csv: the body and the motion behind a measured ω(t).
#include "measured/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "cli/command.h"
#include "cli/fit_flights.h"
#include "cli/fit_words.h"
#include "cli/joint_words.h"
#include "cli/options.h"
#include "cli/progress_bar.h"
#include "error/error.h"
#include "measured/joint_fit.h"
#include "measured/prediction.h"
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
    std::string moments, drag, flight;
    std::optional<int> predict;
    bool share_drag = false;
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
    for (const DragModel drag : {DragModel::none, DragModel::linear, DragModel::axes,
                                 DragModel::quadratic, DragModel::growing})
        if (text == name_of(drag)) return drag;
    throw InputError(
        fmt::format("--drag {}: give none, linear, axes, quadratic or growing", printable(text)));
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

// The drag of a fit as a scene says it, or why the scene leaves it out.
struct SceneDrag {
    std::optional<DragTorque> torque;
    std::string_view left_out{};
};

// Whether the drag changes the motion by more than its uncertainty and the rounding of the rows.
bool is_noticed(const FittedMotion& fit, double span_s) {
    constexpr double least_sds = 2.0, least_change = 1e-9;
    const double rate = fit.drag == DragModel::quadratic ? fit.omega_rad_s.norm() : 1.0;
    const int n = fit.drag == DragModel::growing ? 1 : 3;
    for (int k = 0; k < n; ++k)
        if (std::abs(fit.drag_rates[k]) > least_sds * fit.drag_rates_sd[k] &&
            std::abs(fit.drag_rates[k]) * rate * span_s > least_change)
            return true;
    return false;
}

SceneDrag drag_of(const FittedMotion& fit, double span_s) {
    if (fit.drag == DragModel::none) return {};
    if (!is_noticed(fit, span_s)) return {{}, "it does not differ from 0"};
    DragTorque drag;
    Eigen::Vector3d& rates =
        fit.drag == DragModel::quadratic ? drag.quadratic_1_rad : drag.linear_1_s;
    if (fit.drag == DragModel::growing) {
        rates.setConstant(fit.drag_rates[0]);
        drag.growth_1_s = fit.drag_rates[1];
    } else {
        // Along the axes of the scene's tensor, which may number them otherwise.
        const Eigen::Matrix3d along = (InertiaTensor::from_matrix(fit.tensor(), Physicality::waived)
                                           .body_from_principal()
                                           .transpose() *
                                       fit.instrument_from_principal)
                                          .cwiseAbs();
        constexpr double same = 1.0 - 1e-9;
        for (int k = 0; k < 3; ++k) {
            Eigen::Index own = 0;
            if (!(along.row(k).maxCoeff(&own) > same) && fit.drag != DragModel::linear)
                return {{}, "two moments are equal and their axes arbitrary"};
            rates[k] = fit.drag_rates[own];
        }
    }
    if (rates.minCoeff() < 0.0) return {{}, "a rate is negative, and air only slows"};
    return {drag, {}};
}

std::string text_of(const DragTorque& drag) {
    std::string text = "\n[torque]\nkind = \"drag\"\n";
    if (!drag.linear_1_s.isZero(0.0))
        text += fmt::format("linear_1_s = {}\n", toml_text(drag.linear_1_s));
    if (!drag.quadratic_1_rad.isZero(0.0))
        text += fmt::format("quadratic_1_rad = {}\n", toml_text(drag.quadratic_1_rad));
    if (drag.growth_1_s != 0.0)
        text += fmt::format("growth_1_s = {}\n", toml_text(drag.growth_1_s));
    return text + "\n[motion]\nmethod = \"dopri5\"\n";
}

// A scene of the fitted motion, with the table beside it. Its times are those of the table: without
// drag the motion is followed back to t = 0, with drag the table begins there. ω(t) tells moments
// up to a common factor only: I1 = 1 kg m² unless they were given.
std::string scene_of(const FittedMotion& fit, const std::filesystem::path& scene,
                     const std::filesystem::path& file, const std::string& name,
                     const MeasuredMotion& measured, const SceneDrag& drag) {
    std::string text = fmt::format("# Fitted to {}.\n", name);
    for (const std::string& line : words_of(fit, measured)) text += fmt::format("# {}\n", line);
    const InertiaTensor inertia = InertiaTensor::from_matrix(fit.tensor(), Physicality::waived);
    if (!drag.left_out.empty())
        text += fmt::format("# The scene leaves the drag out: {}.\n", drag.left_out);
    RotationState start{fit.first_time_s, measured.rows.front().space_from_body, fit.omega_rad_s};
    if (start.time_s != 0.0) start = FreeRotation(inertia, start).at(0.0);
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
    if (drag.torque) text += text_of(*drag.torque);
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

// The motion and its fit with times from the first row on, where a scene begins that has drag: a
// motion under drag cannot be followed far back.
void begin_at_zero(MeasuredMotion& measured, FittedMotion& fit) {
    for (MeasuredRow& row : measured.rows) row.time_s -= fit.first_time_s;
    fit.first_time_s = 0.0;
}

// The flight that --flight names, or the best one.
const TableFlight& chosen_flight(const FitTable& table, const std::string& wanted) {
    if (wanted.empty()) return best_flight(table);
    const auto number = number_of<std::size_t>(wanted);
    const std::size_t n = table.flights.size();
    if (!number || *number < 1 || *number > n)
        throw InputError(fmt::format(
            "--flight {}: {} has {}; give {}", printable(wanted), printable(table.file.string()),
            n == 1 ? "1 flight" : fmt::format("{} flights", n),
            n == 1 ? "1, or leave it out" : fmt::format("a number from 1 to {}", n)));
    const TableFlight& flight = table.flights[*number - 1];
    if (!flight.fit) throw InputError(fmt::format("{}: {}", flight.name, flight.refusal));
    return flight;
}

// The table that the scene shows: the given one, or rows that are written beside the scene.
std::filesystem::path table_of_scene(const FitTable& table, const std::filesystem::path& scene,
                                     bool is_written) {
    if (!is_written) return table.file;
    std::filesystem::path file = scene;
    file.replace_extension(".csv");
    std::error_code ignored;
    if (std::filesystem::equivalent(file, table.file, ignored))
        throw InputError(fmt::format(
            "-o {}: the rows of the scene would overwrite {}; give the scene another name",
            printable(scene.string()), printable(table.file.string())));
    return file;
}

std::size_t n_predicted_from(const FitChoices& choices) {
    if (*choices.predict < 1)
        throw InputError(
            fmt::format("--predict {}: give the number of rows that are fitted", *choices.predict));
    return static_cast<std::size_t>(*choices.predict);
}

void check_output(const FitChoices& choices, bool is_joint) {
    if (choices.output.empty()) return;
    if (suffix_of(choices.output) != ".toml")
        throw InputError(fmt::format("-o {}: the output is a scene; end its name in .toml",
                                     printable(choices.output)));
    if (is_joint)
        throw InputError(
            fmt::format("-o {}: a scene shows one flight; give one table, or name a flight with "
                        "--flight",
                        printable(choices.output)));
    if (choices.predict)
        throw InputError(fmt::format("-o {}: a scene shows a fit of all rows; leave --predict out",
                                     printable(choices.output)));
    check_name_in_scene(choices.output, choices.files.at(0));
}

// All flights as those of one body.
int fit_all(const FitChoices& choices, const std::vector<FitTable>& tables, const FitKnown& known) {
    std::vector<const TableFlight*> flights;
    std::vector<std::span<const MeasuredRow>> rows;
    for (const FitTable& table : tables)
        for (const TableFlight& flight : table.flights) {
            flights.push_back(&flight);
            rows.emplace_back(flight.measured.rows);
        }
    if (flights.size() < 2)
        throw InputError(
            fmt::format("{}: the table has one flight; give more tables, or leave "
                        "--flight out",
                        printable(tables.front().file.string())));
    const JointFit joint = fit_together(rows, known.moments_kg_m2, known.drag, choices.share_drag);
    FlightPredictions predictions(choices.predict ? flights.size() : 0);
    for (std::size_t i = 0; i < predictions.size(); ++i) {
        if (!joint.flights[i].left_out.empty()) continue;
        try {
            predictions[i] = predicted_by_others(rows[i], n_predicted_from(choices), joint, i);
        } catch (const InputError& error) {
            throw InputError(fmt::format("--predict {}: {}: {}", *choices.predict, flights[i]->name,
                                         error.what()));
        }
    }
    if (choices.json) {
        fmt::print("{}", json_of(joint, flights, predictions));
        return 0;
    }
    for (const std::string& line : words_of(joint, flights, predictions)) fmt::print("{}\n", line);
    return 0;
}

// One flight: the whole table, or one of a recording.
int fit_one(const FitChoices& choices, const FitTable& table, const FitKnown& known) {
    const std::filesystem::path& file = table.file;
    const TableFlight& flight = chosen_flight(table, choices.flight);
    const FittedMotion& fit = *flight.fit;
    std::optional<Prediction> prediction;
    if (choices.predict) try {
            prediction = predicted_alone(flight.measured.rows, n_predicted_from(choices),
                                         known.moments_kg_m2, known.drag);
        } catch (const InputError& error) {
            throw InputError(
                fmt::format("--predict {}: {}: {}", *choices.predict, flight.name, error.what()));
        }
    std::filesystem::path shown;
    bool is_written = false;
    if (!choices.output.empty()) {
        MeasuredMotion measured = flight.measured;
        FittedMotion shifted = fit;
        const SceneDrag drag = drag_of(fit, measured.rows.back().time_s - fit.first_time_s);
        const bool is_shifted = drag.torque && fit.first_time_s != 0.0;
        if (is_shifted) begin_at_zero(measured, shifted);
        is_written = table.is_recording || is_shifted;
        shown = table_of_scene(table, choices.output, is_written);
        std::string name = printable(file.filename().string());
        if (table.is_recording) name += fmt::format(", flight {}", flight.number);
        if (is_shifted)
            name += fmt::format(", whose {} s are the 0 s of the scene", fit.first_time_s);
        const std::string text = scene_of(shifted, choices.output, shown, name, measured, drag);
        if (is_written) write_whole(shown, table_text(measured));
        write_whole(choices.output, text);
    }
    if (choices.json) {
        JsonObject answer;
        if (table.is_recording)
            answer.json("flights", json_of_flights(table)).add("flight", flight.number);
        add_fit(answer, fit);
        if (prediction) answer.json("prediction", json_of(*prediction));
        fmt::print("{}", answer.lines());
        return 0;
    }
    if (table.is_recording) {
        fmt::print("{} in {}, standard deviations:\n",
                   table.flights.size() == 1 ? "1 free flight"
                                             : fmt::format("{} free flights", table.flights.size()),
                   printable(file.string()));
        for (const std::string& line : flight_lines(table)) fmt::print("{}\n", line);
        fmt::print("flight {}{}:\n", flight.number,
                   choices.flight.empty() ? ", which says most about the body" : "");
    }
    for (const std::string& line : words_of(fit, flight.measured)) fmt::print("{}\n", line);
    if (prediction) fmt::print("{}\n", words_of(*prediction));
    if (choices.output.empty()) return 0;
    fmt::print("{}\n", printable(choices.output));
    if (is_written) fmt::print("{}\n", printable(shown.string()));
    if (std::filesystem::file_size(shown) > most_table_bytes)
        fmt::print("note: a scene shows tables of at most {} MiB; cut this one for it\n",
                   most_table_bytes >> 20);
    if (const std::filesystem::path path = seen_from(choices.output, shown);
        path.is_absolute() || path.begin()->string() == "..")
        fmt::print(
            "note: the table is not in the scene's folder; move it there, or draw the scene with "
            "--allow-outside\n");
    return 0;
}

int run(const FitChoices& choices) {
    const bool is_joint = choices.files.size() > 1 || choices.flight == "all";
    check_output(choices, is_joint);
    if (choices.files.size() > 1 && !choices.flight.empty() && choices.flight != "all")
        throw InputError(
            fmt::format("--flight {}: of several tables all flights are fitted; give one table",
                        printable(choices.flight)));
    if (choices.share_drag && !is_joint)
        throw InputError(
            "--share-drag: one flight shares its drag with none; give several tables, "
            "or --flight all");
    FitKnown known;
    if (!choices.moments.empty()) known.moments_kg_m2 = moments_in(choices.moments);
    known.drag = drag_named(choices.drag);
    std::vector<FitTable> tables;
    ProgressBar bar(false);
    for (const std::string& file : choices.files) {
        const SlowWorkNotice notice(fmt::format("{}: fitting", printable(file, 40)), bar.sink());
        tables.push_back(fitted_table(file, known));
    }
    return is_joint ? fit_all(choices, tables, known) : fit_one(choices, tables.front(), known);
}

CommandLine fit_line(std::any& storage) {
    auto& c = storage.emplace<FitChoices>();
    return {
        &c.files,
        {output_option(c.output,
                       "FILE.toml: write a scene of the fitted body and motion, with "
                       "the measured points"),
         {"--moments",
          "I,I,I: the principal moments in kg m², if they are known; then only the axes, the "
          "start and the drag are fitted",
          &c.moments},
         {"--drag",
          "MODEL: none, linear, axes, quadratic or growing, the torque of the air, −γL, −γ_i I_i "
          "ω_i or −γ_i I_i |ω_i| ω_i along the principal axes, or −γ e^(κt) L; default: linear "
          "where this describes the rows to their noise, else the best of the three others",
          &c.drag},
         {"--flight",
          "N: of a recording with several free flights, fit this one, or `all` of them as "
          "flights of one body; default: the one that says most about the body",
          &c.flight},
         {"--share-drag",
          "all flights have the same drag coefficients; default: each flight its own",
          &c.share_drag},
         {"--predict",
          "N: fit the first N rows of a flight and say how far the other rows depart; with "
          "several flights, by the body of the others",
          &c.predict, "rows"},
         json_option(c.json)},
        [&c] { return run(c); }};
}

}  // namespace

extern const Command fit_command{
    "fit",
    "DATA.csv…",
    1,
    any_number,
    "find the body behind a measured ω(t) or attitude: ratios of moments, principal axes, start "
    "and drag",
    fit_line,
    {{{"poinsot fit gyro.csv -o thrown.toml",
       "prints what a gyroscope's table says about the body, and writes a scene of its motion; "
       "`poinsot still thrown.toml` shows the measured points"},
      {"poinsot fit recording.csv --flight all",
       "finds the free flights of a recording and fits them as those of one body"}}}};

}  // namespace poinsot
