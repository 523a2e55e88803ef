#include "construction/montgomery_phase.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "mechanics/free/free_rotation.h"
#include "numerics/elliptic_integrals.h"

namespace poinsot {

namespace {

// The number of instants in half a polhode period at which the trapezoidal rule is exact to
// rounding. The integrand's nearest singularity is at least K′ from the real axis, and its period
// is 2K, so that n instants leave an error of e^(−πn·K′/K): here 1e-19.
int n_instants(const FreeRotationConstants& constants) {
    if (constants.modulus == 0.0) return 8;
    const WideDouble ratio =
        complete_first_kind(std::max(constants.complementary_modulus, 1e-300)) /
        complete_first_kind(std::max(constants.modulus, 1e-300));
    return 8 + static_cast<int>(std::ceil(14.0 * ratio.rounded()));
}

}  // namespace

std::optional<MontgomeryPhase> montgomery_phase(const MotionProblem& problem) {
    if (!is_free(problem.torque)) return std::nullopt;
    const FreeRotation motion(problem.inertia, problem.start, problem.on_separatrix);
    const FreeRotationConstants& constants = motion.constants();
    if (!constants.polhode_period_s || !constants.advance_per_period_rad) return std::nullopt;
    // Of the smallest doubles the period overflows.
    if (!std::isfinite(*constants.polhode_period_s)) return std::nullopt;

    const Eigen::Matrix3d principal_from_body = problem.inertia.body_from_principal().transpose();
    const Eigen::Vector3d& moments = problem.inertia.moments_kg_m2();
    const Eigen::Vector3d weights = moments / moments.maxCoeff();
    const int a = constants.encircled_axis, b = (a + 1) % 3, c = (a + 2) % 3;
    MontgomeryPhase phase;
    phase.period_s = *constants.polhode_period_s;
    // The herpolhode makes a turn more than the body about the axis of the largest moment, and one
    // less about that of the smallest, since ω turns once about that axis of the body.
    constexpr double turn_rad = 2.0 * std::numbers::pi;
    const bool is_largest = moments[a] >= std::max(moments[b], moments[c]);
    phase.turned_rad = *constants.advance_per_period_rad + (is_largest ? -turn_rad : turn_rad);

    // S = ∮ (n × n′)·e/(1 + n·e) dt, where n = L/|L| and e is the axis a on the side of n. With n′
    // = n × ω the numerator is |ω_a|·(n_b²(I_a/I_b − 1) + n_c²(I_a/I_c − 1)), whose two terms have
    // the same sign. The integrand repeats after half a period.
    const int n = n_instants(constants);
    const double half_s = 0.5 * phase.period_s;
    double mean_rad_s = 0.0;
    for (int k = 0; k < n; ++k) {
        const Eigen::Vector3d omega =
            principal_from_body *
            motion
                .sample(problem.start.time_s + half_s * k / n,
                        {.attitude = false, .herpolhode = false, .euler_angles = false})
                .state.omega_body;
        const Eigen::Vector3d momentum = weights.cwiseProduct(omega).stableNormalized();
        const double swept = momentum[b] * momentum[b] * (moments[a] - moments[b]) / moments[b] +
                             momentum[c] * momentum[c] * (moments[a] - moments[c]) / moments[c];
        mean_rad_s += swept * std::abs(omega[a]) / (1.0 + std::abs(momentum[a])) / n;
    }
    phase.solid_angle_rad = mean_rad_s * phase.period_s;

    const Eigen::Vector3d omega = principal_from_body * problem.start.omega_body;
    const Eigen::Vector3d direction = weights.cwiseProduct(omega).stableNormalized();
    phase.dynamic_rad = omega.dot(direction) * phase.period_s;
    return phase;
}

}  // namespace poinsot
