// Initial values for the fit of a flight: moments, axes and damping from Euler's equations, which
// are linear in the tensor of inertia.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "measured/flight_model.h"

namespace poinsot {

// Initial values to try, best first. The equations are integrated over windows of some angle, so
// that noise is not differentiated; `moments` in falling order, if they are known. Precondition:
// rows are near |ω| = 1, so that times are radians.
std::vector<Flight> first_flights(std::span<const MeasuredRow> rows,
                                  const std::optional<Eigen::Vector3d>& moments);

// Initial values of real bodies, whatever Euler's equations say: their axes are those along which ω
// scatters, in each order. Precondition as above.
std::vector<Flight> physical_flights(std::span<const MeasuredRow> rows);

// The distance of these rows from any free motion: the share of the changes of the angular
// momentum, over windows of 0.7 rad, that Euler's equations leave unexplained for the tensor that
// explains most. About 0 for a free motion and 1 for any other; larger by noise. Rows in their own
// units.
double unexplained_share(std::span<const MeasuredRow> rows);

}  // namespace poinsot
