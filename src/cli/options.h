// What the command line said, as plain values; every command reads the ones that its row names.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "production/print_size.h"

namespace poinsot {

// What compare allows to differ, and what it writes.
struct CompareChoices {
    std::string profile = "portable";          // --profile
    std::optional<std::string> max_differing;  // --max-differing, a share of the pixels
    std::optional<std::string> max_over;       // --max-over
    std::optional<int> over_levels;            // --over-levels
    std::string report, junit, diff;           // files to write, empty for none
};

// What approve takes from where to where.
struct ApproveChoices {
    std::string results, baselines;  // folders
    std::string why;
    bool any_renderer = false;
    bool all = false;
};

struct Options {
    std::vector<std::string> arguments;  // SCENE, REF NEW, WHAT
    std::string output;                  // -o
    std::vector<std::string> overrides;  // --set key=value, and --size, --fps, --quality as such
    std::optional<std::pair<std::int64_t, std::int64_t>> frames;  // --frames A-B, inclusive
    std::optional<double> time_s;                                 // --time
    std::vector<double> times_s;                                  // --times
    std::string backend = "auto";                                 // --backend
    bool portable = false;                                        // --portable
    bool allow_outside = false;                                   // --allow-outside
    bool json = false;
    bool quiet = false;
    bool certify = false;   // render --certify
    bool plan = false;      // check --plan
    bool verify = false;    // explain --verify
    bool all_rows = false;  // tradeoff --all
    PrintChoices print;
    CompareChoices compare;
    ApproveChoices approve;
};

}  // namespace poinsot
