// One body behind many flights: its moments and axes, and the start and drag of each flight, by
// least squares on all rows together.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "measured/fit.h"
#include "measured/measured_motion.h"

namespace poinsot {

// A flight, as the body of all describes it.
struct JointFlight {
    std::optional<FittedMotion> own;  // fitted alone; none if its rows alone do not tell the body
    std::string left_out;             // why it does not count; empty if it counts
    double first_time_s = 0.0;
    Eigen::Vector3d omega_rad_s = Eigen::Vector3d::Zero();  // at the first row, instrument axes
    Eigen::Vector3d drag_rates = Eigen::Vector3d::Zero();   // as in FittedMotion
    double rate_rad_s = 0.0;                                // root mean square of |ω|
    // With this body, the root mean square of a component: of ω in rad/s, or of attitudes in rad.
    double residual = 0.0;
    std::optional<Eigen::Quaterniond> attitude;  // as in FittedMotion
    std::size_t n_rows = 0;
    // The body without this flight: a step of least squares from the joint one, for changes as in
    // JointFit::covariance.
    Eigen::Matrix<double, 5, 1> change_without = Eigen::Matrix<double, 5, 1>::Zero();
};

struct JointFit {
    Eigen::Vector3d moments, moments_sd;  // I1 ≥ I2 ≥ I3 in units of I1
    std::optional<double> I1_kg_m2;       // if the moments were given
    Eigen::Matrix3d instrument_from_principal;
    Eigen::Vector3d axes_sd_rad;  // of turns about e1, e2, e3
    // Of ln I2, ln I3 and turns about e1, e2, e3.
    Eigen::Matrix<double, 5, 5> covariance = Eigen::Matrix<double, 5, 5>::Zero();
    DragModel drag = DragModel::linear;
    bool shares_drag = false;
    Eigen::Vector3d drag_rates, drag_rates_sd;  // if the flights share them
    // Root mean square of the flights that count, of ω and of attitudes, if some are of these.
    std::optional<double> residual_rad_s, residual_rad;
    std::size_t n_used = 0, n_rows = 0;
    std::vector<JointFlight> flights;
};

// A flight is left out if a ratio of its moments or an axis of its own fit lies farther than this
// from the median of the flights, in units of its own standard deviation and 1.4826 times the
// median distance, added as squares, and if the body of the most typical flight leaves a residual
// larger than its own by this factor. The rule needs five flights.
constexpr double outlier_deviations = 5.0, outlier_residuals = 2.0;

// Flights that hold the same rows: their indices, the smaller one first. Half of the rows of the
// shorter one are enough, so that a part of a flight counts as the flight.
std::optional<std::pair<std::size_t, std::size_t>> repeated_flight(
    std::span<const std::span<const MeasuredRow>> flights);

// Fits flights of one body. Flights count by their own residuals. The standard deviations are the
// larger of those that residuals within the flights imply and those that the scatter from flight to
// flight implies (the jackknife of three or more flights). Throws InputError if fewer than two
// flights count, if one
// of them repeats another, if together they do not tell the body, and as fit_motion does.
JointFit fit_together(std::span<const std::span<const MeasuredRow>> flights,
                      const std::optional<Eigen::Vector3d>& moments_kg_m2 = {},
                      const std::optional<DragModel>& drag = {}, bool shares_drag = false);

// A flight of a joint fit as a motion of the body of all. Deviations of its start, noise and
// correlation are not known and 0.
FittedMotion motion_of(const JointFit& joint, const JointFlight& flight);

}  // namespace poinsot
