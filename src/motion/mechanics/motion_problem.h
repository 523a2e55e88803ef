// Everything that determines a motion: body, start, torque and the method that computes it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "mechanics/inertia.h"
#include "mechanics/rotation_state.h"
#include "mechanics/torque_kinds.h"

namespace poinsot {

// How the motion is computed.
struct MethodChoice {
    std::string name = "exact";
    std::optional<double> step_s;
    std::optional<double> tolerance;
    std::optional<int> order;
};

// A top's start in z-x-z Euler angles, φ = ψ = 0, e3 being the symmetry axis.
struct TopStart {
    double theta_rad = 0.0, theta_dot_rad_s = 0.0, phi_dot_rad_s = 0.0, omega3_rad_s = 0.0;
};

// A drawn history ends with a whole piece, which is no longer than so many times the whole of it.
inline constexpr double longest_piece_spans = 8.0;

// Everything that determines a motion.
struct MotionProblem {
    InertiaTensor inertia = InertiaTensor::from_principal_moments({1.0, 1.0, 1.0});
    RotationState start;  // at time_s = 0
    std::optional<TopStart>
        top_start;  // unrounded form of start, if known; the exact heavy top begins from it
    // Whether the start is known to lie on the separatrix exactly, L² = 2T·I₂, of a body with three
    // different moments: ω, which is rounded, seldom says so itself.
    bool on_separatrix = false;
    Torque torque;
    MethodChoice method;
    double first_time_s = 0.0;  // span that stepped methods must cover; exact ones cover all times
    double last_time_s = 0.0;
    double overshoot_s = 0.0;  // stepped methods also cover this much more: a drawn history
                               // ends with a whole piece
};

// Nothing acts on the body, and it turns.
inline bool turns_freely(const MotionProblem& problem) {
    return is_free(problem.torque) && !problem.start.omega_body.isZero(0.0);
}

}  // namespace poinsot
