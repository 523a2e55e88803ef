#include "production/session/film_plan.h"

#include <algorithm>
#include <cmath>

namespace poinsot {

FilmTime FilmPlan::moment_of(std::int64_t frame) const {
    const double film_s =
        repeat_s > 0.0
            ? length_s * (static_cast<double>(frame) / static_cast<double>(n_frames))
            : static_cast<double>(frame * rate.denominator) / static_cast<double>(rate.numerator);
    return {clock.time_at(film_s), film_s};
}

std::int64_t FilmPlan::frame_at(double film_s) const {
    constexpr double rounding = 1e-9;
    std::int64_t before = -1;
    std::int64_t after = n_frames;
    while (after - before > 1) {
        const std::int64_t middle = before + (after - before) / 2;
        (moment_of(middle).film_s < film_s - rounding ? before : after) = middle;
    }
    return after;
}

FilmPlan film_plan(const ResolvedScene& resolved) {
    const Scene& scene = resolved.scene;
    FilmPlan plan{.rate = {scene.film.fps_numerator, scene.film.fps_denominator},
                  .start_s = scene.film.start_s,
                  .clock = FilmClock(scene)};
    plan.length_s = plan.clock.length_s().value_or(default_film_s);
    plan.repeat_s = resolved.loop ? resolved.loop->repeat_s : 0.0;
    plan.n_frames = std::max<std::int64_t>(1, std::llround(plan.length_s * plan.rate.per_second()));
    return plan;
}

}  // namespace poinsot
