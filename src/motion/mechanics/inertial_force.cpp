#include "mechanics/inertial_force.h"

#include "mechanics/torque.h"

namespace poinsot {

InertialForce inertial_force(const PointMass& mass, const Eigen::Vector3d& omega_body,
                             const Eigen::Vector3d& omega_rate_body) {
    return {-mass.mass_kg * omega_body.cross(omega_body.cross(mass.at_m)),
            -mass.mass_kg * omega_rate_body.cross(mass.at_m)};
}

Eigen::Vector3d angular_acceleration(const MotionProblem& problem, const RotationState& state) {
    const RotationDynamics dynamics(problem.inertia, problem.torque);
    const Eigen::Matrix3d& body_from_principal = problem.inertia.body_from_principal();
    StepState step;
    step.momentum =
        dynamics.moments_kg_m2().cwiseProduct(body_from_principal.transpose() * state.omega_body);
    step.time_s = state.time_s;
    step.space_from_principal = state.space_from_body * Eigen::Quaterniond(body_from_principal);
    return body_from_principal *
           dynamics.rates(step).momentum_rate.cwiseQuotient(dynamics.moments_kg_m2());
}

}  // namespace poinsot
