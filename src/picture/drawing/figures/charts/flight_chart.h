// A chart of fitted flights: measured and fitted ω, the residuals below and, for several flights of
// one body, the ratios of its moments from flight to flight.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "drawing/figures/charts/chart_canvas.h"

namespace poinsot {

// ω in rad/s, in the axes of the instrument; times in s.
struct ChartedFlight {
    std::string name;  // a caption above its charts; may be empty
    std::vector<double> times_s;
    std::vector<Eigen::Vector3d> measured;   // ω at these times
    std::vector<Eigen::Vector3d> residuals;  // measured less fitted: ω or turns of the attitude
    std::string residual_unit = "rad/s";
    std::vector<double> curve_times_s;
    std::vector<Eigen::Vector3d> curve;  // the fitted motion at those
    // I2/I1 and I3/I1 of this flight alone, with their standard deviations.
    std::optional<Eigen::Vector2d> ratios, ratios_sd;
    bool is_left_out = false;  // of the body of all
};

struct FlightChart {
    std::string title;  // a caption
    std::vector<ChartedFlight> flights;
    // Of all flights together; drawn if two flights or more have their own.
    std::optional<Eigen::Vector2d> ratios, ratios_sd;
};

// Holds the geometry and text of the drawing, which must not outlive it. It is 1600 pixels wide;
// its height follows from the number of flights. Precondition: there is a flight, and each has two
// rows or more.
class FlightSheet {
 public:
    FlightSheet(const FlightChart& chart, const Theme& theme, FontSource fonts);

    Drawing drawing() const { return canvas_.drawing(); }

 private:
    ChartCanvas canvas_;
};

}  // namespace poinsot
