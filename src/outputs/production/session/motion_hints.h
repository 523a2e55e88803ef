// Notes of `check` on a torque-free motion, beyond its constants: whether and when the body
// flips, and which loops are near.
#pragma once

#include <string>
#include <vector>

#include "production/session/scene_summary.h"

namespace poinsot {

// The kind of a motion, for a free body with three different moments after whether it flips: "turns
// over every 13.4 s: polhode about e3, the axis of the smallest moment (elliptic); e2 swings from
// 15.9° to 164.1° from L, and e3 stays within 74.1° of L".
std::string motion_in_words(const Motion& motion);

// The instants within the film at which ω along the middle axis changes its sign, if the body
// flips.
void add_flips(const Session& session, const FilmPlan& film, std::vector<SummaryLine>& lines);

// T at the film's end and how much of it was lost or gained, and the flips within the film, of a
// motion under a torque.
void add_stepped_motion(const Session& session, const FilmPlan& film,
                        std::vector<SummaryLine>& lines);

// The values of film.loop that take a small change of the start, unless the film loops already.
void add_near_loops(const Session& session, std::vector<SummaryLine>& lines);

}  // namespace poinsot
