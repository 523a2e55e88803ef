#include "cli/session.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "error/error.h"
#include "error/nearest.h"
#include "scene/load_scene.h"

namespace poinsot {

Session open_session(const Options& options) {
    Scene scene = load_scene(options.arguments.at(0), options.overrides);
    Motion motion(problem_of(scene));
    return {std::move(scene), std::move(motion)};
}

double FilmPlan::time_of(std::int64_t frame) const {
    const double seconds =
        static_cast<double>(frame * rate.denominator) / static_cast<double>(rate.numerator);
    return start_s + seconds * speed;
}

FilmPlan film_plan(const Scene& scene, const Motion&) {
    FilmPlan plan;
    plan.rate = {scene.film.fps_numerator, scene.film.fps_denominator};
    plan.start_s = scene.film.start_s;
    plan.speed = scene.film.speed;

    const double film_s = scene.film.duration_s.value_or(default_film_s * plan.speed) / plan.speed;
    plan.n_frames = std::max<std::int64_t>(1, std::llround(film_s * plan.rate.per_second()));
    return plan;
}

void print_notes(const Scene& scene, bool quiet) {
    if (quiet) return;
    for (const std::string& note : scene.notes) fmt::print(stderr, "note: {}\n", printable(note));
}

}  // namespace poinsot
