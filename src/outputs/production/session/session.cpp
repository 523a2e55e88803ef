#include "production/session/session.h"

#include <fmt/format.h>

#include <utility>

#include "production/session/slow_work_notice.h"
#include "production/session/stepping_estimate.h"
#include "text/printable.h"

namespace poinsot {

Session session_of(const Scene& scene, const SessionRequest& request, const Task& task) {
    // Before the estimate, which steps as well.
    std::optional<SlowWorkNotice> notice;
    SteppingWatch watch;
    if (is_stepped(scene.method) || (scene.beside && is_stepped(*scene.beside))) {
        notice.emplace(fmt::format("{}: stepping the motion", printable(scene.name, 40)), task,
                       longest_stepping_s);
        watch = {[&notice](double estimate_s) { notice->expect(estimate_s); },
                 [&notice] { return notice->is_over(); }};
    }
    ResolvedScene resolved = resolve(scene, request, watch);

    MotionProblem problem = problem_of(resolved, request.times_s);
    problem.method = resolved.step.method;
    const bool steps = is_stepped(scene.method) && problem.first_time_s < problem.last_time_s;
    // A closed form can only reject the start.
    Motion motion = at_key_of_error(scene, steps ? key_of("motion", scene.method) : "start", "film",
                                    [&] { return Motion(problem, watch.stop); });
    std::optional<Motion> comparison;
    if (scene.beside) {
        problem.method = *scene.beside;
        comparison = at_key_of_error(scene, key_of("beside", *scene.beside), "film",
                                     [&] { return Motion(problem, watch.stop); });
    }
    return {std::move(resolved), std::move(motion), std::move(comparison), request.fonts};
}

double motion_error_px(const Session& session) {
    const bool stepped = session.motion.integrated() != nullptr;
    return (stepped ? session.step.attitude_rad : exact_residual_bound) *
           session.accuracy.px_per_rad;
}

bool can_certify(const Session& session) { return turns_freely(session.motion.problem()); }

Certificate certify_film(const Session& session, const FilmPlan& film, const Task& task) {
    std::optional<SlowWorkNotice> notice;
    constexpr std::int64_t many = 100'000;
    if (film.n_frames >= many)
        notice.emplace(fmt::format("{}: certifying {} frames", printable(session.scene.name, 40),
                                   film.n_frames),
                       task);
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(film.n_frames));
    for (std::int64_t frame = 0; frame < film.n_frames; ++frame) {
        times.push_back(film.time_of(frame));
    }
    // The bound is the requested accuracy for a stepped method, and the rounding error for a closed
    // form.
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

void tell_notes(const Session& session, const Task& task) {
    for (const auto* notes : {&session.scene.notes, &session.notes})
        for (const std::string& note : *notes) task.say("note: " + printable(note));
}

}  // namespace poinsot
