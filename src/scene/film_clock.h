// Which instant of the motion each second of the film shows: the exact integral of its speed.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "scene/track.h"

namespace poinsot {

struct Scene;

// An instant on both clocks.
struct FilmMoment {
    double time_s = 0.0;  // of the motion
    double film_s = 0.0;  // of the film, from its first frame
};

class FilmClock {
 public:
    explicit FilmClock(const Scene& scene);

    // The motion's time at a second of the film. Slow motion loses nothing: it is the closed form
    // of the integral, and never accumulated.
    double time_at(double film_s) const;

    // The first second of the film that shows an instant of the motion; beyond what the speed ever
    // reaches, none.
    std::optional<double> film_second_of(double time_s) const;

    // Length of the film in seconds of film; none if the speed ends at 0 before film.duration_s of
    // the motion have passed.
    std::optional<double> length_s() const;

    // Seconds of motion a second of film.
    double speed_at(double film_s) const { return speed_.at(film_s); }

 private:
    double start_s_;
    Track speed_;
    std::optional<double> asked_length_s_, asked_duration_s_;
};

// Where the film's clock says that an instant of the motion is shown; where it is not, a second
// before the film or after it that keeps the order.
FilmMoment moment_of_time(const FilmClock& clock, double time_s);

// The motion's time at the end of the film, or its start where there is no end.
double film_end_time_s(const Scene& scene);

// The seconds of the film between which one of [[captions]] stands: until its own end, the next one
// of its place, or the film's end.
std::pair<double, double> caption_span(const Scene& scene, std::size_t caption);

}  // namespace poinsot
