// How a recorded still is drawn again.
#pragma once

#include "production/records/record.h"
#include "production/session/session.h"
#include "production/stills/prepared_still.h"

namespace poinsot {

// The request that drew the still, but for its file, the backend and chosen views.
StillRequest request_of(const Record& record);

// What its session needs.
SessionRequest needs_of(const Record& record);

}  // namespace poinsot
