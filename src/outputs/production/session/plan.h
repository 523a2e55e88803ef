// The computations for a scene, with their reasons: the output of `check --plan`.
#pragma once

#include <string>
#include <vector>

#include "drawing/stage/stage.h"
#include "production/session/session.h"

namespace poinsot {

struct PlanLine {
    std::string what;      // "attitude"
    std::string decision;  // "once a frame"
    std::string why;
};

// The plan from the kind of motion, the quantities that the panels read, and the evaluations that
// the stage has made.
std::vector<PlanLine> plan_of(const Session& session, const FilmPlan& film, const Stage& stage);

}  // namespace poinsot
