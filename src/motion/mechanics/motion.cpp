#include "mechanics/motion.h"

#include <fmt/format.h>

#include <string_view>

#include "error/error.h"
#include "mechanics/methods.h"

namespace poinsot {

namespace {

using Solution = std::variant<FreeRotation, HeavyTop, IntegratedRotation>;

Solution solve(const MotionProblem& problem, const StopCheck& stop) {
    const Method& method = check_method(problem.method, problem.inertia, problem.torque);
    if (method.make != nullptr) return IntegratedRotation(problem, stop);
    const auto* gravity = std::get_if<Gravity>(&problem.torque);
    if (gravity != nullptr && HeavyTop::accepts(problem.inertia, *gravity)) {
        return HeavyTop(problem.inertia, *gravity, problem.start, problem.top_start);
    }
    return FreeRotation(problem.inertia, problem.start, problem.on_separatrix);
}

void require_in_range(double time_s, bool is_finite, std::string_view what) {
    if (is_finite) [[likely]]
        return;
    throw InputError(
        fmt::format("{} at {} s lies beyond the range of double-precision numbers; choose other "
                    "units",
                    what, time_s));
}

// Whatever is asked of a motion passes here before anybody draws or prints it.
void check_result(const RotationState& state) {
    require_in_range(state.time_s, state.omega_body.allFinite(), "the angular velocity");
    require_in_range(state.time_s, state.space_from_body.coeffs().allFinite(), "the attitude");
}

void check_result(const MotionSample& sample) {
    check_result(sample.state);
    const double time_s = sample.state.time_s;
    require_in_range(time_s, sample.herpolhode_space.allFinite(), "the herpolhode");
    const EulerAngles& euler = sample.euler;
    require_in_range(time_s,
                     Eigen::Vector3d(euler.theta_rad, euler.phi_rad, euler.psi_rad).allFinite(),
                     "one of Euler's angles");
}

}  // namespace

Motion::Motion(const MotionProblem& problem, const StopCheck& stop)
    : problem_(problem), solution_(solve(problem, stop)) {}

RotationState Motion::at(double time_s) const {
    RotationState state =
        std::visit([=](const auto& solution) { return solution.at(time_s); }, solution_);
    check_result(state);
    return state;
}

MotionSample Motion::sample(double time_s, const Quantities& wanted) const {
    const FreeRotation* free = free_rotation();
    MotionSample sample =
        free != nullptr
            ? free->sample(time_s, wanted)
            : std::visit([=](const auto& solution) { return solution.sample(time_s, wanted); },
                         solution_);
    check_result(sample);
    return sample;
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
    const auto* gravity = std::get_if<Gravity>(&problem_.torque);
    if (gravity == nullptr || !HeavyTop::accepts(problem_.inertia, *gravity)) return std::nullopt;
    return HeavyTop(problem_.inertia, *gravity, problem_.start, problem_.top_start);
}

bool Motion::sums_theta_series() const {
    return heavy_top() != nullptr ||
           (free_rotation() != nullptr && free_rotation()->sums_theta_series());
}

}  // namespace poinsot
