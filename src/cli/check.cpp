// poinsot check SCENE: validates without drawing and says what the motion is and what will be
// modelled.
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "production/findings.h"
#include "text/json_text.h"
#include "text/printable.h"

namespace poinsot {

namespace {

struct CheckChoices {
    std::vector<std::string> scenes;
    SceneOptions scene;
    bool json = false, plan = false, quiet = false;
};

void print_json(const std::vector<Fact>& facts) {
    fmt::print("{{\n");
    for (std::size_t i = 0; i < facts.size(); ++i)
        fmt::print("  {}: {}{}\n", json_string(facts[i].key), facts[i].json,
                   i + 1 < facts.size() ? "," : "");
    fmt::print("}}\n");
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

int run(const CheckChoices& choices) {
    Progress progress(choices.quiet);
    const Telling telling = progress.telling();
    const Session session = open_session(scene_request_of(choices.scenes.at(0), choices.scene),
                                         Purpose::pictures, telling);
    tell_notes(session.scene, telling);
    const Findings findings = examine(session, choices.plan, telling);
    if (choices.json)
        print_json(findings.facts);
    else
        print_words(findings);
    return !findings.certificate || findings.certificate->holds() ? 0 : 1;
}

CommandLine line(std::any& room) {
    auto& c = room.emplace<CheckChoices>();
    return {&c.scenes,
            {set_option(c.scene),
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

const Command check_command{
    "check",
    "SCENE",
    1,
    1,
    "validate a scene and say what its motion is",
    line,
    {{{"poinsot check my_scene.toml", "is it a scene, and what is its motion?"},
      {"poinsot check generic --plan", "what a film of it models, and why"}}}};

}  // namespace poinsot
