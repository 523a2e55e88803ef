// Dormand & Prince's method of order 5(4) with step control and dense output, from Boost.odeint.
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>

#include "error/error.h"
#include "mechanics/methods.h"
#include "mechanics/stepped/friction.h"
#include "numerics/power_of_two.h"

namespace poinsot {

namespace {

namespace odeint = boost::numeric::odeint;

// L/unit, then the quaternion x, y, z, w. With friction, L follows from the attitude. Then the
// first number is the decay of the energy over the step, expressed as a rotation angle, so that one
// tolerance applies to it and to the attitude; the second is the angle for a decay of one, and the
// third is 0.
using Numbers = std::array<double, 7>;
using Stepper = odeint::runge_kutta_dopri5<Numbers>;
using Checker =
    odeint::default_error_checker<double, Stepper::algebra_type, Stepper::operations_type>;
using Adjuster = odeint::default_step_adjuster<double, double>;
using Controlled = odeint::controlled_runge_kutta<Stepper, Checker, Adjuster>;

class Dopri5 {
 public:
    explicit Dopri5(const MethodStart& start)
        : dynamics_(start.dynamics), friction_(start), tolerance_(start.tolerance) {
        // Largest step: a quarter of a turn, where each first step is the 200th part of one.
        constexpr double first_steps = 50.0;
        longest_step_s_ = first_steps * start.step_s;
        // In this unit of momentum one tolerance suits both momentum and attitude.
        const double momentum = norm_of(start.state.momentum);
        const double torque = dynamics_.greatest_torque_N_m();
        unit_ = momentum > 0.0
                    ? momentum
                    : std::sqrt(torque) * std::sqrt(dynamics_.moments_kg_m2().maxCoeff());
        if (!(unit_ > 0.0)) unit_ = 1.0;
        first_time_s_ = start.state.time_s;
        is_slowed_ = is_slowed(dynamics_.torque());
    }

    StepNode next(const StepNode& node, StepCounters& counters) const {
        Controlled controlled = controller();
        const Step step = take_step(node, controlled, counters);
        StepNode end;
        end.index = node.index + 1;
        end.time_s = step.end_s;
        end.step_s = step.next_step_s;
        end.slope = step.end_slope;
        end.state = state_of(node.state, step.end, unit_at(node.state));
        ++counters.n_steps;
        return end;
    }

    StepState within(const StepNode& node, double time_s, StepCounters& counters) const {
        if (time_s == node.time_s) return node.state;
        Controlled controlled = controller();
        const double unit = unit_at(node.state);
        if (friction_.acts()) {
            // A shorter step instead of the interpolation: its sum of the decay grows with time.
            Numbers numbers{};
            Numbers end_slope{};
            const Numbers start = numbers_of(node.state, unit);
            const auto system = [&](const Numbers& n, Numbers& rate, double t) {
                derive(n, rate, unit, t, counters);
            };
            Numbers slope{};
            derive(start, slope, unit, node.time_s, counters);
            controlled.stepper().do_step(system, start, slope, node.time_s, numbers, end_slope,
                                         time_s - node.time_s);
            return state_of(node.state, numbers, unit);
        }
        const Step step = take_step(node, controlled, counters);
        Numbers between{};
        controlled.stepper().calc_state(time_s, between, numbers_of(node.state, unit), step.slope,
                                        node.time_s, step.end, step.end_slope, step.end_s);
        return state_of(node.state, between, unit);
    }

 private:
    Controlled controller() const {
        return Controlled(Checker(tolerance_, tolerance_), Adjuster(longest_step_s_));
    }

    // The unit of L in the step from this state: under drag L falls, and each step keeps to the
    // tolerance of what is left.
    double unit_at(const StepState& state) const {
        const double momentum = is_slowed_ ? norm_of(state.momentum) : 0.0;
        return momentum > 0.0 ? momentum : unit_;
    }

    Numbers numbers_of(const StepState& state, double unit) const {
        const Eigen::Vector4d& q = state.space_from_principal.coeffs();
        if (friction_.acts())
            return {0.0, friction_.turn_of_decay_rad(state.momentum), 0.0, q[0], q[1], q[2], q[3]};
        return {state.momentum[0] / unit,
                state.momentum[1] / unit,
                state.momentum[2] / unit,
                q[0],
                q[1],
                q[2],
                q[3]};
    }

    // The quaternion of unit length: its drift is of the order of the tolerance.
    StepState state_of(const StepState& start, const Numbers& n, double unit) const {
        const Eigen::Quaterniond attitude = Eigen::Quaterniond(n[6], n[3], n[4], n[5]).normalized();
        if (friction_.acts())
            return friction_.settled(start, attitude, n[1] > 0.0 ? n[0] / n[1] : 0.0);
        return {unit * Eigen::Vector3d(n[0], n[1], n[2]), attitude};
    }

    void derive(const Numbers& n, Numbers& rate, double unit, double t,
                StepCounters& counters) const {
        ++counters.n_right_hand_sides;
        counters.n_torques += dynamics_.has_torque() ? 1 : 0;
        const Eigen::Quaterniond q(n[6], n[3], n[4], n[5]);
        const StepState state{
            friction_.acts() ? friction_.momentum_at(q) : unit * Eigen::Vector3d(n[0], n[1], n[2]),
            q, first_time_s_ + t};
        const RotationRates rates = dynamics_.rates(state);
        const Eigen::Vector3d half = 0.5 * rates.turning;
        const Eigen::Vector4d turning =
            (q * Eigen::Quaterniond(0.0, half[0], half[1], half[2])).coeffs();
        for (int i = 0; i < 3; ++i)
            rate[static_cast<std::size_t>(i)] =
                friction_.acts() ? 0.0 : rates.momentum_rate[i] / unit;
        if (friction_.acts()) {
            const double decay_1_s = n[1] * friction_.decay_1_s(state.momentum);
            rate[0] = friction_.backwards() ? -decay_1_s : decay_1_s;
        }
        for (int i = 0; i < 4; ++i) rate[static_cast<std::size_t>(i) + 3] = turning[i];
    }

    // A step within the tolerance.
    struct Step {
        Numbers slope{};  // at its start
        Numbers end{}, end_slope{};
        double end_s = 0.0;
        double next_step_s = 0.0;  // the length of the next step to try
    };

    Step take_step(const StepNode& node, Controlled& controlled, StepCounters& counters) const {
        const double unit = unit_at(node.state);
        const Numbers start = numbers_of(node.state, unit);
        const auto system = [&](const Numbers& n, Numbers& rate, double t) {
            derive(n, rate, unit, t, counters);
        };
        Step step{.slope = node.slope, .end_s = node.time_s, .next_step_s = node.step_s};
        // With friction the state after a step is not quite where its last derivative was taken,
        // and under drag that derivative has another unit.
        if (node.index == 0 || friction_.acts() || is_slowed_)
            derive(start, step.slope, unit, node.time_s, counters);
        constexpr int max_tries = 60;
        for (int i = 0; i < max_tries; ++i) {
            const auto result = controlled.try_step(system, start, step.slope, step.end_s, step.end,
                                                    step.end_slope, step.next_step_s);
            if (result == odeint::success) return step;
        }
        throw InputError(
            "method \"dopri5\" finds no step short enough for its tolerance; give a larger "
            "tolerance");
    }

    RotationDynamics dynamics_;
    Friction friction_;
    double tolerance_;
    double longest_step_s_ = 0.0;
    double unit_ = 1.0;  // of L
    double first_time_s_ = 0.0;
    bool is_slowed_ = false;  // by the air
};

}  // namespace

Propagator dopri5(const MethodStart& start) {
    const Dopri5 method(start);
    return {[method](const StepNode& node, StepCounters& counters) {
                return method.next(node, counters);
            },
            [method](const StepNode& node, double time_s, StepCounters& counters) {
                return method.within(node, time_s, counters);
            }};
}

}  // namespace poinsot
