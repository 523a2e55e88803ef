// The instant that a still shows.
#pragma once

#include <optional>

#include "production/session/session.h"

namespace poinsot {

// Where nobody asks for an instant.
enum class StillTime {
    of_scene,  // film.still_s, or else the clearest
    clearest,  // the film's instant at which the arrows are farthest apart, whatever film.still_s
               // is
    common     // film.still_s, or else the film's last: the same for scenes that are compared
};

// `time_s`: the instant asked for by --time. Throws InputError where the motion fails.
FilmTime still_moment(const Session& session, const std::optional<double>& time_s, StillTime when);

// The one of 64 frames, evenly spread over the film, whose closest two arrows are farthest apart in
// the picture; the last of those where all are clearly apart. It does not depend on the picture's
// size. Throws as a stage of the film does.
FilmTime clearest_moment(const Session& session);

}  // namespace poinsot
