// The differences between two computed motions, by which steps are chosen.
#pragma once

#include <span>

#include "mechanics/motion.h"

namespace poinsot {

struct MotionErrors {
    double attitude_rad = 0.0;     // largest angle between the two attitudes
    double energy_relative = 0.0;  // largest |T − T(0)| over T(0) of `motion`
    double momentum_relative =
        0.0;  // largest |L − L(0)| over |L(0)| of `motion`, as vectors in space
};

// The angle in rad, 0…π, of the rotation between two attitudes; accurate for small angles.
double angle_between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

// Returns the largest errors over the given instants. Both motions must cover these instants.
MotionErrors worst_errors(const Motion& motion, const Motion& truth,
                          std::span<const double> times_s);

}  // namespace poinsot
