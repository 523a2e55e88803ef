// Maps seconds of the film to instants of the motion: the exact integral of the film's speed.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "scene/track.h"

namespace poinsot {

struct Scene;

// An instant as the time of the motion and the time of the film.
struct FilmTime {
    double time_s = 0.0;  // of the motion
    double film_s = 0.0;  // of the film, from its first frame
};

class FilmClock {
 public:
    explicit FilmClock(const Scene& scene);

    // Returns the motion's time at a second of the film: the closed form of the integral, not a
    // running sum, so that slow motion loses no accuracy.
    double time_at(double film_s) const;

    // Returns the first second of the film that shows an instant of the motion; none if the film
    // never reaches it.
    std::optional<double> film_second_of(double time_s) const;

    // Length of the film in seconds of film; none if the speed falls to 0 before film.duration_s of
    // the motion have passed.
    std::optional<double> length_s() const;

    // Speed: seconds of motion per second of film.
    double speed_at(double film_s) const { return speed_.at(film_s); }

 private:
    double start_s_;
    Track speed_;
    std::optional<double> asked_length_s_, asked_duration_s_;
};

// Returns the film time at which an instant of the motion is shown; if it is not shown, a time
// before or after the film that keeps the order of instants.
FilmTime moment_of_time(const FilmClock& clock, double time_s);

// The motion's time at the end of the film, or at its start if the film has no end.
double film_end_time_s(const Scene& scene);

// The seconds of the film between which one of [[captions]] is shown: until its own end, the next
// caption of its place, or the film's end.
std::pair<double, double> caption_span(const Scene& scene, std::size_t caption);

}  // namespace poinsot
