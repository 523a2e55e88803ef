// Draws a film in several processes on this machine: in parts, which are then joined.
#pragma once

#include <filesystem>
#include <optional>

#include "production/films/film_job.h"
#include "production/session/session.h"
#include "production/session/task.h"
#include "production/stills/picture.h"

namespace poinsot {

// Makes the film of a request, which must not be for a part, in `n_jobs` processes, limited to the
// number of its chunks; the result is byte-identical to FilmJob's. Default: the number that is
// fastest (job_choice.h), or that of an interrupted run of this film. Parts are stored in a hidden
// folder beside the film, so that an interrupted run with the same number continues. A single
// process is this one, which draws on the renderer; several are forked, by default only if the
// renderer is not open. Precondition: this process has no other threads. Throws InputError and
// EnvironmentError; then no child process is left.
void make_in_jobs(const Session& session, const FilmRequest& request, std::optional<int> n_jobs,
                  LazyRenderer& renderer, const Task& task);

// Converts the state that an interrupted run of several processes left of a film, up to the first
// gap, to that of a single process, from which render continues and recover makes a film. Does
// nothing if there is no such state, or if a single process left one. Returns the number of frames
// after a gap: these stay in place, for render. Throws EnvironmentError.
std::int64_t gather_parts_aside(const std::filesystem::path& film);

}  // namespace poinsot
