// Writes a chart as a picture.
#pragma once

#include <filesystem>

#include "drawing/figures/charts/chart.h"
#include "production/jobs/picture.h"

namespace poinsot {

// A PNG of 1600 × 1000. Throws EnvironmentError, and InputError if no point can be shown.
void write_chart(const Chart& chart, const ContextChoice& context,
                 const std::filesystem::path& path);

}  // namespace poinsot
