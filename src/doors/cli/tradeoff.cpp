// poinsot tradeoff SCENE: measures speed against accuracy for a scene, on this machine.
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cli/chart_file.h"
#include "cli/command.h"
#include "cli/options.h"
#include "cli/progress_bar.h"
#include "production/stills/output_place.h"
#include "production/stills/picture.h"
#include "system/files/atomic_file.h"
#include "system/files/own_files.h"
#include "system/seal.h"
#include "tradeoff/tradeoff_report.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

struct TradeoffChoices {
    std::vector<std::string> scenes;
    std::string output;
    GivenOptions given;
    bool all = false, json = false, quiet = false;
};

// The files that a prefix names.
constexpr const char* list_suffix = ".json";
constexpr const char* suffixes[] = {list_suffix, ".csv", "-motion.png", "-picture.png",
                                    "-film.png"};

// The list proves the other files: it has their hashes.
void check_places(const std::string& prefix, const Scene& scene) {
    const FileList list(prefix + list_suffix);
    for (const std::string suffix : suffixes)
        check_replaceable({.path = prefix + suffix,
                           .is_own =
                               [&](const fs::path& file) {
                                   return suffix == list_suffix ? !list.text().empty()
                                                                : list.proves(file);
                               },
                           .what = "the tradeoff",
                           .inputs = files_read_for(scene)});
}

void write_files(const std::string& prefix, const Session& session, const Tradeoff& t,
                 const ContextChoice& context) {
    const std::vector<std::pair<std::string, Chart>> charts{
        {"-motion.png", motion_chart(session, t)},
        {"-picture.png", picture_chart(t)},
        {"-film.png", film_chart(t)}};
    std::vector<FileHash> hashes;
    const auto put = [&](const std::string& suffix) {
        const fs::path file = prefix + suffix;
        hashes.push_back({file.filename().string(), sha256_of_file(file)});
    };
    write_whole(prefix + ".csv", csv_of(t));
    put(".csv");
    for (const auto& [suffix, chart] : charts) {
        write_chart(chart, context, prefix + suffix);
        put(suffix);
    }
    write_whole(prefix + list_suffix, with_files(json_of(session, t), hashes));
}

int run(const TradeoffChoices& choices) {
    ProgressBar bar(choices.quiet);
    const Task task = bar.task();
    const Session session = open_session(scene_request(choices.scenes.at(0), choices.given), task);
    tell_notes(session, task);
    const ContextChoice context = context_choice_of(choices.given);
    std::string prefix = with_scene_name(choices.output, session.scene.name).string();
    if (prefix.empty()) {
        std::error_code ignored;
        fs::create_directory("output", ignored);
        prefix = (fs::path("output") / (session.scene.name + "-tradeoff")).string();
    }
    check_places(prefix, session.scene);
    const Tradeoff t = trade(session, context);
    write_files(prefix, session, t, context);

    if (choices.json) {
        fmt::print("{}", json_of(session, t));
    } else {
        fmt::print("{}", table_of(session, t, choices.all));
    }
    task.say(
        fmt::format("{0}.csv, {0}.json, {0}-motion.png, {0}-picture.png, {0}-film.png", prefix));
    return 0;
}

CommandLine tradeoff_line() {
    const auto choices = std::make_shared<TradeoffChoices>();
    TradeoffChoices& c = *choices;
    return {&c.scenes,
            joined({{output_option(c.output), set_option(c.given)},
                    options_of(Verb::tradeoff, c.given),
                    {json_option(c.json),
                     quiet_option(c.quiet),
                     {.flags = "--all",
                      .help = "print every row, not only the Pareto front",
                      .value = &c.all},
                     allow_outside_option(c.given.allow_outside)}}),
            [choices] { return run(*choices); }};
}

}  // namespace

extern const Command tradeoff_command{
    "tradeoff",
    "SCENE",
    1,
    1,
    "measure speed against accuracy for methods, picture settings and encoders",
    tradeoff_line,
    {{{"poinsot tradeoff generic", "the Pareto front of methods, picture settings and encoders"},
      {"poinsot tradeoff generic --all --json", "every row, as JSON"}}}};

}  // namespace poinsot
