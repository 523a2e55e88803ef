// poinsot sample SCENE --times T,T,…: the motion as data.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "cli/command.h"
#include "cli/instants.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "error/error.h"
#include "production/sampling/sample_table.h"
#include "production/session.h"

namespace poinsot {

namespace {

struct SampleChoices {
    std::vector<std::string> scenes;
    SceneOptions scene;
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
        fmt::format("stdout: {}; nothing more was printed", std::strerror(errno)));
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

int run(const SampleChoices& choices) {
    const std::vector<double> times_s = instants_of(choices);
    // What cannot be written is refused before anything is computed.
    const TableFormat& format =
        choices.output.empty() ? table_formats().front() : table_format_for(choices.output);
    SceneRequest request = scene_request_of(choices.scenes.at(0), choices.scene);
    request.times_s = times_s;
    Progress progress(choices.quiet);
    const Telling telling = progress.telling();
    const Session session = open_session(request, telling);
    tell_notes(session.scene, telling);

    const std::vector<ChosenColumn> columns = choices.columns.empty()
                                                  ? default_columns(session.motion)
                                                  : columns_named(session.motion, choices.columns);
    // Written when all of it is known: an instant that cannot be had leaves no half a table.
    const SampleTable table = sample_table(session.motion, columns, times_s,
                                           choices.times.empty() ? "--times-file" : "--times");
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

CommandLine line(std::any& room) {
    auto& c = room.emplace<SampleChoices>();
    return {&c.scenes,
            {set_option(c.scene),
             {"--times",
              "T,T,…: instants in seconds, or ranges first:last:step, first:last/n; - reads them "
              "from standard input",
              ReadText([&c](const std::string& text) {
                  // What is wrong with it is said before anything is read.
                  if (text != "-") parse_times(text);
                  c.times = text;
              })},
             {"--times-file",
              "FILE: instants, one a line; - is standard input",
              ReadText([&c](const std::string& file) {
                  c.times_file = parse_text("--times-file", file);
              }),
              "",
              {},
              false,
              "file"},
             {"--columns",
              "A,B,…: columns to give instead, with units in their names",
              ReadText([&c](const std::string& text) {
                  c.columns = names_in(parse_text("--columns", text));
              }),
              "",
              {},
              false,
              "columns"},
             {"-o,--output",
              "FILE: .csv, .jsonl or .npy, instead of CSV on stdout",
              ReadText([&c](const std::string& text) { c.output = parse_text("--output", text); }),
              "",
              {},
              false,
              "file"},
             quiet_option(c.quiet),
             allow_outside_option(c.scene.allow_outside)},
            [&c] { return run(c); }};
}

}  // namespace

extern const Command sample_command{
    "sample",
    "SCENE",
    1,
    1,
    "the motion at given times as numbers",
    line,
    {{{"poinsot sample generic --times 0:60:0.01 -o motion.npy", "a minute in steps of 10 ms"},
      {"poinsot sample generic --times 0,0.5,1 --columns time,kinetic_energy,contact_space",
       "T and the contact point, with units in the headings"}}}};

}  // namespace poinsot
