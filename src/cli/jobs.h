// The two jobs that draw, for commands that begin with a scene and for the one that begins with a
// record.
#pragma once

#include "cli/options.h"
#include "cli/picture.h"
#include "cli/session.h"
#include "cli/still_writer.h"

namespace poinsot {

// One picture, at options.time_s, which the writer may still have in hand. Returns the exit code.
// Throws InputError, EnvironmentError, and what the writer throws of an earlier one.
int make_still(const Session& session, const Options& options, Easel& easel, StillWriter& writer);

// A film or sequence, all of it or options.frames.
int make_film(const Session& session, const Options& options, Easel& easel);

}  // namespace poinsot
