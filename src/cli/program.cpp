#include "cli/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <functional>

#include "cli/command.h"
#include "cli/option_values.h"
#include "error/error.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// One option of the command line: where it is bound is said here and nowhere else.
struct OptionRow {
    std::string_view name;  // as commands name it
    void (*add)(CLI::App& app, Options& options);
};

void add_override(CLI::App& app, Options& options, const char* flag, const char* key,
                  const char* help) {
    app.add_option_function<std::string>(
           flag,
           [&options, flag, key](const std::string& value) {
               // A bare word becomes a TOML string; numbers stay as they are.
               options.overrides.push_back(fmt::format("{}={}", key, parse_text(flag, value)));
           },
           help)
        ->type_name("");
}

template <typename Text>
void add_text(CLI::App& app, const char* option, Text& target, const char* help) {
    const char* const names = std::string_view(option) == "--output" ? "-o,--output" : option;
    app.add_option_function<std::string>(
           names, [&target, option](const std::string& text) { target = parse_text(option, text); },
           help)
        ->type_name("TEXT");
}

void add_number(CLI::App& app, const char* option, std::optional<double>& target,
                const char* wanted, const char* help) {
    app.add_option_function<std::string>(
           option,
           [&target, option, wanted](const std::string& text) {
               target = parse_number(option, text, wanted);
           },
           help)
        ->type_name("NUMBER");
}

template <typename Whole>
void add_whole(CLI::App& app, const char* option, Whole& target, const char* wanted,
               const char* help) {
    app.add_option_function<std::string>(
           option,
           [&target, option, wanted](const std::string& text) {
               target = parse_whole(option, text, wanted);
           },
           help)
        ->type_name("N");
}

const auto option_table = std::to_array<OptionRow>({
    {"output",
     [](CLI::App& app, Options& o) { add_text(app, "--output", o.output, "where to write"); }},
    {"set",
     [](CLI::App& app, Options& o) {
         app.add_option_function<std::vector<std::string>>(
                "--set",
                [&o](const std::vector<std::string>& values) {
                    o.overrides.insert(o.overrides.end(), values.begin(), values.end());
                },
                "key=value: change any scene key; repeatable")
             ->type_name("KEY=VALUE")
             ->allow_extra_args(false)
             ->take_all();
     }},
    {"size",
     [](CLI::App& app, Options& o) {
         add_override(app, o, "--size", "film.size", "WxH: size of the picture in pixels");
     }},
    {"fps",
     [](CLI::App& app, Options& o) {
         add_override(app, o, "--fps", "film.fps", "N or N/D: video frames a second");
     }},
    {"quality",
     [](CLI::App& app, Options& o) {
         add_override(app, o, "--quality", "film.quality", "draft, lecture, print or reference");
     }},
    {"theme",
     [](CLI::App& app, Options& o) {
         add_override(app, o, "--theme", "theme", "light, dark, print, colour-blind, transparent or transparent-dark");
     }},
    {"width-mm",
     [](CLI::App& app, Options& o) {
         add_number(app, "--width-mm", o.print.width_mm, "millimetres", "width on paper in millimetres");
     }},
    {"height-mm",
     [](CLI::App& app, Options& o) {
         add_number(app, "--height-mm", o.print.height_mm, "millimetres",
                        "height on paper; from the scene's shape if not given");
     }},
    {"dpi",
     [](CLI::App& app, Options& o) {
         add_number(app, "--dpi", o.print.dpi, "dots per inch", "dots per inch on paper; 300 if not given");
     }},
    {"type-pt",
     [](CLI::App& app, Options& o) {
         add_number(app, "--type-pt", o.print.type_pt, "points",
                        "size of labels on paper in points, 8.5 if not given; lines follow it");
     }},
    {"depth",
     [](CLI::App& app, Options& o) {
         add_whole(app, "--depth", o.print.bit_depth, "8 or 16", "bits a colour component: 8 or 16");
     }},
    {"frames",
     [](CLI::App& app, Options& o) {
         app.add_option_function<std::string>(
             "--frames", [&o](const std::string& text) { o.frames = parse_frames(text); },
             "A-B: only these frames, from 0, both included");
     }},
    {"time",
     [](CLI::App& app, Options& o) {
         add_number(app, "--time", o.time_s, "an instant in seconds",
                        "instant of the motion in seconds; if not given, film.still_s of the scene, or "
                        "the film's last");
     }},
    {"times",
     [](CLI::App& app, Options& o) {
         app.add_option_function<std::string>(
                "--times", [&o](const std::string& text) { o.times_s = parse_times(text); },
                "T,T,…: instants of the motion in seconds")
             ->required();
     }},
    {"verify",
     [](CLI::App& app, Options& o) {
         app.add_flag("--verify", o.verify,
                      "read all of the file: is it as it was written? tells mistakes, not forgeries");
     }},
    {"json", [](CLI::App& app, Options& o) { app.add_flag("--json", o.json, "answer in JSON"); }},
    {"profile",
     [](CLI::App& app, Options& o) {
         add_text(app, "--profile", o.compare.profile,
                        "portable: no pixel may differ; native: as much as processors round apart");
     }},
    {"max-differing",
     [](CLI::App& app, Options& o) {
         add_text(app, "--max-differing", o.compare.max_differing,
                        "share of the pixels that may differ at all, as 0.001 or 0.1%");
     }},
    {"max-over",
     [](CLI::App& app, Options& o) {
         add_text(app, "--max-over", o.compare.max_over,
                        "share of the pixels that may differ by more than --over-levels");
     }},
    {"over-levels",
     [](CLI::App& app, Options& o) {
         add_whole(app, "--over-levels", o.compare.over_levels, "a level of 0 to 255",
                        "levels of 255 that --max-over counts from; 2 if not given");
     }},
    {"report",
     [](CLI::App& app, Options& o) {
         add_text(app, "--report", o.compare.report,
                        "FILE.html: write a page that shows the pictures");
     }},
    {"junit",
     [](CLI::App& app, Options& o) {
         add_text(app, "--junit", o.compare.junit,
                        "FILE.xml: write test results");
     }},
    {"diff",
     [](CLI::App& app, Options& o) {
         add_text(app, "--diff", o.compare.diff,
                        "FILE.png: write expected | difference × 16 | actual");
     }},
    {"results",
     [](CLI::App& app, Options& o) {
         add_text(app, "--results", o.approve.results,
                        "folder of the new pictures");
     }},
    {"baselines",
     [](CLI::App& app, Options& o) {
         add_text(app, "--baselines", o.approve.baselines,
                        "folder of the baselines and their manifest");
     }},
    {"why",
     [](CLI::App& app, Options& o) {
         add_text(app, "--why", o.approve.why,
                        "the reason for the change, kept in the manifest");
     }},
    {"any-renderer",
     [](CLI::App& app, Options& o) {
         app.add_flag("--any-renderer", o.approve.any_renderer,
                        "take pictures of another renderer or profile, too");
     }},
    {"all",
     [](CLI::App& app, Options& o) {
         app.add_flag("--all", o.approve.all,
                        "take every picture that is new or has changed");
     }},
    {"all-rows",
     [](CLI::App& app, Options& o) {
         app.add_flag("--all", o.all_rows, "print every row, not only those that no other beats");
     }},
    {"quiet", [](CLI::App& app,
                 Options& o) { app.add_flag("--quiet,-q", o.quiet, "no progress, no notes"); }},
    {"plan", [](CLI::App& app,
                Options& o) { app.add_flag("--plan", o.plan, "what will be modelled, and why"); }},
    {"backend", [](CLI::App& app,
                   Options& o) { add_text(app, "--backend", o.backend, "auto, osmesa or egl"); }},
    {"portable",
     [](CLI::App& app, Options& o) {
         app.add_flag("--portable", o.portable, "the same bytes on every processor");
     }},
    {"allow-outside",
     [](CLI::App& app, Options& o) {
         app.add_flag("--allow-outside", o.allow_outside,
                      "let the scene name files outside of its folder");
     }},
    {"certify",
     [](CLI::App& app, Options& o) {
         app.add_flag("--certify", o.certify, "measure how well it is Poinsot's, over all frames");
     }},
});

void add_option(std::string_view name, CLI::App& app, Options& options) {
    for (const OptionRow& row : option_table) {
        if (row.name == name) return row.add(app, options);
    }
    throw std::logic_error(fmt::format("no option \"{}\" in the table", name));
}

// CLI11 splits "--set a=b" rightly but has its own words for what is wrong; these are ours.
[[noreturn]] void refuse(const std::string& what) {
    throw InputError(fmt::format("poinsot: {}; see poinsot --help", what));
}

// Data that could not be printed must not look like success.
void flush_stdout() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        if (errno == EPIPE) throw ReaderGone("stdout is closed");
        throw EnvironmentError(fmt::format("stdout: {}; nothing more was printed",
                                           std::strerror(errno != 0 ? errno : EIO)));
    }
}

}  // namespace

std::span<const Command> commands() {
    static const std::array table{render_command,   still_command,    check_command,
                                  sample_command,   compare_command,  approve_command,
                                  explain_command,  rerender_command, recover_command,
                                  tradeoff_command, list_command,     doctor_command};
    return table;
}

int run_program(int argc, const char* const* argv) {
    CLI::App app("Poinsot's construction of a turning rigid body: exact motion, drawn off-screen.",
                 "poinsot");
    app.require_subcommand(1);
    app.set_version_flag("--version", "poinsot " POINSOT_VERSION);

    // A mistyped command gets the nearest name, which CLI11 does not give.
    if (argc > 1 && argv[1][0] != '-') {
        std::vector<std::string_view> names;
        for (const Command& command : commands()) names.push_back(command.name);
        if (std::find(names.begin(), names.end(), argv[1]) == names.end()) {
            refuse(fmt::format("unknown command \"{}\"{}", printable(argv[1]),
                               did_you_mean(argv[1], names)));
        }
    }

    Options options;
    const Command* chosen = nullptr;
    for (const Command& command : commands()) {
        CLI::App* sub = app.add_subcommand(std::string(command.name), std::string(command.summary));
        auto* arguments = sub->add_option(std::string(command.arguments), options.arguments);
        arguments->expected(command.least_arguments, command.most_arguments);
        if (command.least_arguments > 0) arguments->required();
        for (const std::string_view name : command.options) add_option(name, *sub, options);
        sub->callback([&chosen, &command] { chosen = &command; });
    }

    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        app.exit(success);
        flush_stdout();
        return 0;
    } catch (const CLI::ParseError& error) {
        refuse(error.what());
    }
    const int code = chosen->run(options);
    flush_stdout();
    return code;
}

}  // namespace poinsot
