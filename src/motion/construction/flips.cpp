#include "construction/flips.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "construction/polhode.h"

namespace poinsot {

std::vector<double> Flips::between(double first_s, double last_s, int most) const {
    std::vector<double> times;
    if (!interval_s) {
        if (first_s <= one_s && one_s <= last_s) times.push_back(one_s);
        return times;
    }
    const double k_first = std::ceil((first_s - one_s) / *interval_s);
    for (double k = k_first; static_cast<int>(times.size()) < most; ++k) {
        const double time_s = one_s + k * *interval_s;
        if (!(time_s <= last_s)) break;
        times.push_back(time_s);
    }
    return times;
}

std::optional<Flips> flips_of(const MotionProblem& problem,
                              const FreeRotationConstants& constants) {
    if (!constants.middle_axis_crossing_s) return std::nullopt;
    const Polhode polhode(problem.inertia, problem.start.omega_body, problem.on_separatrix);
    if (polhode.kind() != Polhode::Kind::closed && polhode.kind() != Polhode::Kind::separatrix)
        return std::nullopt;
    const Eigen::Vector3d& I = problem.inertia.moments_kg_m2();
    Flips flips;
    for (int i = 0; i < 3; ++i)
        if (I.minCoeff() < I[i] && I[i] < I.maxCoeff()) flips.axis = i;
    // The polhode is nearest to the middle axis a quarter of it away from a crossing.
    const Eigen::Vector3d nearest = polhode.at(0.5 * std::numbers::pi);
    const double along =
        std::abs(nearest.dot(problem.inertia.body_from_principal().col(flips.axis)));
    if (along < std::cos(flip_angle_rad) * nearest.norm()) return std::nullopt;
    flips.one_s = *constants.middle_axis_crossing_s;
    if (constants.polhode_period_s) flips.interval_s = 0.5 * *constants.polhode_period_s;
    return flips;
}

}  // namespace poinsot
