#include "cli/quality.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "error/error.h"
#include "error/nearest.h"

namespace poinsot {

namespace {

const std::array<Quality, 4> table{{
    {"draft", 10.0, 1, "coarse curves, fastest encoder: to try a camera"},
    {"lecture", 1.0, 1, "curves within accuracy_px, analytic edges: the default"},
    {"print", 0.5, 2, "2 × 2 samples a pixel on top of analytic edges, small files"},
    {"reference", 0.1, 4, "4 × 4 samples a pixel: what the others are measured against"},
}};

}  // namespace

std::span<const Quality> qualities() { return table; }

const Quality& quality_named(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Quality& quality : table) {
        if (quality.name == name) return quality;
        names.push_back(quality.name);
    }
    throw InputError(fmt::format("unknown quality \"{}\"{}; choose from: {}", printable(name),
                                 did_you_mean(name, names), fmt::join(names, ", ")));
}

}  // namespace poinsot
