// A Propagator that takes steps of equal length.
#pragma once

#include <utility>

#include "mechanics/methods.h"

namespace poinsot {

// step(state, h, counters) → state after a time h; a time within a step is reached by a shorter
// step.
template <typename Step>
Propagator fixed_step(const MethodStart& start, Step step) {
    Propagator propagator;
    propagator.next = [step, step_s = start.step_s, first_s = start.state.time_s](
                          const StepNode& node, StepCounters& counters) {
        ++counters.n_steps;
        StepNode next;
        next.index = node.index + 1;
        next.time_s = static_cast<double>(next.index) * step_s;
        next.step_s = step_s;
        next.state = step(node.state, step_s, counters);
        next.state.time_s = first_s + next.time_s;
        return next;
    };
    propagator.within = [step = std::move(step)](const StepNode& node, double time_s,
                                                 StepCounters& counters) {
        if (time_s == node.time_s) return node.state;
        ++counters.n_steps;
        return step(node.state, time_s - node.time_s, counters);
    };
    return propagator;
}

}  // namespace poinsot
