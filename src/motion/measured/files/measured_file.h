// Reads tables of measured motions from the disk.
#pragma once

#include <filesystem>

#include "measured/measured_motion.h"

namespace poinsot {

// The quantities in each row of a table.
struct MeasuredColumns {
    bool has_omega = false, has_attitude = false;
};

// Hands over row by row, so that a table of any length takes little memory. `begin` is called with
// what the table has, before the first row. Throws as MeasuredReader does, and as read_pieces.
void read_measured(const std::filesystem::path& file,
                   const std::function<void(const MeasuredColumns&)>& begin,
                   const MeasuredReader::TakeRow& take);

// The whole table.
MeasuredMotion load_measured(const std::filesystem::path& file);

}  // namespace poinsot
