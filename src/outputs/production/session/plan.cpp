#include "production/session/plan.h"

#include <fmt/format.h>

#include "drawing/stage/stage_store.h"
#include "mechanics/counted_motion.h"
#include "mechanics/methods.h"
#include "mechanics/stepped/integrated_rotation.h"
#include "mechanics/top/heavy_top.h"

namespace poinsot {

namespace {

PlanLine motion_line(const Session& session) {
    if (const IntegratedRotation* stepped = session.motion.integrated()) {
        return {"motion",
                fmt::format("stepped by {}: {} steps, {} evaluations of the equations",
                            stepped->method().name, stepped->counters().n_steps,
                            stepped->counters().n_right_hand_sides),
                "the scene names this method"};
    }
    switch (session.motion.regime()) {
        case Regime::at_rest:
            return {"motion", "nothing: the body rests", "omega is zero"};
        case Regime::permanent:
            return {"motion", "a steady turn: sine and cosine of one angle, no elliptic function",
                    "omega lies along a principal axis, or the body is a sphere"};
        case Regime::symmetric:
            return {"motion", "two steady turns: sine and cosine, no elliptic function",
                    "two moments are equal"};
        case Regime::separatrix:
            return {"motion", "hyperbolic functions: the elliptic ones at k = 1 exactly",
                    "L² = 2T·I₂ in the numbers given"};
        case Regime::heavy_top:
            return {"motion", "elliptic functions and two integrals of the third kind",
                    "a symmetric top under gravity has an exact solution"};
        default:
            return {"motion", "elliptic functions and one integral of the third kind",
                    "three different moments, off the separatrix"};
    }
}

PlanLine torque_line(const Session& session) {
    if (is_free(session.motion.problem().torque)) {
        return {"torque", "none", "the scene has no [torque]"};
    }
    const IntegratedRotation* stepped = session.motion.integrated();
    if (stepped == nullptr) return {"torque", "none", "the closed form includes gravity"};
    const std::int64_t n_torques = stepped->counters().n_torques;
    return {"torque", fmt::format("evaluated {} times", n_torques),
            n_torques > 0 ? "the scene has [torque]" : "internal friction is not a torque"};
}

PlanLine frames_line(const char* what, bool asked, std::int64_t n_frames, const char* why,
                     const char* why_not) {
    return {what, asked ? fmt::format("{} frames, once each", n_frames) : "none",
            asked ? why : why_not};
}

}  // namespace

std::vector<PlanLine> plan_of(const Session& session, const FilmPlan& film, const Stage& stage) {
    const Quantities& needs = stage.needs();
    const EvaluationCounts& made = stage.counts();

    std::vector<PlanLine> lines;
    lines.push_back(motion_line(session));
    lines.push_back(torque_line(session));
    lines.push_back(
        frames_line("angular velocity", true, film.n_frames, "every panel shows it", ""));
    lines.push_back(frames_line("attitude", needs.attitude, film.n_frames,
                                "a panel shows the body in space",
                                "no panel shows the body in space"));
    lines.push_back(frames_line("herpolhode's point", needs.herpolhode, film.n_frames,
                                "a panel shows its position",
                                "no panel shows it without the attitude"));
    lines.push_back(
        {"herpolhode's history",
         made.n_herpolhode > 0
             ? fmt::format("{} evaluations before the first frame, none after", made.n_herpolhode)
             : "none",
         made.n_herpolhode > 0 ? "a panel shows it; each frame draws a part of one curve"
                               : "no panel shows it"});
    lines.push_back(frames_line("Euler angles", needs.euler_angles, film.n_frames,
                                "a panel shows them", "no panel shows them"));
    if (session.comparison) {
        const IntegratedRotation* stepped = session.comparison->integrated();
        lines.push_back({"comparison",
                         fmt::format("by {}: {} steps", session.comparison->problem().method.name,
                                     stepped != nullptr ? stepped->counters().n_steps : 0),
                         "the scene has [beside]"});
    }
    lines.push_back({"curves",
                     fmt::format("{} stored, within {:.2g} px of the exact curves",
                                 stage.store().curves().size(), stage.curve_error_px()),
                     fmt::format("half of accuracy_px = {:g} at quality {}",
                                 session.accuracy.asked_px, session.scene.film.quality)});
    return lines;
}

}  // namespace poinsot
