// --sweep KEY=a,b,c and KEY=from:to:n: one run for each value; several sweeps give their product.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/option.h"
#include "cli/scenes.h"

namespace poinsot {

struct Sweep {
    std::string key;                  // as --set has it: "start.omega_rad_s[1]"
    std::vector<std::string> values;  // as --set has them
};

// Texts of sweeps, to be read when all are there.
Option sweep_option(std::vector<std::string>& sweeps);

// Reads one. Commas within brackets and quotes part no values; from:to:n gives the n doubles
// nearest to from + k·(to − from)/(n − 1). Throws InputError.
Sweep parse_sweep(std::string_view text);

// A value for each key, the last key's changing fastest. One empty point without sweeps. Throws
// InputError for a key that is swept twice and for more runs than anyone waits for.
using SweepPoint = std::vector<std::pair<std::string, std::string>>;
std::vector<SweepPoint> points_of(const std::vector<std::string>& sweeps);

// As --set takes them: "start.omega_rad_s[1]=2".
std::vector<std::string> overrides_of(const SweepPoint& point);

// "start.omega_rad_s[1] = 2, fps = 30"
std::string in_words(const SweepPoint& point);

// The same for a picture's caption: of each key its last name alone, "omega_rad_s[1] = 2".
std::string caption_of(const SweepPoint& point);

// "CxR" of columns and rows. Throws InputError.
std::pair<int, int> parse_sheet(std::string_view text);

// As jobs_of of cli/scenes.h, for each scene a job for each point. In the output {KEY} becomes its
// value, {key} that of a single sweep, and #### counts all jobs.
std::vector<SceneJob> jobs_of(const std::vector<std::string>& scenes, const std::string& output,
                              OutputKind kind, const std::vector<std::string>& sweeps);

}  // namespace poinsot
