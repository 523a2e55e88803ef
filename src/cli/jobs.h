// The two jobs that draw, for commands that begin with a scene and for the one that begins with a
// record.
#pragma once

#include "cli/options.h"
#include "cli/picture.h"
#include "cli/session.h"

namespace poinsot {

// One picture, at options.time_s. Returns the exit code. Throws InputError, EnvironmentError.
int make_still(const Session& session, const Options& options, Easel& easel);

// A film or sequence, all of it or options.frames.
int make_film(const Session& session, const Options& options, Easel& easel);

}  // namespace poinsot
