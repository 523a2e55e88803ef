#include "cli/plan.h"

#include <fmt/format.h>

#include "drawing/stage_data.h"
#include "mechanics/heavy_top.h"
#include "mechanics/integrated_rotation.h"
#include "mechanics/methods.h"

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

std::string times_word(std::int64_t n) { return n == 1 ? "once" : fmt::format("{} times", n); }

}  // namespace

std::vector<PlanLine> plan_of(const Session& session, const FilmPlan& film, const Stage& stage) {
    const StageData& data = stage.data();
    const Quantities& asks = data.asks;
    const EvaluationCounts& made = stage.counts();
    const bool torque = !std::holds_alternative<NoTorque>(session.motion.problem().torque);

    std::vector<PlanLine> lines;
    lines.push_back(motion_line(session));
    lines.push_back({"torque", torque ? "in every evaluation of the motion" : "none",
                     torque ? "the scene has a [torque]" : "the scene has no [torque]"});
    lines.push_back({"angular velocity", fmt::format("{} frames, once each", film.n_frames),
                     "every panel shows it"});
    lines.push_back(
        {"attitude", asks.attitude ? fmt::format("{} frames, once each", film.n_frames) : "none",
         asks.attitude ? "a panel shows the body in space" : "every panel shows the body at rest"});
    lines.push_back(
        {"herpolhode",
         made.n_herpolhode > 0
             ? fmt::format("{} once, before the first frame; frames reveal a part of it",
                           times_word(made.n_herpolhode))
             : "none",
         made.n_herpolhode > 0 ? "a panel shows its history" : "no panel shows it"});
    lines.push_back({"Euler angles", asks.euler_angles ? "once a frame" : "none",
                     asks.euler_angles ? "a panel shows them" : "no panel shows them"});
    lines.push_back({"curves",
                     fmt::format("{} curves kept, within {:g} px", data.curves.size(),
                                 session.scene.accuracy_px),
                     "accuracy_px"});
    return lines;
}

}  // namespace poinsot
