// poinsot fit DATA.csv: the body and the motion behind a measured ω(t).
#include "measured/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "cli/chart_file.h"
#include "cli/command.h"
#include "cli/joint_words.h"
#include "cli/options.h"
#include "cli/progress_bar.h"
#include "error/error.h"
#include "measured/files/measured_file.h"
#include "measured/joint_fit.h"
#include "measured/prediction.h"
#include "orders/fitted_rows.h"
#include "production/fits/fit_flights.h"
#include "production/fits/fit_words.h"
#include "production/fits/fitted_scene.h"
#include "production/session/slow_work_notice.h"
#include "production/vectors/flight_page.h"
#include "scene/parse_scene.h"
#include "system/files/atomic_file.h"
#include "system/files/file_kind.h"
#include "system/files/own_files.h"
#include "system/files/seen_from.h"
#include "system/sha256.h"
#include "text/json_text.h"
#include "text/label_text.h"
#include "text/numbers.h"
#include "text/printable.h"
#include "text/utf8.h"

namespace poinsot {

namespace {

struct FitChoices {
    std::vector<std::string> files;
    std::string output, chart;
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
    Eigen::Vector3d known(moments[0], moments[1], moments[2]);
    try {
        check_known_moments(known);
    } catch (const InputError& error) {
        throw InputError(fmt::format("--moments {}: {}", printable(text), error.what()));
    }
    return known;
}

std::optional<DragModel> drag_named(const std::string& text) {
    if (text.empty()) return std::nullopt;
    for (const DragModel drag : drag_models)
        if (text == name_of(drag)) return drag;
    throw InputError(
        fmt::format("--drag {}: give none, linear, axes, quadratic or growing", printable(text)));
}

// The path by which a scene names a file.
std::filesystem::path path_in(const std::filesystem::path& scene,
                              const std::filesystem::path& file) {
    return seen_from(scene.parent_path(), file);
}

// A scene is UTF-8 without control characters but line ends and tabs, and could not be read with
// another name in it.
void check_name_in_scene(const std::filesystem::path& scene, const std::filesystem::path& file) {
    const std::string name = path_in(scene, file).string();
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
    if (!choices.chart.empty() && !is_flight_chart_name(choices.chart))
        throw InputError(
            fmt::format("--chart {}: the chart is an SVG, a PDF or a PNG; end its name in .svg, "
                        ".pdf or .png",
                        printable(choices.chart)));
    const std::vector<std::filesystem::path> inputs(choices.files.begin(), choices.files.end());
    for (const std::string& output : {choices.chart, choices.output})
        check_replaceable({.path = output, .inputs = inputs});
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

// What the chart and its file are called.
std::string title_of(const std::vector<FitTable>& tables) {
    constexpr std::size_t most_characters = 28;
    const std::string first = printable(tables.front().file.filename().string(), most_characters);
    return tables.size() == 1 ? first : fmt::format("{} and {} more", first, tables.size() - 1);
}

// The ratios, if they were fitted.
void add_ratios(ChartedFlight& flight, const std::optional<FittedMotion>& fit) {
    if (!fit || fit->I1_kg_m2) return;
    flight.ratios = fit->moments.tail<2>();
    flight.ratios_sd = fit->moments_sd.tail<2>();
}

void write_chart_of(const FitChoices& choices, const FitTable& table, const TableFlight& flight) {
    const FittedMotion& fit = *flight.fit;
    std::string title = title_of({table});
    if (table.is_recording) title += fmt::format(", flight {}", flight.number);
    FlightChart chart;
    chart.title = as_caption(title);
    if (!fit.I1_kg_m2)
        chart.title += fmt::format(": $I_2/I_1$ = {}, $I_3/I_1$ = {}",
                                   with_sd(fit.moments[1], fit.moments_sd[1]),
                                   with_sd(fit.moments[2], fit.moments_sd[2]));
    chart.flights = {charted(fit, flight.measured.rows)};
    write_chart(chart, title, choices.chart);
}

void write_chart_of(const FitChoices& choices, const std::vector<FitTable>& tables,
                    const JointFit& joint, const std::vector<const TableFlight*>& flights) {
    FlightChart chart;
    const std::string title = title_of(tables);
    chart.title = as_caption(title);
    if (!joint.I1_kg_m2) {
        chart.ratios = joint.moments.tail<2>();
        chart.ratios_sd = joint.moments_sd.tail<2>();
        chart.title += fmt::format(": $I_2/I_1$ = {}, $I_3/I_1$ = {}",
                                   with_sd(joint.moments[1], joint.moments_sd[1]),
                                   with_sd(joint.moments[2], joint.moments_sd[2]));
    }
    for (std::size_t i = 0; i < flights.size(); ++i) {
        const JointFlight& flight = joint.flights[i];
        ChartedFlight made = charted(motion_of(joint, flight), flights[i]->measured.rows);
        made.is_left_out = !flight.left_out.empty();
        made.name = fmt::format("{}{}", i + 1, made.is_left_out ? ", left out" : "");
        add_ratios(made, flight.own);
        chart.flights.push_back(std::move(made));
    }
    write_chart(chart, title, choices.chart);
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
    if (const auto repeated = repeated_flight(rows))
        throw InputError(fmt::format("{} and {} hold the same rows; give each flight once",
                                     flights[repeated->first]->name,
                                     flights[repeated->second]->name));
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
    if (!choices.chart.empty()) write_chart_of(choices, tables, joint, flights);
    if (choices.json) {
        fmt::print("{}", json_of(joint, flights, predictions));
        return 0;
    }
    for (const std::string& line : words_of(joint, flights, predictions)) fmt::print("{}\n", line);
    if (!choices.chart.empty()) fmt::print("{}\n", printable(choices.chart));
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
        FittedScene scene{.fit = fit,
                          .from = printable(file.filename().string()),
                          .words = words_of(table, flight),
                          .last_time_s = flight.measured.rows.back().time_s,
                          .attitude = {}};
        if (table.is_recording) scene.from += fmt::format(", flight {}", flight.number);
        scene.attitude = attitude_of(flight);
        const double zero_s = zero_of(scene);
        is_written = table.is_recording || zero_s != 0.0;
        shown = table_of_scene(table, choices.output, is_written);
        scene.table = path_in(choices.output, shown).string();
        if (is_written) {
            const std::string rows = table_text(counted_from(flight.measured, zero_s));
            scene.table_sha256 = sha256_of(rows);
            check_rows_place(shown, choices.output, rows);
            write_whole(shown, rows);
        }
        write_whole(choices.output, text_of(scene));
    }
    if (!choices.chart.empty()) write_chart_of(choices, table, flight);
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
    for (const std::string& line : words_of(table, flight)) fmt::print("{}\n", line);
    if (prediction) fmt::print("{}\n", words_of(*prediction));
    if (!choices.chart.empty()) fmt::print("{}\n", printable(choices.chart));
    if (choices.output.empty()) return 0;
    fmt::print("{}\n", printable(choices.output));
    if (is_written) fmt::print("{}\n", printable(shown.string()));
    if (std::filesystem::file_size(shown) > most_table_bytes)
        fmt::print("note: a scene shows tables of at most {} MiB; cut this one for it\n",
                   most_table_bytes >> 20);
    if (const std::filesystem::path path = path_in(choices.output, shown);
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
        const SlowWorkNotice notice(fmt::format("{}: fitting", printable(file, 40)), bar.task());
        tables.push_back(fitted_table(load_measured(file), file, known));
    }
    return is_joint ? fit_all(choices, tables, known) : fit_one(choices, tables.front(), known);
}

CommandLine fit_line() {
    const auto choices = std::make_shared<FitChoices>();
    FitChoices& c = *choices;
    return {
        &c.files,
        {output_option(c.output,
                       "write a scene (.toml) of the fitted body and motion, with "
                       "the measured points"),
         {.flags = "--moments",
          .takes = "I,I,I",
          .help = "the principal moments in kg m², if they are known; then only the axes, the "
                  "start and the drag are fitted",
          .value = &c.moments},
         {.flags = "--drag",
          .takes = "MODEL",
          .help =
              "none, linear, axes, quadratic or growing, the torque of the air, −γL, −γ_i I_i ω_i "
              "or −γ_i I_i |ω_i| ω_i along the principal axes, or −γ e^(κt) L; default: linear "
              "where this describes the rows to their noise, else the best of the three others",
          .value = &c.drag},
         {.flags = "--flight",
          .takes = "N",
          .help = "of a recording with several free flights, fit this one, or `all` of them as "
                  "flights of one body; default: the one that says most about the body",
          .value = &c.flight},
         {.flags = "--share-drag",
          .help = "all flights have the same drag coefficients; default: each flight its own",
          .value = &c.share_drag},
         {.flags = "--predict",
          .takes = "N",
          .help = "fit the first N rows of a flight and say how far the other rows depart; with "
                  "several flights, by the body of the others",
          .value = &c.predict,
          .wanted = "rows"},
         {.flags = "--chart",
          .takes = "FILE.svg",
          .help = "draw measured and fitted ω, the residuals and, for several flights, the ratios "
                  "of the moments; also as .pdf or .png",
          .value = &c.chart},
         json_option(c.json)},
        [choices] { return run(*choices); }};
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
