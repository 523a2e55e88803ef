// --sweep KEY=a,b,c and KEY=from:to:n: one run for each value; several sweeps give their product.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/option.h"
#include "cli/scenes.h"
#include "scene/override.h"

namespace poinsot {

struct Sweep {
    std::string key;                  // as in --set: "start.omega_rad_s[1]"
    std::vector<std::string> values;  // as in --set
};

// Collects the texts of sweeps, which are parsed together.
Option sweep_option(std::vector<std::string>& sweeps);

// Parses one sweep. Commas within brackets and quotes do not separate values; from:to:n gives the n
// doubles nearest to from + k·(to − from)/(n − 1). Throws InputError.
Sweep parse_sweep(std::string_view text);

// Returns the points of the product, each with a value for each key; the last key changes fastest.
// Without sweeps, one empty point. Throws InputError for a key that is swept twice and for too many
// runs.
using SweepPoint = std::vector<std::pair<std::string, std::string>>;
std::vector<SweepPoint> points_of(const std::vector<std::string>& sweeps);

// Returns the values of a point, for a scene.
std::vector<Override> overrides_of(const SweepPoint& point);

// "start.omega_rad_s[1] = 2, fps = 30"
std::string in_words(const SweepPoint& point);

// Returns the text for a picture's caption, with only the last part of each key: "omega_rad_s[1] =
// 2".
std::string caption_of(const SweepPoint& point);

// Returns the same as a caption with formulas and units: "$\omega_2 = 2$~rad/s". Keys without a
// usual symbol keep their names.
std::string formula_of(const SweepPoint& point);

// Parses "CxR", columns and rows. Throws InputError.
std::pair<int, int> parse_sheet(std::string_view text);

// Like jobs_of in cli/scenes.h, with a job for each scene and point. In the output {KEY} is
// replaced by its value, {key} by that of a single sweep, and #### by the number of the job.
std::vector<SceneJob> jobs_of(const std::vector<std::string>& scenes, const std::string& output,
                              OutputKind kind, const std::vector<std::string>& sweeps);

}  // namespace poinsot
