// Least squares for several flights of one body: the numbers of each flight are eliminated from the
// normal equations, and the shared ones remain.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

#include "measured/flight_fit.h"
#include "measured/flight_model.h"

namespace poinsot {

// A flight in units of its rate.
struct JointPart {
    std::vector<MeasuredRow> rows;
    double rate = 0.0, noise = 0.0;
    double weight = 1.0;
    Flight flight;
    double squares = 0.0;
};

// Numbers that all flights share, at most the body's five and three of the drag, and those of one
// that is fitted to ω.
struct JointPlaces {
    std::vector<int> shared, own;
    // Also for a flight that is fitted to attitudes.
    JointPlaces of(const Flight& flight) const;
};

// The places of the fitted numbers in a FlightChange.
JointPlaces joint_places(const std::optional<Eigen::Vector3d>& moments, DragModel drag,
                         bool shares_drag);

// A flight's sums for the shared numbers after its own numbers are eliminated.
struct Reduced {
    Eigen::MatrixXd normal;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd mixed;  // a row for each shared number, a column for each own one
    Eigen::VectorXd own_gradient;
    Eigen::MatrixXd own_normal;
    double squares = 0.0;
};

// Shared drag rates have the units of the table, those of a flight its own.
inline double drag_unit(const JointPart& part, DragModel drag) {
    return drag == DragModel::quadratic ? 1.0 : 1.0 / part.rate;
}

// The sums of a flight with its weight, in the units of the shared drag rates.
FlightSums weighted_sums(const JointPart& part, const Flight& flight, bool shares_drag,
                         std::vector<Eigen::Vector3d>* residuals = nullptr,
                         double correlation = 0.0);

// `trust`: of Levenberg's and Marquardt's method, for the flight's own numbers.
Reduced reduced(const FlightSums& sums, const JointPlaces& places, double trust);

struct JointMinimum {
    std::vector<JointPart> parts;
    double squares = std::numeric_limits<double>::infinity();
};

// Levenberg's and Marquardt's method; the numbers of each flight are eliminated.
JointMinimum minimised_together(std::vector<JointPart> parts, const JointPlaces& places,
                                bool shares_drag);

}  // namespace poinsot
