// The bodies whose free motion is benchmarked: one per regime.
#pragma once

#include <Eigen/Core>
#include <array>

#include "mechanics/motion_problem.h"

namespace poinsot::bench {

struct FreeBody {
    const char* name;
    Eigen::Vector3d moments_kg_m2;
    Eigen::Vector3d omega_rad_s;
};

inline const std::array<FreeBody, 8> regimes{{
    {"permanent", {1.0, 2.0, 3.0}, {0.0, 0.0, 1.5}},
    {"symmetric", {2.0, 2.0, 3.0}, {0.5, 0.3, 1.0}},
    {"elliptic, about the highest", {1.0, 2.0, 3.0}, {0.1, 0.2, 1.0}},
    {"elliptic, about the lowest", {1.0, 2.0, 3.0}, {1.0, 0.2, 0.1}},
    {"elliptic, imaginary series", {1.0, 2.0, 3.0}, {0.3, 1.0, 0.2}},
    {"near the separatrix, 1e-8", {1.0, 2.0, 3.0}, {1e-8, 1.0, 1e-8}},
    {"near the separatrix, 1e-150", {1.0, 2.0, 3.0}, {1e-150, 1.0, 1e-150}},
    {"separatrix", {1.0, 2.0, 2.25}, {0.75, 0.5, 1.0}},
}};

inline MotionProblem problem_of(const FreeBody& body) {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments(body.moments_kg_m2);
    problem.start.omega_body = body.omega_rad_s;
    return problem;
}

}  // namespace poinsot::bench
