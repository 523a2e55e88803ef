// Ways to step a free motion through the video frames of a span, each with settings from coarse to
// fine: our methods and typical code with Boost.odeint.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/free_bodies.h"
#include "mechanics/motion.h"

namespace poinsot::bench {

// (x, y, z, w) at every frame.
using Attitudes = std::vector<Eigen::Vector4d>;

struct Runner {
    std::string name;
    double longest_run_s = 0.3;  // processor time of a run after which finer settings are skipped
    std::function<std::optional<std::string>(int rung)> setting;  // empty after the finest setting
    std::function<Attitudes(int rung)> run;
};

Attitudes attitudes_of(const Motion& motion, const std::vector<double>& times_s);

// The largest angle between two attitudes at a frame, in rad; infinite if one is not finite.
double worst_error(const Attitudes& a, const Attitudes& b);

// All runners for this body and these times from 0 on; frames_a_period: number of frames per
// period.
std::vector<Runner> runners_for(const FreeBody& body, const std::vector<double>& times_s,
                                std::size_t frames_a_period);

}  // namespace poinsot::bench
