#include "mechanics/motion.h"

#include <fmt/format.h>

#include "error/error.h"
#include "error/nearest.h"

namespace poinsot {

namespace {

std::variant<FreeRotation, HeavyTop> solve(const MotionProblem& problem) {
    if (problem.method.name != "exact") {
        throw InputError(fmt::format("unknown method \"{}\"; the method is exact",
                                     printable(problem.method.name)));
    }
    const auto* gravity = std::get_if<GravityTorque>(&problem.torque);
    if (gravity != nullptr) return HeavyTop(problem.inertia, *gravity, problem.start);
    if (!std::holds_alternative<NoTorque>(problem.torque)) {
        throw InputError(
            "method \"exact\" has no solution for this torque; name a method that steps");
    }
    return FreeRotation(problem.inertia, problem.start);
}

}  // namespace

Motion::Motion(const MotionProblem& problem) : problem_(problem), solution_(solve(problem)) {}

RotationState Motion::at(double time_s) const {
    return std::visit([=](const auto& solution) { return solution.at(time_s); }, solution_);
}

MotionSample Motion::sample(double time_s, Quantities wanted) const {
    return std::visit([=](const auto& solution) { return solution.sample(time_s, wanted); },
                      solution_);
}

Regime Motion::regime() const {
    if (heavy_top() != nullptr) return Regime::heavy_top;
    return free_rotation()->regime();
}

}  // namespace poinsot
