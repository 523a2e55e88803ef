// What can be said of a scene without drawing it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "construction/certificate.h"
#include "production/plan.h"
#include "production/session.h"

namespace poinsot {

// One line of the answer: a key for JSON, words for people.
struct Fact {
    std::string key;
    std::string json;
    std::string label;
    std::string text;
};

struct Findings {
    std::vector<Fact> facts;
    std::optional<Certificate> certificate;  // of torque-free bodies that turn
    std::vector<PlanLine> plan;              // what will be modelled and why, if it was asked for
};

// Makes the stage, too: whether a scene can be drawn is part of it, and opens no context. Throws
// InputError.
Findings examine(const Session& session, bool plan, const Telling& telling = {});

}  // namespace poinsot
