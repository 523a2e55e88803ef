// Faults of a readable table of measurements: stretches without rows, and values at the limit of
// the sensor.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "measured/measured_motion.h"

namespace poinsot {

// A step from one row to the next of more than three median steps.
struct MeasuredGap {
    std::size_t before = 0;  // the index of the row before it
    double from_s = 0.0, to_s = 0.0;
};

// A component of ω that stays exactly at its extreme value for three rows or more, as at the limit
// of a sensor.
struct Saturation {
    int component = 0;
    double value_rad_s = 0.0;
    std::size_t n_rows = 0;  // of all such stretches
    double from_s = 0.0;     // of the first one
};

std::vector<MeasuredGap> gaps_of(std::span<const MeasuredRow> rows);
// The rows between these times, in stretches without gaps.
std::vector<std::span<const MeasuredRow>> stretches_of(std::span<const MeasuredRow> rows,
                                                       double first_s, double last_s);
// Of rows with ω. A component that is constant in all rows is not saturated.
std::vector<Saturation> saturations_of(std::span<const MeasuredRow> rows);

// The smallest step of this component of ω from one row to the next: what its values are rounded
// to. Infinite if it is constant.
double resolution_of(std::span<const MeasuredRow> rows, int component);

// In words, that the values look like degrees a second or the times like a smaller unit than the
// seconds that they are read as: ω beyond what the gyroscope of a phone measures, or turns from row
// to row that only another unit makes small. Empty if nothing speaks for it.
std::string unit_doubt_of(std::span<const MeasuredRow> rows);

// "omega_y stays at 34.9 rad/s for 12 rows from 1.23 s on: the sensor's limit?"
std::string in_words(const Saturation& saturation);
// "no rows for 0.31 s from 1.2 s on", "no rows in 3 stretches, the longest …"; empty without gaps.
std::string in_words(std::span<const MeasuredGap> gaps);

}  // namespace poinsot
