// Fitted motions as `poinsot fit` reports them: in words, and as members of JSON.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "measured/fit.h"
#include "measured/measured_motion.h"
#include "text/json_text.h"

namespace poinsot {

// As many decimals as the standard deviation has a say in.
std::string with_sd(double value, double sd);

// A matrix row by row: principal axes are its columns.
std::string json_of(const Eigen::Matrix3d& matrix);
void add_fit(JsonObject& answer, const FittedMotion& fit);
// The residual, under a name that has its unit.
void add_residual(JsonObject& answer, const FittedMotion& fit);

// The body of a FittedMotion or a JointFit, a line each: its moments or their ratios, after
// `before`, and its axes.
template <typename Fit>
std::vector<std::string> body_lines(const Fit& fit, std::string_view before = "");

// What the reader of a fit must know: moments or axes that it does not tell, a residual that is not
// noise, faults of the table. A line each.
std::vector<std::string> notes_of(const FittedMotion& fit, const MeasuredMotion& measured);

// The results, a line each: for the console, and as comments of the scene.
std::vector<std::string> result_lines(const FittedMotion& fit);

}  // namespace poinsot
