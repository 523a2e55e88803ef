// What the command line said, as plain values; every command reads the ones that its row names.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace poinsot {

struct Options {
    std::vector<std::string> arguments;  // SCENE, REF NEW, WHAT
    std::string output;                  // -o
    std::vector<std::string> overrides;  // --set key=value, and --size, --fps, --quality as such
    std::optional<std::pair<std::int64_t, std::int64_t>> frames;  // --frames A-B, inclusive
    std::optional<double> time_s;                                 // --time
    std::vector<double> times_s;                                  // --times
    std::string backend = "auto";                                 // --backend
    bool portable = false;                                        // --portable
    bool json = false;
    bool quiet = false;
    bool certify = false;  // render --certify
    bool plan = false;     // check --plan
};

}  // namespace poinsot
