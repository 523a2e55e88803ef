// poinsot check SCENE: validates without drawing and says what the motion is and what will be
// modelled.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/sweep.h"
#include "production/findings.h"
#include "text/json_text.h"
#include "text/printable.h"

namespace poinsot {

namespace {

struct CheckChoices {
    std::vector<std::string> scenes;
    std::vector<std::string> sweeps;
    SceneOptions scene;
    bool json = false, plan = false, quiet = false;
};

void print_json(const std::vector<Fact>& facts, const SweepPoint& point) {
    JsonObject object;
    for (const auto& [key, value] : point) object.add(key, value);
    for (const Fact& fact : facts) object.json(fact.key, fact.json);
    fmt::print("{}", object.lines());
}

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

// One scene, at one point of its sweeps.
int check(const CheckChoices& choices, const SceneJob& job, const SweepPoint& point,
          const Telling& telling) {
    const Session session =
        open_session(scene_request_of(job.scene, choices.scene, job.overrides), telling);
    tell_notes(session.scene, telling);
    const Findings findings = examine(session, choices.plan, telling);
    if (choices.json) {
        print_json(findings.facts, point);
    } else {
        if (!point.empty()) fmt::print("{}:\n", printable(in_words(point), any_length));
        print_words(findings);
    }
    return !findings.certificate || findings.certificate->holds() ? 0 : 1;
}

// A sweep prints a blank line between its runs, in JSON an array of them.
int run(const CheckChoices& choices) {
    Progress progress(choices.quiet);
    const Telling telling = progress.telling();
    const std::vector<SweepPoint> points = points_of(choices.sweeps);
    const bool is_array = choices.json && !choices.sweeps.empty();
    if (is_array) fmt::print("[\n");
    int worst = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (k > 0) fmt::print("{}\n", is_array ? "," : "");
        const SceneJob job{choices.scenes.at(0), "", overrides_of(points[k])};
        worst = std::max(worst, check(choices, job, points[k], telling));
    }
    if (is_array) fmt::print("]\n");
    return worst;
}

CommandLine check_line(std::any& room) {
    auto& c = room.emplace<CheckChoices>();
    return {&c.scenes,
            {set_option(c.scene),
             sweep_option(c.sweeps),
             size_option(c.scene),
             fps_option(c.scene),
             quality_option(c.scene),
             json_option(c.json),
             quiet_option(c.quiet),
             {"--plan", "what will be modelled, and why", &c.plan},
             allow_outside_option(c.scene.allow_outside)},
            [&c] { return run(c); }};
}

}  // namespace

extern const Command check_command{
    "check",
    "SCENE",
    1,
    1,
    "validate a scene and say what its motion is",
    check_line,
    {{{"poinsot check my_scene.toml", "is it a scene, and what is its motion?"},
      {"poinsot check generic --plan", "what a film of it models, and why"}}}};

}  // namespace poinsot
