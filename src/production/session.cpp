#include "production/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/charts/chart_fit.h"
#include "drawing/idle_keys.h"
#include "drawing/theme_contrast.h"
#include "drawing/type/overlay.h"
#include "error/error.h"
#include "mechanics/methods.h"
#include "production/print_size.h"
#include "production/slow_work_notice.h"
#include "scene/scene_error.h"
#include "scene/scene_keys.h"
#include "text/printable.h"

namespace poinsot {

namespace {

void note_unreached(const Accuracy& accuracy, const StepChoice& step, Scene& scene) {
    const bool given = scene.method.step_s || scene.method.tolerance;
    if (step.reached || given) return;
    scene.notes.push_back(fmt::format(
        "{} does not reach accuracy_px = {:g} in a reasonable number of steps; with {} its error "
        "is {:.2g} px",
        step.method.name, accuracy.asked_px,
        step.method.step_s ? fmt::format("step_s = {:.3g}", *step.method.step_s)
                           : fmt::format("tolerance = {:.0e}", step.method.tolerance.value_or(0.0)),
        step.attitude_rad * accuracy.px_per_rad));
}

// The key to which an error of the mechanics refers.
std::string key_of(const std::string& table, const MethodChoice& choice) {
    if (choice.step_s) return table + ".step_s";
    return choice.tolerance ? table + ".tolerance" : table;
}

void extend(MotionProblem& problem, std::span<const double> times_s) {
    for (const double time_s : times_s) {
        if (!std::isfinite(time_s)) continue;  // reported by name where it is used
        problem.first_time_s = std::min(problem.first_time_s, time_s);
        problem.last_time_s = std::max(problem.last_time_s, time_s);
    }
}

// Sets the scene's size in pixels from a size on paper; the other options are used when the picture
// is made.
void set_size_on_paper(const SceneRequest& request, Scene& scene) {
    const auto paper = print_size_of(request.print, scene.film.width_px, scene.film.height_px);
    if (!paper) return;
    const bool sized_twice = std::any_of(
        request.overrides.begin(), request.overrides.end(),
        [](const std::string& given) { return assignment_of(given).starts_with("film.size="); });
    if (sized_twice && (request.print.width_mm || request.print.height_mm))
        throw InputError(
            "--size and --width-mm or --height-mm both set the picture's size; leave one out");
    scene.film.width_px = paper->width_px;
    scene.film.height_px = paper->height_px;
    if (!request.print.width_mm || request.print.height_mm) return;
    // The figure keeps the scene's aspect ratio; title, caption and charts add rows, since their
    // text has a fixed size in points.
    const double px = paper->line_scale;
    int& height_px = scene.film.height_px;
    height_px += rows_added_by_type(scene, paper->width_px, px, paper->least);
    const int room_px = height_px - rows_of_overlays(scene, paper->width_px, px, paper->least);
    height_px += rows_added_by_charts(scene, paper->width_px, room_px, px, paper->least);
}

bool steps(const MethodChoice& choice) {
    const auto rows = methods();
    return std::any_of(rows.begin(), rows.end(), [&](const Method& method) {
        return method.name == choice.name && method.make != nullptr;
    });
}

// What stepping over a problem's span takes, found before it is done.
struct SteppingPlan {
    bool steps = false;
    double estimate_s = 0.0;  // 0: the step is not chosen yet
};

// Estimated seconds for stepping n_times. Throws InputError if it exceeds the limit.
double affordable_s(const MotionProblem& problem, double n_times) {
    const double estimate_s = n_times * stepping_estimate_s(problem);
    if (estimate_s <= longest_stepping_s) return estimate_s;
    throw InputError(fmt::format(
        "stepping by {} from {:g} s to {:g} s{} would take about {} s, longer than the limit of "
        "{:.0f} s; give a larger step or tolerance, a shorter film, or method = \"exact\"",
        problem.method.name, problem.first_time_s, problem.last_time_s,
        problem.method.step_s ? fmt::format(" in steps of {:g} s", *problem.method.step_s) : "",
        estimate_s < 1e9 ? fmt::format("{:.0f}", estimate_s) : fmt::format("{:.0e}", estimate_s),
        longest_stepping_s));
}

SteppingPlan stepping_plan(const MotionProblem& problem) {
    SteppingPlan plan;
    const Method& method = check_method(problem.method, problem.inertia, problem.torque);
    plan.steps = method.make != nullptr && problem.first_time_s < problem.last_time_s;
    if (!plan.steps) return plan;
    // Without an exact motion to compare with, the error of a step is measured by halving it.
    const bool has_truth = can_solve(find_method("exact"), problem.inertia, problem.torque);
    if (problem.method.step_s || problem.method.tolerance || problem.start.omega_body.isZero(0.0)) {
        plan.estimate_s = affordable_s(problem, has_truth ? 2.0 : 4.0);
        return plan;
    }
    // The coarsest step, its half, and the chosen motion. A time estimate may reject a scene; it
    // never chooses the step.
    MotionProblem rung = problem;
    rung.method = coarsest_choice(problem);
    affordable_s(rung, has_truth ? 3.0 : 5.0);
    return plan;
}

// Adds notes about keys without effect, about styles that make colours indistinguishable, and about
// units in captions.
void note_idle_keys(Scene& scene) {
    for (const auto& [key, why] : idle_keys(scene))
        scene.notes.push_back(fmt::format("{}{} changes nothing: {}", scene.where(key), key, why));
    for (std::string& note : contrast_notes(scene)) scene.notes.push_back(std::move(note));
    for (std::string& note : caption_notes(scene)) scene.notes.push_back(std::move(note));
}

}  // namespace

Session open_session(const SceneRequest& request, const ProgressSink& progress) {
    Scene scene = load_scene(request.file, request.overrides, request.outside);
    set_size_on_paper(request, scene);
    return session_of(std::move(scene), request.times_s, progress);
}

Session session_of(Scene scene, std::span<const double> times_s, const ProgressSink& progress) {
    note_idle_keys(scene);
    std::optional<Loop> loop = resolve_loop(scene);
    MotionProblem problem = problem_of(scene);
    extend(problem, times_s);
    // The trails of a loop include the motion before its start.
    if (loop)
        problem.first_time_s = std::min(problem.first_time_s, scene.film.start_s - loop->loop_s);
    problem.overshoot_s = overshoot_s(problem);
    const Accuracy accuracy = accuracy_of(scene);
    const std::string key = key_of("motion", scene.method);
    // Before the estimate, which steps as well.
    std::optional<SlowWorkNotice> notice;
    if (steps(scene.method) || (scene.beside && steps(*scene.beside)))
        notice.emplace(fmt::format("{}: stepping the motion", printable(scene.name, 40)), progress,
                       longest_stepping_s);
    const std::stop_token stop = notice ? notice->token() : std::stop_token();
    SteppingPlan plan = at_key_of_error(scene, key, "film", [&] { return stepping_plan(problem); });
    if (scene.beside) {
        MotionProblem other = problem;
        other.method = *scene.beside;
        plan.estimate_s += at_key_of_error(scene, key_of("beside", *scene.beside), "film",
                                           [&] { return affordable_s(other, 1.0); });
    }
    if (notice) notice->expect(plan.estimate_s);
    StepChoice step = at_key_of_error(scene, key, "film", [&] {
        return choose_step(problem, accuracy.motion_rad(), most_chosen_steps, stop);
    });
    note_unreached(accuracy, step, scene);
    problem.method = step.method;
    // What a closed form refuses is its start.
    Motion motion = at_key_of_error(scene, plan.steps ? key : "start", "film",
                                    [&] { return Motion(problem, stop); });

    std::optional<Motion> comparison;
    if (scene.beside) {
        problem.method = *scene.beside;
        comparison = at_key_of_error(scene, key_of("beside", *scene.beside), "film",
                                     [&] { return Motion(problem, stop); });
    }
    return {std::move(scene),      accuracy,       std::move(step), std::move(motion),
            std::move(comparison), std::move(loop)};
}

void throw_at_key(const Scene& scene, const std::string& key, const std::string& time_key,
                  const InputError& error) {
    const std::string_view what = error.what();
    const std::string_view named = what.substr(0, what.find(':'));
    if (named == "time_s") throw SceneError(scene.location_of(time_key), what);
    const std::string of_start = fmt::format("start.{}", named);
    const bool is_of_start = find_scene_key(of_start) != nullptr;
    throw SceneError(scene.location_of(is_of_start ? of_start : key), what);
}

double motion_error_px(const Session& session) {
    const bool stepped = session.motion.integrated() != nullptr;
    return (stepped ? session.step.attitude_rad : exact_residual_bound) *
           session.accuracy.px_per_rad;
}

bool can_certify(const Session& session) {
    const MotionProblem& problem = session.motion.problem();
    return std::holds_alternative<NoTorque>(problem.torque) &&
           !problem.start.omega_body.isZero(0.0);
}

Certificate certify_film(const Session& session, const FilmPlan& film,
                         const ProgressSink& progress) {
    std::optional<SlowWorkNotice> notice;
    constexpr std::int64_t many = 100'000;
    if (film.n_frames >= many)
        notice.emplace(fmt::format("{}: certifying {} frames", printable(session.scene.name, 40),
                                   film.n_frames),
                       progress);
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(film.n_frames));
    for (std::int64_t frame = 0; frame < film.n_frames; ++frame) {
        times.push_back(film.time_of(frame));
    }
    // A stepped method promises what the scene's accuracy asks of it, a closed form its rounding.
    const bool stepped = session.motion.integrated() != nullptr;
    const double bound = stepped ? session.accuracy.motion_rad() : exact_residual_bound;
    return certify(session.motion, times, bound);
}

std::string text_of(const Certificate& certificate) {
    std::string text;
    bool all_measured = true;
    for (const CertifiedClaim& claim : certificate.claims) {
        all_measured = all_measured && claim.measured();
        if (!claim.measured()) {
            text += fmt::format(
                "not measured {}: double precision is too coarse at such large times: {}\n",
                claim.name, claim.means);
            continue;
        }
        const std::string part =
            claim.n_measured < certificate.n_instants
                ? fmt::format(", over {} of {} frames", claim.n_measured, certificate.n_instants)
                : "";
        text += fmt::format("{} {}: {:.2e} at t = {:.6g} s (bound {:.0e}{}): {}\n",
                            claim.holds() ? "holds" : "FAILS", claim.name, claim.worst,
                            claim.at_time_s, claim.bound, part, claim.means);
    }
    return text + fmt::format("certificate: {} over {} frames\n",
                              !certificate.holds() ? "a claim FAILS"
                              : all_measured       ? "every claim holds"
                                                   : "every claim that was measured holds",
                              certificate.n_instants);
}

FilmTime FilmPlan::moment_of(std::int64_t frame) const {
    const double film_s =
        loop_s > 0.0
            ? length_s * (static_cast<double>(frame) / static_cast<double>(n_frames))
            : static_cast<double>(frame * rate.denominator) / static_cast<double>(rate.numerator);
    return {clock.time_at(film_s), film_s};
}

FilmPlan film_plan(const Session& session) {
    const Scene& scene = session.scene;
    FilmPlan plan{.rate = {scene.film.fps_numerator, scene.film.fps_denominator},
                  .start_s = scene.film.start_s,
                  .clock = FilmClock(scene)};
    plan.length_s = plan.clock.length_s().value_or(default_film_s);
    plan.loop_s = session.loop ? session.loop->loop_s : 0.0;
    plan.n_frames = std::max<std::int64_t>(1, std::llround(plan.length_s * plan.rate.per_second()));
    return plan;
}

void tell_notes(const Scene& scene, const ProgressSink& progress) {
    for (const std::string& note : scene.notes) progress.say("note: " + printable(note));
}

}  // namespace poinsot
