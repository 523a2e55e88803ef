// The request of a still, as the command line and the library make it.
#pragma once

#include <string>

#include "orders/options.h"
#include "production/session/files/open_session.h"
#include "production/session/task.h"
#include "production/stills/prepared_still.h"

namespace poinsot {

// The scene of a still, and the still with all that follows from its choices: what a journal asks
// for, the instant that a stepped motion must cover, and the dots per inch of vectors, which are
// for paper with or without a size on it.
struct StillOrder {
    SceneRequest scene;
    StillRequest still;
};

// Throws InputError.
StillOrder still_order(SceneRequest scene, const GivenOptions& given, const std::string& output,
                       const Task& task);

}  // namespace poinsot
