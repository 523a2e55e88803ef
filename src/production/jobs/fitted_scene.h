// The text of a scene that shows a fitted motion.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "measured/fit.h"

namespace poinsot {

struct FittedScene {
    FittedMotion fit;
    std::string from{};                // what it was fitted to; without control characters
    std::vector<std::string> words{};  // about the fit, for its first lines
    double last_time_s = 0.0;          // of the rows
    std::optional<Eigen::Quaterniond> attitude{};  // space from body at the first row
    std::string table{};  // path of the table of the rows, seen from the scene; empty: none
};

// A scene of the motion without its drag, with the points of its table. Its times are those of the
// rows: the motion is followed back to t = 0. ω(t) tells moments up to a common factor only: I1 =
// 1 kg m² unless they were given.
std::string text_of(const FittedScene& scene);

}  // namespace poinsot
