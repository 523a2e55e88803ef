#include "mechanics/regime_sentence.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

namespace poinsot {

namespace {

std::string axis_name(int axis) { return fmt::format("e{}", axis + 1); }

// Whether the body spins about the axis of the middle moment, which is unstable.
bool is_about_middle_axis(const MotionProblem& problem) {
    const Eigen::Vector3d& I = problem.inertia.moments_kg_m2();
    const Eigen::Vector3d omega =
        problem.inertia.body_from_principal().transpose() * problem.start.omega_body;
    int axis = 0;
    omega.cwiseAbs().maxCoeff(&axis);
    return I.minCoeff() < I[axis] && I[axis] < I.maxCoeff();
}

std::string regime_in_words(const MotionProblem& problem, Regime regime,
                            const FreeRotationConstants& constants) {
    switch (regime) {
        case Regime::at_rest:
            return "at rest: ω is zero";
        case Regime::permanent:
            return is_about_middle_axis(problem)
                       ? "permanent rotation about the middle axis: ω is constant, but unstable"
                       : "permanent rotation: ω is constant";
        case Regime::symmetric:
            return "symmetric body: ω moves on a circle (trigonometric functions)";
        case Regime::elliptic_about_lowest:
            return fmt::format("polhode about {}, the axis of the smallest moment (elliptic)",
                               axis_name(constants.encircled_axis));
        case Regime::elliptic_about_highest:
            return fmt::format("polhode about {}, the axis of the largest moment (elliptic)",
                               axis_name(constants.encircled_axis));
        case Regime::separatrix:
            return "separatrix: ω approaches the middle axis and never returns (hyperbolic)";
        default:
            return std::string(name_of(regime));
    }
}

// An explanation of the kind of a top's motion.
std::string_view meaning_of(TopRegime regime) {
    switch (regime) {
        case TopRegime::sleeping:
            return "upright, and stable since (I₃ω₃)² ≥ 4I₁·Mgl";
        case TopRegime::sleeping_unstable:
            return "upright by symmetry alone, since (I₃ω₃)² < 4I₁·Mgl";
        case TopRegime::hanging:
            return "vertical, with the centre of mass below the fixed point";
        case TopRegime::steady_slow:
            return "θ is constant; this is the slower of the two precessions at this tilt";
        case TopRegime::steady_fast:
            return "θ is constant; this is the faster of the two precessions at this tilt";
        case TopRegime::wavy:
            return "φ̇ keeps its sign";
        case TopRegime::cusp:
            return "φ̇ vanishes at the upper end";
        case TopRegime::looping:
            return "φ̇ changes its sign";
        case TopRegime::through_vertical:
            return "φ jumps by π at each passage";
        case TopRegime::planar_pendulum:
            return "neither spin nor precession";
        case TopRegime::separatrix:
            return "the axis approaches the upright position and never returns";
        case TopRegime::no_gravity:
            return "a free symmetric body";
    }
    return "";
}

}  // namespace

std::string regime_sentence(const Motion& motion) {
    const MotionProblem& problem = motion.problem();
    if (is_free(problem.torque))
        return regime_in_words(problem, motion.regime(), motion.free_constants());
    const auto top = motion.closed_form_of_top();
    return top ? regime_sentence(*top) : std::string(name_of(motion.regime()));
}

std::string regime_sentence(const HeavyTop& top) {
    return fmt::format("{}: {}", name_of(top.regime()), meaning_of(top.regime()));
}

}  // namespace poinsot
