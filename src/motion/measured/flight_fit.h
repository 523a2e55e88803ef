// Least squares of flights on measured rows: what the fits of one motion, of flights in a recording
// and of many flights together share.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "measured/flight_model.h"

namespace poinsot {

constexpr std::size_t least_fitted_rows = 30;
// What a fit leaves at most: of ω as a share of the rate, and of attitudes.
constexpr double most_residual_share = 0.05, most_residual_rad = 0.1;

// Whether rows of a motion are compared by their attitudes, since their ω is derived from these.
inline bool has_fitted_attitude(std::span<const MeasuredRow> rows) {
    return !rows.empty() && rows.front().is_omega_derived;
}
// The noise of what is compared: of ω in units of the rate, of attitudes in rad.
double fitted_noise_of(std::span<const MeasuredRow> rows, double rate);

// The root mean square of |ω|.
double rate_of(std::span<const MeasuredRow> rows);
// The noise of a component of ω, as the rows scatter from one to the next. Between uneven instants
// it is too large.
double noise_of(std::span<const MeasuredRow> rows);
// Times from the first row on and ω, in units in which the rate is 1.
std::vector<MeasuredRow> scaled_by(std::span<const MeasuredRow> rows, double rate);

// Which changes of a flight are fitted.
using IsFitted = std::array<bool, most_flight_changes>;
// All, or those that are not known with the moments. `has_attitude`: of a flight that is fitted to
// attitudes.
IsFitted fitted_changes(const std::optional<Eigen::Vector3d>& moments, DragModel drag,
                        bool has_attitude = false);
// Those of start and drag, for a known body; `with_drag` false: of the start alone.
IsFitted fitted_start(DragModel drag, bool has_attitude = false, bool with_drag = true);
int count(const IsFitted& is_fitted);
std::vector<int> places_of(const IsFitted& is_fitted);

Eigen::MatrixXd chosen(const FlightSquare& square, const std::vector<int>& places);

struct FoundFlight {
    Flight flight;
    double squares = std::numeric_limits<double>::infinity();
};
// Root mean square of a component of the residual, of ω or of the attitude in rad, for so many
// fitted numbers.
double residual_of(const FoundFlight& found, std::size_t n_rows, int n_fitted);

// The same for what is seen, whatever was fitted.
double root_mean_square_of(double squares, std::size_t n_rows);

// Levenberg's and Marquardt's method on the rows as a whole. Precondition: rows are near |ω| = 1.
// Throws EnvironmentError if it is interrupted.
FoundFlight minimised(std::span<const MeasuredRow> rows, const Flight& start,
                      const IsFitted& is_fitted, int most_steps);
// To the minimum: in few short rows, moments and start follow a curved valley for hundreds of
// steps.
FoundFlight minimised(std::span<const MeasuredRow> rows, const Flight& start,
                      const IsFitted& is_fitted);
// So many that long tables do not take longer than some seconds.
int steps_to_a_minimum(std::size_t n_rows);
// By how much the largest moment exceeds the sum of the others, in units of the largest; no body
// has more than 0.
double excess_of(const Eigen::Vector3d& moments);
// The error of an instrument's scale and axes makes so much of a lamina's excess.
constexpr double most_excess = 0.02;

// With linear drag, from the starts that Euler's equations give; from those of real bodies where
// these end in a body that cannot be.
FoundFlight best_fit(std::span<const MeasuredRow> rows, double noise,
                     const std::optional<Eigen::Vector3d>& moments);
// Fits a flight of ω to the attitudes of the rows. `noise`: of these, in rad.
FoundFlight with_attitude(std::span<const MeasuredRow> rows, const Flight& of_omega, double noise,
                          const IsFitted& is_fitted);
// The rates of this drag that a fit begins with, after a linear fit.
Eigen::Vector3d first_rates(DragModel drag, double damping);
// With this drag, from the linear fit on.
FoundFlight with_drag(std::span<const MeasuredRow> rows, const FoundFlight& linear, DragModel drag,
                      const std::optional<Eigen::Vector3d>& moments);

// I1 ≥ I2 ≥ I3 in units of I1, and axes whose largest components are positive.
Flight in_order(const Flight& flight);
// The variance of a component of the residuals, of which `n_taken` values are as good as fitted:
// tr(N⁻¹S) of the sums' normal matrix N and spread S. Residuals that are alike for many rows are
// few values, and a fit takes more of them than it has numbers: E rᵀr = σ² tr((1 − JN⁻¹Jᵀ)C) =
// σ²(3n − tr N⁻¹S).
double variance_of(double squares, std::size_t n_rows, double n_taken);
// How much the residual of a row is like that of the row before it.
double correlation_of(const std::vector<Eigen::Vector3d>& residuals);

}  // namespace poinsot
