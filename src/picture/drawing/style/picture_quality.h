// The meaning of the names of --quality for drawings; that for encoders is in output/quality.h.
#pragma once

#include <span>
#include <string_view>

namespace poinsot {

struct PictureQuality {
    std::string_view name;
    double curve_tolerance;  // of sampled curves: factor on half of the scene's accuracy_px
    int samples;  // the picture is rendered samples × samples times as large and averaged
};

std::span<const PictureQuality> picture_qualities();

// Returns a quality by name. Throws InputError with the nearest name.
const PictureQuality& picture_quality_named(std::string_view name);

}  // namespace poinsot
