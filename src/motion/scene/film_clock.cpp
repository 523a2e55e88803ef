#include "scene/film_clock.h"

#include <algorithm>

#include "scene/scene.h"

namespace poinsot {

FilmClock::FilmClock(const Scene& scene)
    : start_s_(scene.film.start_s),
      speed_(scene.film.speed),
      asked_length_s_(scene.film.length_s),
      asked_duration_s_(scene.film.duration_s) {
    for (const KeyframeSpec& key : scene.keyframes) {
        if (key.speed) speed_.add(key.at_s, *key.speed, easing_named(key.easing));
    }
}

double FilmClock::time_at(double film_s) const { return start_s_ + speed_.integral(film_s); }

std::optional<double> FilmClock::film_second_of(double time_s) const {
    const double wanted_s = time_s - start_s_;
    const double until_last_key_s = speed_.integral(speed_.last_key_s());
    if (wanted_s <= 0.0) {
        if (speed_.first_value() > 0.0) return wanted_s / speed_.first_value();
        return wanted_s == 0.0 ? std::optional(0.0) : std::nullopt;
    }
    if (wanted_s > until_last_key_s) {
        if (!(speed_.last_value() > 0.0)) return std::nullopt;
        return speed_.last_key_s() + (wanted_s - until_last_key_s) / speed_.last_value();
    }

    // The integral never decreases; where it is constant, the first second is returned. Bisection
    // ends when no double lies between.
    double before_s = 0.0;
    double after_s = speed_.last_key_s();
    while (true) {
        const double middle_s = 0.5 * (before_s + after_s);
        if (middle_s <= before_s || middle_s >= after_s) return after_s;
        (speed_.integral(middle_s) < wanted_s ? before_s : after_s) = middle_s;
    }
}

std::optional<double> FilmClock::length_s() const {
    if (asked_length_s_) return asked_length_s_;
    if (!asked_duration_s_) return default_film_s;
    // With constant speed the quotient is used: it is exact more often than a search.
    if (!speed_.moves() && speed_.first_value() > 0.0) {
        return *asked_duration_s_ / speed_.first_value();
    }
    return film_second_of(start_s_ + *asked_duration_s_);
}

FilmTime moment_of_time(const FilmClock& clock, double time_s) {
    if (const auto film_s = clock.film_second_of(time_s)) return {time_s, *film_s};
    // Not in the film: before its first frame, or after the speed has fallen to 0.
    const bool before = time_s < clock.time_at(0.0);
    return {time_s, before ? -1.0 : clock.length_s().value_or(default_film_s)};
}

double film_end_time_s(const Scene& scene) {
    const FilmClock clock(scene);
    if (scene.film.duration_s && !scene.film.length_s) {
        return scene.film.start_s + *scene.film.duration_s;
    }
    return clock.time_at(clock.length_s().value_or(0.0));
}

std::pair<double, double> caption_span(const Scene& scene, std::size_t caption) {
    const TimedCaptionSpec& spec = scene.captions.at(caption);
    double end_s = FilmClock(scene).length_s().value_or(default_film_s);
    if (spec.over_s) {
        end_s = spec.at_s + *spec.over_s;
    } else {
        for (const TimedCaptionSpec& other : scene.captions) {
            if (other.place == spec.place && other.at_s > spec.at_s) {
                end_s = std::min(end_s, other.at_s);
                break;
            }
        }
    }
    return {spec.at_s, end_s};
}

}  // namespace poinsot
