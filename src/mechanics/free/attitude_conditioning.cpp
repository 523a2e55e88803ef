#include "mechanics/free/attitude_conditioning.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/free/free_rotation.h"

namespace poinsot {

double attitude_conditioning_rad(const InertiaTensor& inertia, const RotationState& start,
                                 double time_s) {
    const Eigen::Quaterniond here = FreeRotation(inertia, start).at(time_s).space_from_body;
    const auto moved = [&](const InertiaTensor& body, const RotationState& state) {
        const Eigen::Quaterniond there = FreeRotation(body, state).at(time_s).space_from_body;
        return 2.0 * std::min((there.coeffs() - here.coeffs()).norm(),
                              (there.coeffs() + here.coeffs()).norm());
    };
    constexpr double up = std::numeric_limits<double>::infinity();
    double worst = 0.0;
    for (int i = 0; i < 3; ++i) {
        Eigen::Vector3d moments = inertia.moments_kg_m2();
        moments[i] = std::nextafter(moments[i], up);
        worst =
            std::max(worst, moved(InertiaTensor::from_principal_axes(
                                      moments, inertia.body_from_principal(), Physicality::waived),
                                  start));
        RotationState other = start;
        other.omega_body[i] = std::nextafter(other.omega_body[i], up);
        worst = std::max(worst, moved(inertia, other));
    }
    return worst;
}

}  // namespace poinsot
