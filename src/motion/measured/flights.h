// The stretches of a recording in which the body flies freely, among walking, throwing and
// catching.
#pragma once

#include <span>
#include <vector>

#include "measured/measured_motion.h"

namespace poinsot {

// A stretch in which ω(t) is the motion of some free body, with air that brakes it.
struct FreeFlight {
    std::vector<MeasuredRow> rows;  // without those at the limit of the sensor
    double rate_rad_s = 0.0;        // root mean square of |ω|
    double turn_rad = 0.0;          // the angle through which the body turned, ∫|ω| dt
    double residual_rad_s = 0.0;    // root mean square of a component
    double noise_rad_s = 0.0;       // of a component, as the rows scatter from one to the next
    double begin_s() const { return rows.front().time_s; }
    double end_s() const { return rows.back().time_s; }
};

// Finds the flights of a recording of ω, in order of time. A flight has 30 rows or more, turns
// the body by 3.5 rad or more, and leaves residuals of at most 3 % of |ω|; its axis of rotation
// wanders through the body, since any motion about a fixed axis is that of a free body. Rows at
// which the sensor stays at its limit are left out; a flight may reach across them, and across gaps
// of less than a radian.
std::vector<FreeFlight> flights_of(std::span<const MeasuredRow> rows);

}  // namespace poinsot
