// The body behind a measured ω(t): the ratios of its moments, its principal axes in the
// instrument's axes, the start and the damping, by least squares on the exact motion.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>

#include "measured/measured_motion.h"

namespace poinsot {

// A free motion, damped by a torque N = −γL: this keeps the polhode, and
// ω(t) = e^(−γt) ω_free((1 − e^(−γt))/γ), so that the damped motion is exact at any instant, too.
// Uncertainties are standard deviations that the scatter of the residuals implies.
struct FittedMotion {
    double first_time_s = 0.0;    // of the first row
    Eigen::Vector3d omega_rad_s;  // then, instrument axes
    Eigen::Vector3d omega_sd_rad_s;
    Eigen::Vector3d moments;         // I1 ≥ I2 ≥ I3 in units of I1: ω(t) says no more
    Eigen::Vector3d moments_sd;      // the first is 0, and all of them if the moments were given
    std::optional<double> I1_kg_m2;  // if the moments were given
    Eigen::Matrix3d instrument_from_principal;  // a proper rotation, columns e1, e2, e3
    Eigen::Vector3d axes_sd_rad;                // of turns about e1, e2, e3
    double damping_1_s = 0.0, damping_sd_1_s = 0.0;
    double residual_rad_s = 0.0;  // root mean square of a component of ω
    std::size_t n_rows = 0;       // that were used

    double noise_rad_s = 0.0;  // of a component, as the rows scatter from one to the next

    // The tensor in instrument axes, in kg m² if the moments were given, else in units of I1.
    Eigen::Matrix3d tensor() const {
        const Eigen::Matrix3d made = instrument_from_principal *
                                     (I1_kg_m2.value_or(1.0) * moments).asDiagonal() *
                                     instrument_from_principal.transpose();
        return 0.5 * (made + made.transpose());
    }
};

// Fits rows with ω, in order of time. Of more than 20,000 rows it takes every second, third or so
// on; only the beginning, if the body would turn too far between these. Throws
// InputError for fewer than 30 rows, a body at rest, samples too far apart to follow the turning, a
// turn about one axis, which says nothing about the other moments, and motions that no rigid body
// makes. `moments_kg_m2`: the body's principal moments in any order, if they are known; then only
// axes, start and damping are fitted.
FittedMotion fit_motion(std::span<const MeasuredRow> rows,
                        const std::optional<Eigen::Vector3d>& moments_kg_m2 = {});

}  // namespace poinsot
