// The inertial forces on the point masses of a body, in the axes that turn with the body.
#pragma once

#include <Eigen/Core>

#include "mechanics/motion_problem.h"
#include "mechanics/solids.h"

namespace poinsot {

// The inertial forces on a mass at rest in the body, N, body axes. A mass at rest feels no Coriolis
// force −2m ω × v. Source: Landau & Lifshitz, Mechanics §39.
struct InertialForce {
    Eigen::Vector3d centrifugal_N = Eigen::Vector3d::Zero();  // −m ω × (ω × r)
    Eigen::Vector3d euler_N = Eigen::Vector3d::Zero();        // −m dω/dt × r
    Eigen::Vector3d total_N() const { return centrifugal_N + euler_N; }
};
// `mass`: its place from the point about which the body turns; `omega_rate_body`: dω/dt, rad/s².
InertialForce inertial_force(const PointMass& mass, const Eigen::Vector3d& omega_body,
                             const Eigen::Vector3d& omega_rate_body);

// dω/dt in rad/s², body axes, by Euler's equations. Precondition: no internal friction, by which a
// body is not rigid.
Eigen::Vector3d angular_acceleration(const MotionProblem& problem, const RotationState& state);

}  // namespace poinsot
