// The request of a still, as the command line and the library make it.
#pragma once

#include "production/session/files/open_session.h"
#include "production/session/progress_sink.h"
#include "production/stills/prepared_still.h"

namespace poinsot {

// The scene of a still, and the still with all that follows from its choices: what a journal asks
// for, the instant that a stepped motion must cover, and the dots per inch of vectors, which are
// for paper with or without a size on it.
struct StillOrder {
    SceneRequest scene;
    StillRequest still;
};

// `keeps_text`: title, captions and clock, which a journal's figure does without. Throws
// InputError.
StillOrder still_order(SceneRequest scene, StillRequest still, bool keeps_text,
                       const ProgressSink& progress);

}  // namespace poinsot
