#include "cli/session.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "drawing/reach.h"
#include "error/error.h"
#include "error/nearest.h"
#include "scene/load_scene.h"
#include "scene/scene_error.h"

namespace poinsot {

Session open_session(const Options& options) {
    return session_of(
        load_scene(options.arguments.at(0), options.overrides,
                   options.allow_outside ? OutsideFiles::allowed : OutsideFiles::refused));
}

Session session_of(Scene scene) {
    MotionProblem problem = problem_of(scene);
    const double tolerance_rad = scene.accuracy_px / pixels_per_radian(scene);
    StepChoice step =
        at_scene_key(scene, "motion", [&] { return choose_step(problem, tolerance_rad); });
    if (!step.reached) {
        scene.notes.push_back(fmt::format(
            "{} does not reach accuracy_px = {:g} in a reasonable number of steps; at {} it is off "
            "by {:.2g} px",
            step.method.name, scene.accuracy_px,
            step.method.step_s
                ? fmt::format("step_s = {:.3g}", *step.method.step_s)
                : fmt::format("tolerance = {:.0e}", step.method.tolerance.value_or(0.0)),
            step.attitude_rad * pixels_per_radian(scene)));
    }
    problem.method = step.method;
    Motion motion = at_scene_key(scene, "motion", [&] { return Motion(problem); });
    return {std::move(scene), std::move(step), std::move(motion)};
}

bool can_certify(const Session& session) {
    const MotionProblem& problem = session.motion.problem();
    return std::holds_alternative<NoTorque>(problem.torque) &&
           !problem.start.omega_body.isZero(0.0);
}

Certificate certify_film(const Session& session, const FilmPlan& film) {
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(film.n_frames));
    for (std::int64_t frame = 0; frame < film.n_frames; ++frame) {
        times.push_back(film.time_of(frame));
    }
    // A stepped method promises what the scene's accuracy asks of it.
    const bool stepped = session.motion.integrated() != nullptr;
    const double bound = stepped ? session.scene.accuracy_px / pixels_per_radian(session.scene)
                                 : exact_residual_bound;
    return certify(session.motion, times, bound);
}

std::string text_of(const Certificate& certificate) {
    std::string text;
    for (const CertifiedClaim& claim : certificate.claims) {
        text += fmt::format("{} {}: {:.2e} at t = {:.6g} s (bound {:.0e}): {}\n",
                            claim.holds() ? "holds" : "FAILS", claim.name, claim.worst,
                            claim.at_time_s, claim.bound, claim.means);
    }
    return text + fmt::format("certificate: {} over {} frames\n",
                              certificate.holds() ? "every claim holds" : "a claim FAILS",
                              certificate.n_instants);
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
