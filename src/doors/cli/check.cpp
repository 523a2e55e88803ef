// poinsot check SCENE: validates a scene without drawing it, and prints its motion and the modelled
// effects.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "cli/check_against.h"
#include "cli/command.h"
#include "cli/options.h"
#include "cli/progress_bar.h"
#include "cli/scenes.h"
#include "cli/sweep.h"
#include "error/error.h"
#include "production/films/job_choice.h"
#include "production/session/scene_summary.h"
#include "text/json_text.h"
#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

namespace {

struct CheckChoices {
    std::vector<std::string> scenes;
    std::vector<std::string> sweeps;
    GivenOptions given;
    AgainstChoices against;
    bool json = false, plan = false, quiet = false;
};

void print_words(const SceneSummary& summary) {
    for (const SummaryLine& line : summary.lines)
        if (!line.label.empty())
            fmt::print("{}: {}\n", line.label, printable(line.text, most_of_a_message));
    if (!summary.plan.empty()) {
        fmt::print("\n");
        for (const PlanLine& line : summary.plan)
            fmt::print("{}: {} ({})\n", line.what, printable(line.decision), printable(line.why));
    }
    if (summary.certificate) fmt::print("\n{}", text_of(*summary.certificate));
}

// The summary for the scene with the values of one point of its sweeps.
SceneSummary summary_of(const CheckChoices& choices, const SweepPoint& point, const Task& task) {
    const Session session =
        open_session(scene_request(choices.scenes.at(0), choices.given, overrides_of(point)), task);
    tell_notes(session, task);
    SceneSummary summary = summarise(session, choices.plan, task);
    if (choices.plan) {
        const std::vector<PlanLine> of_parts = plan_of_parts(session, film_plan(session));
        summary.plan.insert(summary.plan.end() - 1, of_parts.begin(), of_parts.end());
    }
    return summary;
}

int code_of(const SceneSummary& summary) {
    return !summary.certificate || summary.certificate->holds() ? 0 : 1;
}

int check_alone(const CheckChoices& choices, const Task& task) {
    const SceneSummary summary = summary_of(choices, {}, task);
    if (choices.json) {
        JsonObject answer;
        for (const SummaryLine& line : summary.lines) answer.json(line.key, line.json);
        fmt::print("{}", answer.lines());
    } else {
        print_words(summary);
    }
    return code_of(summary);
}

// Checks every value, also after an error; in JSON the failed one has an "error". The array is
// printed when it is complete.
int check_sweep(const CheckChoices& choices, const Task& task) {
    std::vector<std::string> answers;
    std::string_view between;
    int worst = 0;
    Refusals refusals;
    for (const SweepPoint& point : points_of(choices.sweeps)) {
        JsonObject answer;
        for (const auto& [key, value] : point) answer.add(key, value);
        const auto check = [&] {
            const SceneSummary summary = summary_of(choices, point, task);
            for (const SummaryLine& line : summary.lines) answer.json(line.key, line.json);
            if (!choices.json) {
                fmt::print("{}{}:\n", between, printable(in_words(point), any_length));
                print_words(summary);
                between = "\n";
            }
            return code_of(summary);
        };
        const SceneJob job{choices.scenes.at(0), "", overrides_of(point)};
        worst = std::max(worst, refusals.code_of(job, [&] {
            try {
                return check();
            } catch (const InputError& error) {
                answer.add("error", error.what());
                throw;
            }
        }));
        answers.push_back(answer.line());
    }
    refusals.say_others();
    if (choices.json) fmt::print("{}\n", json_lines(answers));
    return worst;
}

int run(const CheckChoices& choices) {
    ProgressBar bar(choices.quiet);
    const Task task = bar.task();
    if (!choices.against.file.empty()) {
        if (!choices.sweeps.empty() || choices.plan)
            throw InputError("--against compares one motion; leave out --sweep and --plan");
        AgainstChoices against = choices.against;
        against.json = choices.json;
        return check_against(scene_request(choices.scenes.at(0), choices.given), against, task);
    }
    if (!choices.against.tolerance.empty() || !choices.against.chart.empty())
        throw InputError("--tolerance and --chart belong to --against FILE.csv");
    return choices.sweeps.empty() ? check_alone(choices, task) : check_sweep(choices, task);
}

CommandLine check_line() {
    const auto choices = std::make_shared<CheckChoices>();
    CheckChoices& c = *choices;
    return {
        &c.scenes,
        joined(
            {{set_option(c.given), sweep_option(c.sweeps)},
             options_of(Verb::check, c.given),
             {json_option(c.json,
                          "print JSON: one object, with --sweep an array of one object per value"),
              quiet_option(c.quiet),
              {.flags = "--against",
               .takes = "FILE.csv",
               .help = "compare the motion in this table with the scene's",
               .value = &c.against.file,
               .completes = "file"},
              {.flags = "--tolerance",
               .takes = "TOL",
               .help =
                   "with --against, the error of the attitude that passes: pixels of the picture, "
                   "as 0.5px, or an angle, as 0.01rad; default: the scene's accuracy_px",
               .value = &c.against.tolerance},
              {.flags = "--chart",
               .takes = "FILE.png",
               .help = "with --against, draw the errors against time",
               .value = &c.against.chart,
               .completes = "file"},
              {.flags = "--plan", .help = "explain what is modelled and why", .value = &c.plan},
              allow_outside_option(c.given.allow_outside)}}),
        [choices] { return run(*choices); }};
}

}  // namespace

extern const Command check_command{
    "check",
    "SCENE",
    1,
    1,
    "validate a scene and print its accuracy, regime, constants and periods",
    check_line,
    {{{"poinsot check my_scene.toml", "validates the scene and describes its motion"},
      {"poinsot check generic --plan", "also explains what a film of the scene models and why"}}}};

}  // namespace poinsot
