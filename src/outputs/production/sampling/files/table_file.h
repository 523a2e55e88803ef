// Writes a table of samples to a file.
#pragma once

#include <filesystem>

#include "production/sampling/sample_table.h"

namespace poinsot {

// Writes atomically. Throws EnvironmentError.
void write_table(const SampleTable& table, const TableFormat& format,
                 const std::filesystem::path& path);

}  // namespace poinsot
