// The two jobs that draw, for commands that begin with a scene and for the one that begins with a
// record.
#pragma once

#include <cstdint>

#include "cli/options.h"
#include "production/picture.h"
#include "production/session.h"
#include "production/still_writer.h"

namespace poinsot {

// One picture, at options.time_s or where the scene says, ready to be drawn. Any thread may make
// it.
class Still {
 public:
    // Throws InputError.
    Still(Session&& session, const Options& options);
    Still(const Still&) = delete;
    Still& operator=(const Still&) = delete;

    std::int64_t n_pixels() const;
    // Draws it; the writer may still have it in hand. Throws InputError, EnvironmentError, and what
    // the writer throws of an earlier one.
    void draw(Easel& easel, StillWriter& writer);

 private:
    Session session_;
    Options options_;
    FilmMoment moment_;
    Staging staging_;
};

// A film or sequence, all of it or options.frames. Of a film the first n_shown of those frames may
// be asked for, with the bytes of a run that was interrupted after them; 0: all.
int make_film(const Session& session, const Options& options, Easel& easel,
              std::int64_t n_shown = 0);

}  // namespace poinsot
