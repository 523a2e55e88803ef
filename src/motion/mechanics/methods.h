// The table of the methods that compute a motion: a name, a description and one function each.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "mechanics/motion_problem.h"
#include "mechanics/torque.h"

namespace poinsot {

// The cost of a stepped motion.
struct StepCounters {
    std::int64_t n_steps = 0;
    std::int64_t n_right_hand_sides = 0;  // for an implicit method: iterations
    std::int64_t n_torques = 0;           // evaluations of the torque among them
};

// A stepped motion at the end of a step. Steps of fixed length are counted, so that their times do
// not accumulate rounding.
struct StepNode {
    std::int64_t index = 0;
    double time_s = 0.0;  // from the start; negative backwards
    double step_s = 0.0;  // the next step: fixed, or the one to try first
    StepState state;
    std::array<double, 7> slope{};  // for a method that reuses the last derivative of a step
};

// One step of a method, with fixed length or not.
struct Propagator {
    // The node after this one.
    std::function<StepNode(const StepNode&, StepCounters&)> next;
    // The state at a time between this node and the next.
    std::function<StepState(const StepNode&, double time_s, StepCounters&)> within;
};

// The initial data of a method.
struct MethodStart {
    RotationDynamics dynamics;
    StepState state;
    int order = 0;
    double step_s = 0.0;     // methods of fixed step; negative backwards
    double tolerance = 0.0;  // methods that choose their steps; first step is step_s
};

// The torques that a method can follow: none, those of a potential, or all.
enum class TorquesTaken { none, with_potential, all };

// A row of the table.
struct Method {
    std::string_view name{};
    std::string_view summary{};
    std::string_view source{};
    std::string_view conserves{};
    std::span<const int> orders{};  // available orders; the last is the default. Empty: exact
    bool takes_step = false;
    bool takes_tolerance = false;
    TorquesTaken torques = TorquesTaken::none;
    Propagator (*make)(const MethodStart&) = nullptr;  // null: exact
};

// The table, exact first.
std::span<const Method> methods();

// The row of this name. Throws InputError with the nearest name and all of them.
const Method& find_method(std::string_view name);

// True if the method can compute this body's motion under this torque: exact accepts gravity along
// the axis of a symmetric body (or Mgl = 0); the other methods accept the torques of their row.
bool can_solve(const Method& method, const InertiaTensor& inertia, const Torque& torque);

// Names of the methods that can solve the problem, comma-separated, for a message.
std::string methods_that_solve(const InertiaTensor& inertia, const Torque& torque);

// The smallest tolerance that a method accepts; below it rounding exceeds the method's error.
inline constexpr double least_tolerance = 1e-14;
inline constexpr double default_tolerance = 1e-9;

// Checks a choice and returns the row that it names. Throws InputError if the method is unknown,
// cannot solve the problem (naming those that can), or does not take the order, step or tolerance
// given; if the step is not positive and finite, or the tolerance not between least_tolerance and
// 1.
const Method& check_method(const MethodChoice& choice, const InertiaTensor& inertia,
                           const Torque& torque);

}  // namespace poinsot
