// The instants of a film's frames.
#pragma once

#include <cstdint>

#include "image/frame_rate.h"
#include "production/session/resolve.h"
#include "scene/film_clock.h"

namespace poinsot {

// The instants of a film. Frame k shows second k/fps of it, computed from the ratio without
// accumulation; the scene's clock maps this second to an instant of the motion. The frames of a
// loop divide it evenly, so that the frame after the last is the first.
struct FilmPlan {
    FrameRate rate;
    double start_s = 0.0;
    FilmClock clock;
    double length_s = 0.0;      // of the film
    double repeat_s = 0.0;      // of the motion, after which the picture repeats; 0: no loop
    std::int64_t n_frames = 0;  // of the whole film

    FilmTime moment_of(std::int64_t frame) const;
    double time_of(std::int64_t frame) const { return moment_of(frame).time_s; }
    // The first frame at or after a second of the film; n_frames if there is none.
    std::int64_t frame_at(double film_s) const;
    double last_time_s() const { return n_frames > 0 ? time_of(n_frames - 1) : start_s; }
};

FilmPlan film_plan(const ResolvedScene& resolved);

}  // namespace poinsot
