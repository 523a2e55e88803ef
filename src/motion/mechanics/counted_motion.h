// A motion that counts its evaluations, to show that nothing is computed that is not shown.
#pragma once

#include <cstdint>

#include "mechanics/motion.h"

namespace poinsot {

// Number of evaluations of a motion since the count began. Every evaluation gives ω and is
// counted there, and also under each further quantity that was requested.
struct EvaluationCounts {
    std::int64_t n_omega = 0;
    std::int64_t n_attitude = 0;
    std::int64_t n_herpolhode = 0;
    std::int64_t n_euler_angles = 0;
    std::int64_t n_theta_series = 0;  // evaluations that summed the theta series of the closed form
};

// Only ω, which every evaluation gives.
constexpr Quantities omega_alone{.attitude = false, .herpolhode = false, .euler_angles = false};
// ω and the attitude.
constexpr Quantities attitude_too{.attitude = true, .herpolhode = false, .euler_angles = false};

// The quantities of both.
constexpr Quantities united(const Quantities& a, const Quantities& b) {
    return {.attitude = a.attitude || b.attitude,
            .herpolhode = a.herpolhode || b.herpolhode,
            .euler_angles = a.euler_angles || b.euler_angles};
}

// A motion that counts its evaluations. Not thread-safe.
class CountedMotion {
 public:
    // The motion must outlive it.
    explicit CountedMotion(const Motion& motion) : motion_(&motion) {}

    MotionSample sample(double time_s, const Quantities& wanted) const {
        count(wanted, 1);
        return motion_->sample(time_s, wanted);
    }

    // Counts evaluations that another layer makes.
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
