// What the names of --quality mean for the picture; what they mean for an encoder stands with the
// encoders.
#pragma once

#include <span>
#include <string_view>

namespace poinsot {

struct Quality {
    std::string_view name;
    double curve_tolerance;  // factor on the scene's accuracy_px for the sampling of curves
    int samples;             // the picture is drawn samples × samples times as large and averaged
    std::string_view summary;  // what it costs and gives, from `poinsot tradeoff`
};

std::span<const Quality> qualities();

// Throws InputError with the nearest name.
const Quality& quality_named(std::string_view name);

}  // namespace poinsot
