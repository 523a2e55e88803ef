// A generic motion, and the times of the frames of a film.
// frames.
#pragma once

#include <string>
#include <vector>

#include "mechanics/motion.h"

namespace poinsot {

inline MotionProblem generic_problem(const std::string& method) {
    MotionProblem problem;
    problem.inertia = InertiaTensor::from_principal_moments({1.0, 2.0, 2.9});
    problem.start.omega_body = {1.678, 0.1, 0.639};
    problem.method.name = method;
    problem.last_time_s = 10.0;
    return problem;
}

inline std::vector<double> frames() {
    std::vector<double> times;
    for (int k = 0; k < 300; ++k) times.push_back(k / 30.0);
    return times;
}

}  // namespace poinsot
