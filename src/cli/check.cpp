// poinsot check SCENE: validates a scene without drawing it, and prints its motion and the modelled
// effects.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/sweep.h"
#include "error/error.h"
#include "production/findings.h"
#include "text/json_text.h"
#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

namespace {

struct CheckChoices {
    std::vector<std::string> scenes;
    std::vector<std::string> sweeps;
    SceneOptions scene;
    bool json = false, plan = false, quiet = false;
};

void print_words(const Findings& findings) {
    for (const Fact& fact : findings.facts)
        if (!fact.label.empty())
            fmt::print("{}: {}\n", fact.label, printable(fact.text, most_of_a_message));
    if (!findings.plan.empty()) {
        fmt::print("\n");
        for (const PlanLine& line : findings.plan)
            fmt::print("{}: {} ({})\n", line.what, printable(line.decision), printable(line.why));
    }
    if (findings.certificate) fmt::print("\n{}", text_of(*findings.certificate));
}

// The findings for the scene with the values of one point of its sweeps.
Findings findings_of(const CheckChoices& choices, const SweepPoint& point, const Telling& telling) {
    const Session session = open_session(
        scene_request_of(choices.scenes.at(0), choices.scene, overrides_of(point)), telling);
    tell_notes(session.scene, telling);
    return examine(session, choices.plan, telling);
}

int code_of(const Findings& findings) {
    return !findings.certificate || findings.certificate->holds() ? 0 : 1;
}

int check_alone(const CheckChoices& choices, const Telling& telling) {
    const Findings findings = findings_of(choices, {}, telling);
    if (choices.json) {
        JsonObject answer;
        for (const Fact& fact : findings.facts) answer.json(fact.key, fact.json);
        fmt::print("{}", answer.lines());
    } else {
        print_words(findings);
    }
    return code_of(findings);
}

// Checks every value, also after an error; in JSON the failed one has an "error". The array is
// printed when it is complete.
int check_sweep(const CheckChoices& choices, const Telling& telling) {
    std::vector<std::string> answers;
    std::string_view between;
    int worst = 0;
    for (const SweepPoint& point : points_of(choices.sweeps)) {
        JsonObject answer;
        for (const auto& [key, value] : point) answer.add(key, value);
        try {
            const Findings findings = findings_of(choices, point, telling);
            worst = std::max(worst, code_of(findings));
            for (const Fact& fact : findings.facts) answer.json(fact.key, fact.json);
            if (!choices.json) {
                fmt::print("{}{}:\n", between, printable(in_words(point), any_length));
                print_words(findings);
                between = "\n";
            }
        } catch (const InputError& error) {
            worst = 2;
            say(printable(error.what()));
            answer.add("error", error.what());
        }
        answers.push_back(answer.line());
    }
    if (choices.json) fmt::print("{}\n", json_lines(answers));
    return worst;
}

int run(const CheckChoices& choices) {
    Progress progress(choices.quiet);
    const Telling telling = progress.telling();
    return choices.sweeps.empty() ? check_alone(choices, telling) : check_sweep(choices, telling);
}

CommandLine check_line(std::any& room) {
    auto& c = room.emplace<CheckChoices>();
    return {&c.scenes,
            {set_option(c.scene),
             sweep_option(c.sweeps),
             size_option(c.scene),
             fps_option(c.scene),
             quality_option(c.scene),
             json_option(c.json,
                         "print JSON: one object, with --sweep an array of one object per value"),
             quiet_option(c.quiet),
             {"--plan", "explain what is modelled and why", &c.plan},
             allow_outside_option(c.scene.allow_outside)},
            [&c] { return run(c); }};
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
