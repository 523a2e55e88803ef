// Writes a chart as a picture.
#pragma once

#include <filesystem>
#include <string>

#include "drawing/figures/charts/chart.h"
#include "drawing/figures/charts/flight_chart.h"
#include "production/stills/picture.h"

namespace poinsot {

// A PNG of 1600 × 1000. Throws EnvironmentError, and InputError if no point can be shown.
void write_chart(const Chart& chart, const ContextChoice& context,
                 const std::filesystem::path& path);

// Whether charts of flights are written under such a name: .svg, .pdf or .png.
bool is_flight_chart_name(const std::filesystem::path& path);
// A page of vectors, or a PNG of 1600 pixels across. Throws EnvironmentError.
void write_chart(const FlightChart& chart, const std::string& title,
                 const std::filesystem::path& path);

}  // namespace poinsot
