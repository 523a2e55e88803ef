// Asking a motion for an instant, and counting what was asked: what is not shown is not computed.
#pragma once

#include <cstdint>

#include "mechanics/motion.h"

namespace poinsot {

// Evaluations of a motion since its stage was made. Every evaluation gives ω and counts there, and
// again under each further quantity that it was asked for.
struct EvaluationCounts {
    std::int64_t n_omega = 0;
    std::int64_t n_attitude = 0;
    std::int64_t n_herpolhode = 0;
    std::int64_t n_euler_angles = 0;
    std::int64_t n_theta_series = 0;  // those that summed the closed forms' theta series
};

// ω and nothing else: what every evaluation gives.
constexpr Quantities omega_alone{.attitude = false, .herpolhode = false, .euler_angles = false};
// ω and how the body lies.
constexpr Quantities attitude_too{.attitude = true, .herpolhode = false, .euler_angles = false};

// What satisfies both.
constexpr Quantities united(const Quantities& a, const Quantities& b) {
    return {.attitude = a.attitude || b.attitude,
            .herpolhode = a.herpolhode || b.herpolhode,
            .euler_angles = a.euler_angles || b.euler_angles};
}

// A motion that counts what is asked of it. One thread at a time may use it.
class CountedMotion {
 public:
    // The motion must outlive it.
    explicit CountedMotion(const Motion& motion) : motion_(&motion) {}

    MotionSample sample(double time_s, const Quantities& wanted) const {
        count(wanted, 1);
        return motion_->sample(time_s, wanted);
    }

    // For evaluations that another layer makes.
    void count(const Quantities& wanted, std::int64_t n) const {
        counts_.n_omega += n;
        counts_.n_attitude += wanted.attitude ? n : 0;
        counts_.n_herpolhode += wanted.herpolhode ? n : 0;
        counts_.n_euler_angles += wanted.euler_angles ? n : 0;
        counts_.n_theta_series += motion_->sums_theta_series() ? n : 0;
    }

    const Motion& motion() const { return *motion_; }
    const EvaluationCounts& counts() const { return counts_; }

 private:
    const Motion* motion_;
    mutable EvaluationCounts counts_;
};

}  // namespace poinsot
