// Notes of `check` on a torque-free motion, beyond its constants: whether and when the body
// flips, and which loops are near.
#pragma once

#include <string>
#include <vector>

#include "production/session/scene_summary.h"

namespace poinsot {

// The kind of a motion, for a free body with three different moments after whether it flips: "turns
// over every 13.4 s: polhode about e3, the axis of the smallest moment (elliptic)".
std::string motion_in_words(const Motion& motion);

// The instants within the film at which ω along the middle axis changes its sign, if the body
// flips.
void add_flips(const Session& session, const FilmPlan& film, std::vector<SummaryLine>& lines);

// The values of film.loop that take a small change of the start, unless the film loops already.
void add_near_loops(const Session& session, std::vector<SummaryLine>& lines);

}  // namespace poinsot
