#include "production/quality.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <vector>

#include "error/error.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// The figures are the rows of `poinsot tradeoff scenes/generic.toml` that bear the names.
const std::array<Quality, 4> table{{
    {"draft",
     10.0,
     1,
     "coarse curves, fastest encoder: to try a camera",
     {3.7, 0.96, 2.7, 10.4, 0.9881}},
    {"lecture",
     1.0,
     1,
     "curves within accuracy_px, analytic edges: the default",
     {3.9, 0.64, 6.6, 5.6, 0.9916}},
    {"print",
     0.5,
     2,
     "2 × 2 samples a pixel on top of analytic edges, small files",
     {19.4, 0.37, 11.6, 6.0, 0.9930}},
    {"reference",
     0.1,
     4,
     "4 × 4 samples a pixel: what the others are measured against",
     {54.5, 0.18, 20.7, 7.7, 0.9948}},
}};

}  // namespace

const std::string_view figures_source =
    "measured 2026-11-22 on an AMD EPYC, 2 cores, processor time; `poinsot tradeoff "
    "scenes/generic.toml` measures them again for src/production/quality.cpp";

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
