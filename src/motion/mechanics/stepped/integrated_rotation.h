// A motion computed step by step by a method of the table, as an immutable value over a time span.
#pragma once

#include <vector>

#include "mechanics/methods.h"
#include "mechanics/motion_problem.h"
#include "mechanics/rotation_state.h"
#include "mechanics/stop_check.h"

namespace poinsot {

// How far a counted number of steps leads, for an estimate before all of them are taken.
struct SteppingProbe {
    std::int64_t n_steps = 0;  // that were taken
    double share = 0.0;        // of the longer side of the span that they cover, 0 to 1
};

// Immutable. The steps start at the problem's start and go to both ends of its time span; every
// n-th state is stored, and an instant between two of them is computed from the earlier one by
// whole steps and one shorter step (or the method's dense output). So the same instant always gives
// the same state, and memory stays bounded.
class IntegratedRotation {
 public:
    // Throws InputError for what check_method refuses, a start that is not finite, a step longer
    // than the time span or than friction allows, a step that the method finds no solution for or
    // that is too short for the time to advance, and a span of more than max_steps steps; and soon
    // after a stop is requested.
    explicit IntegratedRotation(const MotionProblem& problem, const StopCheck& stop = {});

    // Takes at most this many steps, on the longer side of the span, and stores nothing. Throws
    // like the constructor, except for too many steps.
    static SteppingProbe probe(const MotionProblem& problem, std::int64_t most_steps);

    // Throws InputError outside the time span and its overshoot.
    RotationState at(double time_s) const;
    // Euler angles are those of the attitude, z-x-z, φ and ψ in (−π, π], not unwrapped.
    MotionSample sample(double time_s, Quantities wanted) const;

    const Method& method() const { return *method_; }
    // The fixed step, or the first one to try, in seconds; positive.
    double step_s() const { return step_s_; }
    double first_time_s() const { return first_time_s_; }
    double last_time_s() const { return last_time_s_; }
    // The cost of covering the time span.
    const StepCounters& counters() const { return counters_; }
    // Like at(); adds the cost of the evaluation to the counters.
    RotationState at(double time_s, StepCounters& counters) const;
    std::size_t n_kept_states() const { return forward_.kept.size() + backward_.kept.size(); }

    static constexpr double max_steps = 1e9;
    static constexpr std::size_t max_kept_states = 1U << 15U;  // in each direction

 private:
    struct Branch {
        Propagator propagator;
        std::vector<StepNode> kept;  // in order of |time|, the start first
    };

    IntegratedRotation() = default;
    // Checks the problem and sets all but the branches.
    MethodStart prepare(const MotionProblem& problem);
    void cover(Branch& branch, const MethodStart& start, double end_s, const StopCheck& stop);
    // One step on, checked.
    StepNode advanced(const Propagator& propagator, const StepNode& node);
    // Throws if the time after a step is not beyond that before it.
    void require_advance(const StepNode& node, const StepNode& next) const;

    const Method* method_ = nullptr;
    InertiaTensor inertia_ = InertiaTensor::from_principal_moments({1.0, 1.0, 1.0});
    double start_time_s_ = 0.0;
    double first_time_s_ = 0.0;
    double last_time_s_ = 0.0;
    double overshoot_s_ = 0.0;
    double step_s_ = 0.0;
    Branch forward_;
    Branch backward_;
    StepCounters counters_;
};

}  // namespace poinsot
