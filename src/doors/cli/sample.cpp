// poinsot sample SCENE --times T,T,…: writes the motion as data.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <utility>

#include "cli/command.h"
#include "cli/instants.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/progress_bar.h"
#include "cli/scenes.h"
#include "cli/sweep.h"
#include "encoding/frame_name.h"
#include "error/error.h"
#include "production/sampling/files/table_file.h"
#include "production/sampling/sample_table.h"
#include "production/session/files/open_session.h"
#include "production/session/session.h"
#include "production/stills/output_place.h"
#include "system/files/own_files.h"
#include "text/numbers.h"
#include "text/printable.h"

namespace poinsot {

namespace {

struct SampleChoices {
    std::vector<std::string> scenes;
    std::vector<std::string> sweeps;
    GivenOptions given;
    std::string times;       // as given; "-" is standard input
    std::string times_file;  // likewise
    std::vector<std::string> columns;
    std::string output;
    bool quiet = false;
};

void print_bytes(std::string_view bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size()) return;
    if (errno == EPIPE) throw ReaderGone("stdout is closed");
    throw EnvironmentError(
        fmt::format("stdout: {}; the output is incomplete", std::strerror(errno)));
}

std::vector<double> instants_of(const SampleChoices& choices) {
    if (choices.times.empty() == choices.times_file.empty())
        throw InputError(
            choices.times.empty()
                ? "poinsot sample: no instants; give --times, as 0,0.5,1 or 0:10:0.1, or "
                  "--times-file; see poinsot sample --help"
                : "--times and --times-file both name the instants; leave one out");
    return choices.times.empty() ? instants_in(choices.times_file) : parse_times(choices.times);
}

// The table of a scene with overridden keys, to be written into this file, or empty: to stdout.
SampleTable table_of(const SampleChoices& choices, const std::string& scene,
                     const std::filesystem::path& output, const std::vector<Override>& overrides,
                     const std::vector<double>& times_s, const Task& task) {
    SceneRequest request = scene_request(scene, choices.given, overrides);
    request.times_s = times_s;
    request.draws = false;
    const Session session = open_session(request, task);
    std::vector<std::filesystem::path> inputs = files_read_for(session.scene);
    inputs.emplace_back(choices.times_file);
    check_replaceable({.path = output, .inputs = std::move(inputs)});
    tell_notes(session, task);
    const std::vector<ChosenColumn> columns = choices.columns.empty()
                                                  ? default_columns(session.motion)
                                                  : columns_named(session.motion, choices.columns);
    return sample_table(session.motion, columns, times_s,
                        choices.times.empty() ? "--times-file" : "--times");
}

double swept_number(const std::string& key, const std::string& value) {
    const auto number = number_of<double>(value);
    if (!number)
        throw InputError(fmt::format(
            "--sweep {}: {} is not a number, so it cannot stand in a column of one table; write a "
            "file for each value with {{KEY}}, {{key}} or #### in the name after -o",
            printable(key), printable(value)));
    return *number;
}

// One table of all runs: each row begins with its values of the sweep.
SampleTable table_of_sweep(const SampleChoices& choices, const std::vector<SweepPoint>& points,
                           const std::vector<double>& times_s, const Task& task) {
    SampleTable all;
    for (const SweepPoint& point : points) {
        std::vector<std::string> headings;
        std::vector<double> values;
        headings.reserve(point.size());
        values.reserve(point.size());
        for (const auto& [key, value] : point) {
            headings.push_back(key);
            values.push_back(swept_number(key, value));
        }
        const SampleTable table = table_of(choices, choices.scenes.at(0), choices.output,
                                           overrides_of(point), times_s, task);
        headings.insert(headings.end(), table.headings.begin(), table.headings.end());
        if (all.headings.empty()) all.headings = headings;
        if (all.headings != headings)
            throw InputError(
                fmt::format("--sweep: {} has other columns than {}; choose columns of both with "
                            "--columns, or write a file for each with {{KEY}} in the name after -o",
                            printable(in_words(point)), printable(in_words(points.front()))));
        if (all.values.size() + table.n_rows() * headings.size() > most_sampled_values)
            throw InputError(fmt::format(
                "--sweep: one table holds at most {} numbers; ask for fewer instants or values, or "
                "write a file for each value with {{KEY}} in the name after -o",
                most_sampled_values));
        const std::size_t width = table.headings.size();
        all.values.reserve(points.size() * table.n_rows() * headings.size());
        for (std::size_t row = 0; row < table.n_rows(); ++row) {
            all.values.insert(all.values.end(), values.begin(), values.end());
            const double* const from = table.values.data() + row * width;
            all.values.insert(all.values.end(), from, from + width);
        }
    }
    return all;
}

// Whether an output's name is distinct for each run of a sweep.
bool names_each(const std::string& output) {
    return output.find('{') != std::string::npos || has_frame_number(output);
}

int run(const SampleChoices& choices) {
    const std::vector<double> times_s = instants_of(choices);
    // An output that cannot be written is refused before the computation.
    const std::filesystem::path output = choices.output;
    const TableFormat& format = output.empty() ? table_formats().front() : table_format_for(output);
    const std::vector<SweepPoint> points = points_of(choices.sweeps);
    ProgressBar bar(choices.quiet);
    const Task task = bar.task();
    if (!choices.sweeps.empty() && names_each(choices.output))
        return for_each_scene(
            jobs_of(choices.scenes, choices.output, OutputKind::picture, choices.sweeps),
            [&](const SceneJob& job) {
                write_table(table_of(choices, job.scene, job.output, job.overrides, times_s, task),
                            format, job.output);
                return 0;
            });
    // Written when the table is complete, so that an instant with an error leaves no partial table.
    const SampleTable table =
        choices.sweeps.empty() ? table_of(choices, choices.scenes.at(0), output, {}, times_s, task)
                               : table_of_sweep(choices, points, times_s, task);
    if (choices.output.empty()) {
        format.write(table, print_bytes);
    } else {
        write_table(table, format, choices.output);
    }
    return 0;
}

std::vector<std::string> names_in(const std::string& text) {
    std::vector<std::string> names;
    std::size_t begin = 0;
    while (begin <= text.size()) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        names.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return names;
}

CommandLine sample_line() {
    const auto choices = std::make_shared<SampleChoices>();
    SampleChoices& c = *choices;
    return {
        &c.scenes,
        {set_option(c.given),
         sweep_option(c.sweeps),
         {.flags = "--times",
          .takes = "T,T,…",
          .help = "instants in seconds, or ranges first:last:step, first:last/n; - reads them from "
                  "standard input",
          .value = ReadText{[&c](const std::string& text) {
              // Errors in it are reported before the scene is read.
              if (text != "-") parse_times(text);
              c.times = text;
          }}},
         {.flags = "--times-file",
          .takes = "FILE",
          .help = "instants, one per line; - is standard input",
          .value = ReadText{[&c](const std::string& file) {
              c.times_file = parse_text("--times-file", file);
          }},
          .completes = "file"},
         {.flags = "--columns",
          .takes = "A,B,…",
          .help =
              "columns instead of the default ones, see list columns; the headings carry the units",
          .value = ReadText{[&c](const std::string& text) {
              c.columns = names_in(parse_text("--columns", text));
          }},
          .completes = "columns"},
         {.flags = "-o,--output",
          .takes = "FILE",
          .help = "write .csv, .jsonl, .npy or .json (keyframes) instead of CSV to stdout",
          .value =
              ReadText{[&c](const std::string& text) { c.output = parse_text("--output", text); }},
          .completes = "file"},
         quiet_option(c.quiet),
         allow_outside_option(c.given.allow_outside)},
        [choices] { return run(*choices); }};
}

}  // namespace

extern const Command sample_command{
    "sample",
    "SCENE",
    1,
    1,
    "print the motion as CSV, at instants or ranges of time",
    sample_line,
    {{{"poinsot sample generic --times 0:60:0.01 -o motion.npy",
       "one minute in steps of 10 ms, as a NumPy array"},
      {"poinsot sample generic --times 0,0.5,1 --columns time,kinetic_energy,contact_space",
       "T and the contact point, with units in the headings"}}}};

}  // namespace poinsot
