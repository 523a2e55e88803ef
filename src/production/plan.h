// What a scene will have modelled, and why: the answer of `check --plan`.
#pragma once

#include <string>
#include <vector>

#include "drawing/stage.h"
#include "production/session.h"

namespace poinsot {

struct PlanLine {
    std::string what;      // "attitude"
    std::string decision;  // "once a frame"
    std::string why;
};

// From the motion's regime, from what the panels ask of each instant, and from what the stage has
// evaluated.
std::vector<PlanLine> plan_of(const Session& session, const FilmPlan& film, const Stage& stage);

}  // namespace poinsot
