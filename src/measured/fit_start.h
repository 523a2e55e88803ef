// Where the fit of a flight starts: moments, axes and damping from Euler's equations, which are
// linear in the tensor of inertia.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "measured/flight_model.h"

namespace poinsot {

// What is tried, best first. The equations are integrated over windows of some angle, so that noise
// is not differentiated; `moments` in falling order, if they are known. Precondition: rows are near
// |ω| = 1, so that times are radians.
std::vector<Flight> first_flights(std::span<const MeasuredRow> rows,
                                  const std::optional<Eigen::Vector3d>& moments);

}  // namespace poinsot
