// A film drawn by several processes of this machine: its parts side by side, then joined.
#pragma once

#include <filesystem>
#include <optional>

#include "production/film_job.h"
#include "production/picture.h"
#include "production/session.h"
#include "production/telling.h"

namespace poinsot {

// Makes the film of a request, without a part in it, by so many processes or as many as it has
// chunks; the bytes are those of FilmJob. Not said how many: as many as pay (job_choice.h), or as
// an interrupted run of this film had. Parts wait aside, in a hidden folder beside the film, so
// that an interrupted run of as many processes is gone on with. One process is this one, drawing on
// the easel; more are forked, which where nothing is said is not done once this process has opened
// it. Precondition: no thread of this process runs. Throws InputError and EnvironmentError; then no
// process is left.
void make_in_jobs(const Session& session, const FilmRequest& request, std::optional<int> n_jobs,
                  Easel& easel, const Telling& telling);

// What an interrupted run of several processes has left of a film, as far as it goes without a gap,
// as if one process had left it: what render goes on with and recover makes a film of. Nothing is
// done where there is none, or where one process has left something. Returns how many frames come
// after a gap: these stay where they are, for render. Throws EnvironmentError.
std::int64_t gather_parts_aside(const std::filesystem::path& film);

}  // namespace poinsot
