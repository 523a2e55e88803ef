// Predictions of the later rows of a flight from its first rows.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "measured/fit.h"
#include "measured/joint_fit.h"
#include "measured/measured_motion.h"

namespace poinsot {

// ω of a fitted motion at these instants, in any order, in rad/s and instrument axes. Motions
// without drag or with linear drag reach every instant, the others only those from the first row
// on. Throws InputError for other instants, and for those that are not finite.
std::vector<Eigen::Vector3d> omega_of(const FittedMotion& fit, std::span<const double> times_s);

// Measured less fitted, in instrument axes: ω in rad/s or, where attitudes were fitted, the turn
// from the fitted attitude to the measured one in rad. The first row is that of the fit. Throws as
// omega_of does.
std::vector<Eigen::Vector3d> residuals_of(const FittedMotion& fit,
                                          std::span<const MeasuredRow> rows);

// A number with its standard deviation.
struct Predicted {
    double value = 0.0, sd = 0.0;
};

struct Prediction {
    std::size_t n_fitted = 0, n_rest = 0;  // rows
    // Of ω in rad/s or, where attitudes are fitted, of the turn to the predicted attitude in rad.
    bool has_attitude = false;
    double residual = 0.0;  // of a component, in the fitted rows
    double rms = 0.0;       // root mean square of |ω − predicted| in the others
    double largest = 0.0;   // the largest, and its instant
    double largest_at_s = 0.0;
    // The time in which ω returns in body axes, if there were no drag from the first row on; none
    // on the separatrix. Measured: by a fit of all rows.
    std::optional<Predicted> period_s;
    std::optional<double> measured_period_s;
    // The flip: the first instant after the fitted rows at which ω along e2 changes its sign.
    // Measured: between two rows.
    std::optional<Predicted> flip_s;
    std::optional<double> measured_flip_s;
};

// From the first `n_fitted` rows alone: body, start and drag. Throws InputError as fit_motion does,
// and if no row is left.
Prediction predicted_alone(std::span<const MeasuredRow> rows, std::size_t n_fitted,
                           const std::optional<Eigen::Vector3d>& moments_kg_m2 = {},
                           const std::optional<DragModel>& drag = {});

// With the body and the drag that the other flights of a joint fit say, so that the rows fix only
// the start: `rows` is the flight of this index. Throws InputError for fewer than 3 rows, and if no
// row is left.
Prediction predicted_by_others(std::span<const MeasuredRow> rows, std::size_t n_fitted,
                               const JointFit& joint, std::size_t index);

}  // namespace poinsot
