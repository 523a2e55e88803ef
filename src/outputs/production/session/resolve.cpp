#include "production/session/resolve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/figures/panels/idle_keys.h"
#include "drawing/figures/panels/scene_names.h"
#include "drawing/stage/overlay.h"
#include "drawing/style/theme_contrast.h"
#include "error/error.h"
#include "mechanics/methods.h"
#include "mechanics/motion.h"
#include "production/session/paper_layout.h"
#include "production/session/stepping_estimate.h"
#include "scene/scene_keys.h"
#include "scene/write_scene.h"

namespace poinsot {

namespace {

void note_unreached(ResolvedScene& resolved) {
    const MethodChoice& asked = resolved.scene.method;
    const StepChoice& step = resolved.step;
    if (step.reached || asked.step_s || asked.tolerance) return;
    resolved.notes.push_back(fmt::format(
        "{} does not reach accuracy_px = {:g} in a reasonable number of steps; with {} its error "
        "is {:.2g} px",
        step.method.name, resolved.accuracy.asked_px,
        step.method.step_s ? fmt::format("step_s = {:.3g}", *step.method.step_s)
                           : fmt::format("tolerance = {:.0e}", step.method.tolerance.value_or(0.0)),
        step.attitude_rad * resolved.accuracy.px_per_rad));
}

void extend(MotionProblem& problem, std::span<const double> times_s) {
    for (const double time_s : times_s) {
        if (!std::isfinite(time_s)) continue;  // reported by name where it is used
        problem.first_time_s = std::min(problem.first_time_s, time_s);
        problem.last_time_s = std::max(problem.last_time_s, time_s);
    }
}

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

// Estimated seconds for stepping over a problem's span, found before it is done; 0: it is not
// stepped, or the step is not chosen yet. Throws InputError as affordable_s does.
double estimated_s(const MotionProblem& problem) {
    const Method& method = check_method(problem.method, problem.inertia, problem.torque);
    if (method.make == nullptr || !(problem.first_time_s < problem.last_time_s)) return 0.0;
    // Without an exact motion to compare with, the error of a step is measured by halving it.
    const bool has_truth = can_solve(find_method("exact"), problem.inertia, problem.torque);
    if (problem.method.step_s || problem.method.tolerance || problem.start.omega_body.isZero(0.0))
        return affordable_s(problem, has_truth ? 2.0 : 4.0);
    // The coarsest step, its half, and the chosen motion. A time estimate may reject a scene; it
    // never chooses the step.
    MotionProblem rung = problem;
    rung.method = coarsest_choice(problem);
    affordable_s(rung, has_truth ? 3.0 : 5.0);
    return 0.0;
}

// A problem that covers the start alone.
MotionProblem at_start_of(MotionProblem problem) {
    problem.first_time_s = problem.last_time_s = problem.start.time_s;
    problem.overshoot_s = 0.0;
    return problem;
}

// Notes about keys without effect, about styles that make colours indistinguishable, and about
// units in captions.
std::vector<std::string> notes_about(const Scene& scene, const Theme& theme) {
    std::vector<std::string> notes;
    for (const auto& [key, why] : idle_keys(scene))
        notes.push_back(fmt::format("{}{} changes nothing: {}", scene.where(key), key, why));
    for (std::string& note : contrast_notes(scene, theme)) notes.push_back(std::move(note));
    for (std::string& note : caption_notes(scene)) notes.push_back(std::move(note));
    return notes;
}

}  // namespace

ResolvedScene resolve(const Scene& given, const SessionRequest& request,
                      const SteppingWatch& watch) {
    ResolvedScene resolved;
    Scene& scene = resolved.scene = given;
    std::vector<std::string> paper_notes;
    lay_out_on_paper(request.print, request.fonts, scene, paper_notes);
    resolved.theme = theme_of(scene);
    resolved.notes = notes_about(scene, resolved.theme);
    resolved.notes.insert(resolved.notes.end(), paper_notes.begin(), paper_notes.end());
    resolved.loop = resolve_loop(scene, resolved.notes);
    resolved.as_read = values_replaced(given, scene);
    resolved.accuracy = accuracy_of(scene);

    const MotionProblem problem = problem_of(resolved, request.times_s);
    const std::string key = key_of("motion", scene.method);
    // Stepping may take long, and a wrong name is known without it.
    if (request.draws && (is_stepped(scene.method) || scene.beside))
        at_key_of_error(scene, key, "film", [&] {
            check_scene_names(scene, resolved.theme, Motion(at_start_of(problem)));
        });
    double estimate_s = at_key_of_error(scene, key, "film", [&] { return estimated_s(problem); });
    if (scene.beside) {
        MotionProblem other = problem;
        other.method = *scene.beside;
        estimate_s += at_key_of_error(scene, key_of("beside", *scene.beside), "film",
                                      [&] { return affordable_s(other, 1.0); });
    }
    watch.expect(estimate_s);
    resolved.step = at_key_of_error(scene, key, "film", [&] {
        return choose_step(problem, resolved.accuracy.motion_rad(), most_chosen_steps, watch.stop);
    });
    note_unreached(resolved);
    return resolved;
}

MotionProblem problem_of(const ResolvedScene& resolved, std::span<const double> times_s) {
    const Scene& scene = resolved.scene;
    MotionProblem problem = problem_of(scene);
    extend(problem, times_s);
    // The trails of a loop include the motion before its start.
    if (resolved.loop)
        problem.first_time_s =
            std::min(problem.first_time_s, scene.film.start_s - resolved.loop->repeat_s);
    problem.overshoot_s = overshoot_s(problem);
    return problem;
}

bool is_stepped(const MethodChoice& choice) {
    const auto rows = methods();
    return std::any_of(rows.begin(), rows.end(), [&](const Method& method) {
        return method.name == choice.name && method.make != nullptr;
    });
}

std::string key_of(const std::string& table, const MethodChoice& choice) {
    if (choice.step_s) return table + ".step_s";
    return choice.tolerance ? table + ".tolerance" : table;
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

}  // namespace poinsot
