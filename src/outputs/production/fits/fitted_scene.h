// The text of a scene that shows a fitted motion.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "measured/fit.h"
#include "measured/measured_motion.h"

namespace poinsot {

struct FittedScene {
    FittedMotion fit;
    std::string from{};                // what it was fitted to; without control characters
    std::vector<std::string> words{};  // about the fit, for its first lines
    double last_time_s = 0.0;          // of the rows
    std::optional<Eigen::Quaterniond> attitude{};  // space from body at the first row
    std::string table{};         // path of the table of the rows, seen from the scene; empty: none
    std::string table_sha256{};  // of the table, if it is written with the scene
};

// The comment of a scene that proves whose table is beside it.
std::string hash_comment(const std::string& table_sha256);

// A scene of the motion with its drag, and the points of its table. ω(t) tells moments up to a
// common factor only: I1 = 1 kg m² unless they were given. The drag is left out, with a comment
// that says why, if it does not differ from 0 or a scene cannot have it.
std::string text_of(const FittedScene& scene);

// The instant of the rows, s, at which the scene's times begin: 0 without drag, since the motion is
// followed back to t = 0; else that of the first row, since a motion under drag cannot be followed
// far back. The table of the scene has times from there on.
double zero_of(const FittedScene& scene);
MeasuredMotion counted_from(MeasuredMotion measured, double zero_s);

}  // namespace poinsot
