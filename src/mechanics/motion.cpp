#include "mechanics/motion.h"

#include "mechanics/methods.h"

namespace poinsot {

namespace {

using Solution = std::variant<FreeRotation, HeavyTop, IntegratedRotation>;

Solution solve(const MotionProblem& problem, const StopCheck& stop) {
    const Method& method = check_method(problem.method, problem.inertia, problem.torque);
    if (method.make != nullptr) return IntegratedRotation(problem, stop);
    const auto* gravity = std::get_if<GravityTorque>(&problem.torque);
    if (gravity != nullptr && HeavyTop::accepts(problem.inertia, *gravity)) {
        return HeavyTop(problem.inertia, *gravity, problem.start, problem.top_start);
    }
    return FreeRotation(problem.inertia, problem.start, problem.on_separatrix);
}

}  // namespace

Motion::Motion(const MotionProblem& problem, const StopCheck& stop)
    : problem_(problem), solution_(solve(problem, stop)) {}

RotationState Motion::at(double time_s) const {
    return std::visit([=](const auto& solution) { return solution.at(time_s); }, solution_);
}

MotionSample Motion::sample(double time_s, const Quantities& wanted) const {
    if (const FreeRotation* free = free_rotation()) return free->sample(time_s, wanted);
    return std::visit([=](const auto& solution) { return solution.sample(time_s, wanted); },
                      solution_);
}

Regime Motion::regime() const {
    if (heavy_top() != nullptr) return Regime::heavy_top;
    if (integrated() != nullptr) return Regime::integrated;
    return free_rotation()->regime();
}

FreeRotationConstants Motion::free_constants() const {
    if (const FreeRotation* free = free_rotation()) return free->constants();
    return FreeRotation(problem_.inertia, problem_.start, problem_.on_separatrix).constants();
}

std::optional<HeavyTop> Motion::closed_form_of_top() const {
    const auto* gravity = std::get_if<GravityTorque>(&problem_.torque);
    if (gravity == nullptr || !HeavyTop::accepts(problem_.inertia, *gravity)) return std::nullopt;
    return HeavyTop(problem_.inertia, *gravity, problem_.start, problem_.top_start);
}

bool Motion::sums_theta_series() const {
    return heavy_top() != nullptr ||
           (free_rotation() != nullptr && free_rotation()->sums_theta_series());
}

}  // namespace poinsot
