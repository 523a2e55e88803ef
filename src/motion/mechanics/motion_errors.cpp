#include "mechanics/motion_errors.h"

#include <algorithm>
#include <cmath>

namespace poinsot {

double angle_between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
    const Eigen::Quaterniond between = a.conjugate() * b;
    return 2.0 * std::atan2(between.vec().norm(), std::abs(between.w()));
}

MotionErrors worst_errors(const Motion& motion, const Motion& truth,
                          std::span<const double> times_s) {
    const MotionProblem& problem = motion.problem();
    const Eigen::Matrix3d tensor = problem.inertia.matrix_body();
    const Eigen::Vector3d momentum_start =
        problem.start.space_from_body * Eigen::Vector3d(tensor * problem.start.omega_body);
    const double energy_start = problem.start.omega_body.dot(tensor * problem.start.omega_body);

    MotionErrors worst;
    const auto keep = [](double& most, double value) {
        most = value == value ? std::max(most, value) : HUGE_VAL;
    };
    for (const double time_s : times_s) {
        const RotationState state = motion.at(time_s);
        const RotationState exact = truth.at(time_s);
        keep(worst.attitude_rad, angle_between(state.space_from_body, exact.space_from_body));
        const Eigen::Vector3d momentum_body = tensor * state.omega_body;
        keep(worst.energy_relative,
             std::abs(state.omega_body.dot(momentum_body) - energy_start) / energy_start);
        keep(worst.momentum_relative,
             (state.space_from_body * momentum_body - momentum_start).norm() /
                 momentum_start.norm());
    }
    return worst;
}

}  // namespace poinsot
