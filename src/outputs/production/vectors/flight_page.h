// Charts of fitted flights as vectors.
#pragma once

#include <span>
#include <string>

#include "drawing/figures/charts/flight_chart.h"
#include "measured/fit.h"
#include "measured/measured_motion.h"

namespace poinsot {

// The rows of a flight and the motion that was fitted to them, without a name and ratios. Throws
// InputError if the motion does not reach a row.
ChartedFlight charted(const FittedMotion& fit, std::span<const MeasuredRow> rows);

// The bytes of a PDF or an SVG, 203 mm wide. `title`: the document's, plain text. Throws
// EnvironmentError if a font cannot be read.
std::string flight_page(const FlightChart& chart, const std::string& title, bool is_svg);

}  // namespace poinsot
