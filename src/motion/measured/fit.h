// The body behind a measured ω(t) or attitude: the ratios of its moments, its principal axes in the
// instrument's axes, the start and the damping, by least squares on the exact motion.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "measured/measured_motion.h"

namespace poinsot {

// The torque of the air, along the body's principal axes, for moments of inertia I_i:
//   linear: −γ L, which keeps the polhode; axes: −γ_i I_i ω_i; quadratic: −γ_i I_i |ω_i| ω_i;
//   growing: −γ e^(κt) L, as of a body that falls faster and faster, t from the first row on.
enum class DragModel { none, linear, axes, quadratic, growing };
constexpr DragModel drag_models[] = {DragModel::none, DragModel::linear, DragModel::axes,
                                     DragModel::quadratic, DragModel::growing};
std::string_view name_of(DragModel drag);

// A motion that is free but for the air. Uncertainties are standard deviations that the residuals
// imply, as large and as alike from row to row as they are; where the drag is chosen, they include
// the scatter of what the other drags say, weighted by how little they leave.
struct FittedMotion {
    double first_time_s = 0.0;    // of the first row
    Eigen::Vector3d omega_rad_s;  // then, instrument axes
    Eigen::Vector3d omega_sd_rad_s;
    Eigen::Vector3d moments;         // I1 ≥ I2 ≥ I3 over I1: only ratios follow from ω(t)
    Eigen::Vector3d moments_sd;      // the first is 0, and all of them if the moments were given
    std::optional<double> I1_kg_m2;  // if the moments were given
    Eigen::Matrix3d instrument_from_principal;  // a proper rotation, columns e1, e2, e3
    Eigen::Vector3d axes_sd_rad;                // of turns about e1, e2, e3
    DragModel drag = DragModel::linear;
    // γ_i in 1/s, for the quadratic drag in 1/rad; three times the same for the linear one; γ, κ
    // and 0 for the growing one.
    Eigen::Vector3d drag_rates, drag_rates_sd;
    // Where attitudes were fitted: that at the first row, space from instrument, and the standard
    // deviations of its turns about the axes of space.
    std::optional<Eigen::Quaterniond> attitude;
    Eigen::Vector3d attitude_sd_rad = Eigen::Vector3d::Zero();

    // Residuals are in rad/s, of ω, or in rad, of the turn between measured and fitted attitude.
    std::string_view unit() const { return attitude ? "rad" : "rad/s"; }
    double residual = 0.0;         // root mean square of a component
    double linear_residual = 0.0;  // what linear drag leaves
    double noise = 0.0;            // of a component, as the rows scatter from one to the next
    double correlation = 0.0;      // of the residuals from one row to the next
    std::size_t n_rows = 0;        // that were used

    // The tensor in instrument axes, in kg m² if the moments were given, else in units of I1.
    Eigen::Matrix3d tensor() const {
        const Eigen::Matrix3d made = instrument_from_principal *
                                     (I1_kg_m2.value_or(1.0) * moments).asDiagonal() *
                                     instrument_from_principal.transpose();
        return 0.5 * (made + made.transpose());
    }
};

// Fits rows with ω, in order of time; where this is derived from attitudes, the attitudes
// themselves. Of more than 20,000 rows it takes every second, third or so
// on; only the beginning, if the body would turn too far between these. Throws
// InputError for fewer than 30 rows, a body at rest, samples too far apart to follow the turning, a
// turn about one axis, which says nothing about the other moments, motions that no rigid body
// makes, and moments that none has, by more than 2 % and three standard deviations.
// `moments_kg_m2`: the body's principal moments in any order, if they are known; then only
// axes, start and drag are fitted. Without `drag` it is linear where this describes the rows to
// their noise, else the one of `axes`, `quadratic` and `growing` that describes them best;
// `growing` is left out where the motion goes on beyond the rows, since growth cannot be continued.
// Throws EnvironmentError if it is interrupted.
FittedMotion fit_motion(std::span<const MeasuredRow> rows,
                        const std::optional<Eigen::Vector3d>& moments_kg_m2 = {},
                        const std::optional<DragModel>& drag = {}, bool goes_on = false);

// By how much I1 exceeds I2 + I3, in units of I1; no body has more than 0.
double excess_of(const FittedMotion& fit);

// Refuses known moments, in any order, that no body has, by more than 2 %, and three equal ones,
// which any axes fit. Throws InputError; fit_motion and fit_together do, too.
void check_known_moments(const Eigen::Vector3d& moments_kg_m2);

}  // namespace poinsot
