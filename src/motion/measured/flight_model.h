// ω(t) or the attitude of a rigid body in free flight through air, with its derivatives with
// respect to moments, axes, start and drag, evaluated together.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "measured/fit.h"
#include "measured/measured_motion.h"

namespace poinsot {

// The body, its start and the air. Times are taken from the first row on.
struct Flight {
    Eigen::Vector3d moments = Eigen::Vector3d::Ones();   // in any unit
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // instrument from principal
    Eigen::Vector3d omega = Eigen::Vector3d::Zero();     // at the first row, instrument axes
    DragModel drag = DragModel::linear;
    Eigen::Vector3d drag_rates = Eigen::Vector3d::Zero();  // γ_i, or γ and κ: see DragModel
    // Space from instrument at the first row. A flight that has it is compared with the attitudes
    // of rows, one that does not with their ω.
    std::optional<Eigen::Quaterniond> attitude{};
};

// Small changes of a flight, in this order: ln I2 and ln I3, turns about e1, e2, e3, the three
// components of ω at the first row, the rates of the drag (one for `linear`, two for `growing`),
// and turns of the attitude at the first row about the axes of space.
constexpr int n_of_body = 5, first_of_omega = 5, first_of_drag = 8, first_of_attitude = 11;
constexpr int most_flight_changes = 14;
// But for the attitude.
int n_changes(DragModel drag);
using FlightChange = Eigen::Matrix<double, most_flight_changes, 1>;
using FlightDerivative = Eigen::Matrix<double, 3, most_flight_changes>;
Flight changed(const Flight& flight, const FlightChange& by);

// Sums over the rows of squares and products of the residuals r and of their derivatives J. r is
// the model's ω less the measured one; of attitudes the small turn from the measured one to the
// model's, log(q_measured⁻¹ q) in rad and instrument axes.
using FlightSquare = Eigen::Matrix<double, most_flight_changes, most_flight_changes>;
struct FlightSums {
    double squares = 0.0;                          // rᵀr
    FlightChange gradient = FlightChange::Zero();  // Jᵀr
    FlightSquare normal = FlightSquare::Zero();    // JᵀJ
    FlightSquare spread = FlightSquare::Zero();    // JᵀCJ, if it is wanted
};

// The sums; infinite squares for a flight that leaves the range of numbers. The derivatives are
// those of a motion stepped by Runge and Kutta's method; ω is in closed form but for the drags that
// have none. `residuals` gets r of each row, if it is given. C is the correlation of residuals of
// which each is like the one before it by this `correlation`, and like the row before that by its
// square. Precondition: rows are near |ω| = 1,
// so that times are radians.
FlightSums flight_sums(const Flight& flight, std::span<const MeasuredRow> rows,
                       std::vector<Eigen::Vector3d>* residuals = nullptr, double correlation = 0.0);

// ω at these times since the first row, instrument axes.
std::vector<Eigen::Vector3d> flight_omega(const Flight& flight, std::span<const double> times);

}  // namespace poinsot
