#include "construction/flips.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "construction/polhode.h"
#include "numerics/power_of_two.h"

namespace poinsot {

namespace {

// A body turns over if its middle axis comes within this angle of L and of −L.
constexpr double turning_over_rad = 0.25 * std::numbers::pi;

}  // namespace

std::optional<int> middle_axis(const Eigen::Vector3d& moments) {
    for (int i = 0; i < 3; ++i)
        if (moments.minCoeff() < moments[i] && moments[i] < moments.maxCoeff()) return i;
    return std::nullopt;
}

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

bool AxisSwing::turns_over() const { return least_rad < turning_over_rad; }

std::optional<AxisSwing> swing_of(const MotionProblem& problem) {
    const Eigen::Vector3d& I = problem.inertia.moments_kg_m2();
    const std::optional<int> middle = middle_axis(I);
    if (!middle || problem.start.omega_body.isZero(0.0)) return std::nullopt;
    const Polhode polhode(problem.inertia, problem.start.omega_body, problem.on_separatrix);
    if (polhode.kind() != Polhode::Kind::closed) return std::nullopt;
    // The polhode is nearest to the middle axis a quarter of it away from a crossing.
    const Eigen::Vector3d nearest =
        problem.inertia.body_from_principal().transpose() * polhode.at(0.5 * std::numbers::pi);
    const Eigen::Vector3d momentum = I.cwiseProduct(nearest) / I.maxCoeff();
    AxisSwing swing;
    swing.middle = *middle;
    swing.encircled = polhode.encircled_axis();
    swing.is_along_momentum = momentum[swing.encircled] > 0.0;
    swing.least_rad =
        std::atan2(std::abs(momentum[swing.encircled]), std::abs(momentum[swing.middle]));
    return swing;
}

std::optional<Flips> flips_of(const MotionProblem& problem,
                              const FreeRotationConstants& constants) {
    if (!constants.middle_axis_crossing_s) return std::nullopt;
    const std::optional<int> middle = middle_axis(problem.inertia.moments_kg_m2());
    const Polhode polhode(problem.inertia, problem.start.omega_body, problem.on_separatrix);
    if (!middle) return std::nullopt;
    if (polhode.kind() != Polhode::Kind::separatrix) {
        const std::optional<AxisSwing> swing = swing_of(problem);
        if (!swing || !swing->turns_over()) return std::nullopt;
    }
    Flips flips;
    flips.axis = *middle;
    flips.one_s = *constants.middle_axis_crossing_s;
    if (constants.polhode_period_s) flips.interval_s = 0.5 * *constants.polhode_period_s;
    return flips;
}

std::optional<std::vector<double>> sampled_flips(const Motion& motion, double first_s,
                                                 double last_s) {
    const InertiaTensor& inertia = motion.problem().inertia;
    const Eigen::Vector3d& I = inertia.moments_kg_m2();
    const std::optional<int> middle = middle_axis(I);
    std::vector<double> flips;
    if (!middle) return flips;
    struct Look {
        double time_s, along, rate;  // ω along the middle axis, |ω|
        int side;                    // of the middle axis: 1 within 45° of L, −1 of −L, else 0
    };
    const auto look_at = [&](double time_s) {
        const Eigen::Vector3d omega =
            inertia.body_from_principal().transpose() * motion.at(time_s).omega_body;
        const double rate = norm_of(omega);
        const Eigen::Vector3d momentum = I.cwiseProduct(omega) / I.maxCoeff();
        const double along = momentum[*middle] / std::max(norm_of(momentum), 1e-300);
        const bool is_near = std::abs(along) > std::cos(turning_over_rad);
        return Look{time_s, omega[*middle], rate, !is_near ? 0 : along > 0.0 ? 1 : -1};
    };
    constexpr int most_looks = 1'000'000;
    Look before = look_at(first_s);
    int side = before.side;
    std::optional<double> crossed_s;
    for (int n = 0; before.time_s < last_s; ++n) {
        if (n >= most_looks) return std::nullopt;
        // A film that stands nearly still is looked at all the same.
        const double step_s = std::min(0.1 / before.rate, (last_s - first_s) / 256.0);
        const Look now = look_at(std::min(before.time_s + step_s, last_s));
        if (!(now.time_s > before.time_s)) return std::nullopt;
        if (std::signbit(now.along) != std::signbit(before.along)) {
            double least_s = before.time_s, most_s = now.time_s;
            for (int round = 0; round < 60; ++round) {
                const double middle_s = 0.5 * (least_s + most_s);
                const bool as_before =
                    std::signbit(look_at(middle_s).along) == std::signbit(before.along);
                (as_before ? least_s : most_s) = middle_s;
            }
            crossed_s = 0.5 * (least_s + most_s);
        }
        if (now.side != 0) {
            if (now.side == -side && crossed_s) flips.push_back(*crossed_s);
            side = now.side;
        }
        before = now;
    }
    return flips;
}

}  // namespace poinsot
