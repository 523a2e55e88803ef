// poinsot tradeoff SCENE: measures speed against accuracy for a scene, on this machine.
#include <fmt/format.h>

#include <filesystem>

#include "cli/chart_file.h"
#include "cli/command.h"
#include "cli/options.h"
#include "cli/progress_bar.h"
#include "production/stills/output_place.h"
#include "production/stills/picture.h"
#include "system/files/atomic_file.h"
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

int run(const TradeoffChoices& choices) {
    ProgressBar bar(choices.quiet);
    const Task task = bar.task();
    const Session session = open_session(scene_request(choices.scenes.at(0), choices.given), task);
    tell_notes(session, task);
    const ContextChoice context = context_choice_of(choices.given);
    const Tradeoff t = trade(session, context);

    std::string prefix = with_scene_name(choices.output, session.scene.name).string();
    if (prefix.empty()) {
        std::error_code ignored;
        fs::create_directory("output", ignored);
        prefix = (fs::path("output") / (session.scene.name + "-tradeoff")).string();
    }
    write_whole(prefix + ".csv", csv_of(t));
    write_whole(prefix + ".json", json_of(session, t));
    write_chart(motion_chart(session, t), context, prefix + "-motion.png");
    write_chart(picture_chart(t), context, prefix + "-picture.png");
    write_chart(film_chart(t), context, prefix + "-film.png");

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
