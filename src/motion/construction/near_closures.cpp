#include "construction/near_closures.h"

#include <cmath>
#include <numbers>

#include "error/error.h"
#include "mechanics/free/free_rotation.h"
#include "numerics/power_of_two.h"

namespace poinsot {

std::vector<Closure> convergents(double turns, int most_periods) {
    // Beyond this the quotients are those of the rounding.
    constexpr double same_turns = 1e-12;
    constexpr double most_turns = 1e6;
    std::vector<Closure> found;
    if (!(std::abs(turns) < most_turns)) return found;
    double p = 1.0, q = 0.0, p_before = 0.0, q_before = 1.0;
    double rest = turns;
    // Denominators grow at least as Fibonacci's numbers, beyond any `most_periods`.
    for (;;) {
        const double quotient = std::floor(rest);
        const double p_next = quotient * p + p_before;
        const double q_next = quotient * q + q_before;
        if (!(q_next <= most_periods)) return found;
        p_before = p, q_before = q;
        p = p_next, q = q_next;
        // 0/1 and 1/1 after it, or 1/1 and 2/1, have the same q: the nearer one is the second.
        if (!found.empty() && found.back().periods == static_cast<int>(q)) found.pop_back();
        if (p >= 1.0) found.push_back({static_cast<int>(p), static_cast<int>(q)});
        if (std::abs(turns - p / q) <= same_turns * std::max(1.0, turns)) return found;
        rest = 1.0 / (rest - quotient);
    }
}

std::vector<NearClosure> near_closures(const InertiaTensor& inertia,
                                       const Eigen::Vector3d& omega_body, int most_periods) {
    std::vector<NearClosure> near;
    RotationState start;
    start.omega_body = omega_body;
    const FreeRotationConstants constants = FreeRotation(inertia, start).constants();
    if (!constants.polhode_period_s || !constants.advance_per_period_rad) return near;
    const double turns = *constants.advance_per_period_rad / (2.0 * std::numbers::pi);
    for (const Closure& closure : convergents(turns, most_periods)) {
        try {
            const ClosedStart closed = close_herpolhode(inertia, omega_body, closure);
            near.push_back(
                {closure, closed, norm_of(closed.omega_body - omega_body) / norm_of(omega_body)});
        } catch (const InputError&) {
            // No start nearby closes so.
        }
    }
    return near;
}

}  // namespace poinsot
