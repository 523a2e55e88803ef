// Properties of a scene that are known without drawing it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "construction/certificate.h"
#include "production/session/plan.h"
#include "production/session/session.h"

namespace poinsot {

// One line of the report: a key for JSON and a text for people.
struct SummaryLine {
    std::string key;
    std::string json;
    std::string label;
    std::string text;
};

struct SceneSummary {
    std::vector<SummaryLine> lines;
    std::optional<Certificate> certificate;  // of torque-free rotating bodies
    std::vector<PlanLine> plan;              // what will be computed and why, if requested
};

// Computes the lines of a session. It also makes the stage, to check that the scene can be drawn;
// this opens no context. Throws InputError.
SceneSummary summarise(const Session& session, bool plan, const Task& task = {});

}  // namespace poinsot
