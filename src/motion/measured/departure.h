// Errors of a measured motion against the exact motion: of attitude and ω, and the drift of the
// constants that Euler's equations keep.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "measured/measured_motion.h"
#include "mechanics/motion.h"

namespace poinsot {

// A largest value, and the instant of it.
struct Peak {
    double value = 0.0;
    double time_s = 0.0;
    void take(double candidate, double at_s) {
        if (candidate > value) *this = {candidate, at_s};
    }
};

// Quantities missing in the table are absent. T, L and ω are compared as shares of their exact
// values, energy and momentum only of torque-free motions; the momentum's direction needs attitude
// and ω.
struct DepartureAt {
    double time_s = 0.0;
    std::optional<double> attitude_rad;       // angle of the rotation from the exact attitude
    std::optional<double> omega_rad_s;        // |ω − exact|
    std::optional<double> omega_share;        // |ω − exact| / |exact|
    std::optional<double> energy_share;       // T / exact − 1
    std::optional<double> momentum_share;     // |L| / exact − 1
    std::optional<double> momentum_tilt_rad;  // between L in space and the exact L
};

// Compares row by row, so that a table of any length takes little memory.
class Departure {
 public:
    // The motion must live as long; it must reach every instant that is compared.
    explicit Departure(const Motion& motion);

    // Throws InputError as Motion::sample does.
    void add(const MeasuredRow& row, bool has_omega, bool has_attitude);

    std::size_t n_rows() const { return n_rows_; }
    double first_time_s() const { return first_time_s_; }
    const DepartureAt& last() const { return last_; }
    // The largest of each, as absolute values.
    const Peak& attitude_rad() const { return attitude_rad_; }
    const Peak& omega_share() const { return omega_share_; }
    const Peak& energy_share() const { return energy_share_; }
    const Peak& momentum_share() const { return momentum_share_; }
    const Peak& momentum_tilt_rad() const { return momentum_tilt_rad_; }
    // Some hundred instants over the whole table, evenly spread and each with the largest values of
    // its neighbourhood, for a chart.
    const std::vector<DepartureAt>& outline() const { return outline_; }

 private:
    void note(const DepartureAt& at);

    const Motion* motion_;
    Eigen::Matrix3d tensor_body_;
    bool is_free_ = false;
    double energy_J_ = 0.0;
    Eigen::Vector3d momentum_space_ = Eigen::Vector3d::Zero();
    std::size_t n_rows_ = 0, rows_a_place_ = 1, rows_in_last_ = 0;
    double first_time_s_ = 0.0;
    DepartureAt last_;
    Peak attitude_rad_, omega_share_, energy_share_, momentum_share_, momentum_tilt_rad_;
    std::vector<DepartureAt> outline_;
};

}  // namespace poinsot
