// A film drawn by several processes of this machine: its parts side by side, then joined.
#pragma once

#include "production/film_job.h"
#include "production/picture.h"
#include "production/session.h"
#include "production/telling.h"

namespace poinsot {

// Makes the film of a request, without a part in it, by so many processes or as many as it has
// chunks; the bytes are those of FilmJob. Parts wait aside, in a hidden folder beside the film, so
// that an interrupted run of as many processes is gone on with. Forks, so nothing may have been
// drawn by this process and no thread of its own may run. Throws InputError and EnvironmentError;
// then no process is left.
void make_in_jobs(const Session& session, const FilmRequest& request, int n_jobs,
                  const ContextChoice& context, const Telling& telling);

}  // namespace poinsot
