// A scene's motion compared with its measured one: residuals, drift, gaps and saturation.
#pragma once

#include <vector>

#include "production/session/scene_summary.h"

namespace poinsot {

// Adds lines for the rows between these times. Precondition: the scene has a measured motion, and
// the motion reaches these times.
void add_measured(const Session& session, double first_s, double last_s,
                  std::vector<SummaryLine>& lines);

}  // namespace poinsot
