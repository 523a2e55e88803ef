// The meaning of the --quality names: settings of the picture and of each encoder, and their
// measured results.
#pragma once

#include <span>
#include <string_view>

namespace poinsot {

// Results of `poinsot tradeoff` for a quality: processor time, and the errors relative to the
// reference picture and to the encoded frames.
struct QualityFigures {
    double picture_ms;  // a frame of 960 × 540
    double rms_levels;  // its error, of 255 levels
    double film_ms;     // encoding a frame of 960 × 540
    double film_kB;     // its size
    double film_ssim;   // structural similarity
};

// Settings in the encoders' own terms.
struct X264Effort {
    const char *preset, *crf, *parameters;
};
struct Vp9Effort {
    const char *deadline, *speed, *crf;
};

struct Quality {
    std::string_view name;
    double curve_tolerance;  // factor on the scene's accuracy_px for the sampling of curves
    int samples;  // the picture is rendered samples × samples times as large and averaged
    X264Effort x264;
    Vp9Effort vp9;
    std::string_view summary;
    QualityFigures figures;
};

std::span<const Quality> qualities();

// Returns a quality by name. Throws InputError with the nearest name.
const Quality& quality_named(std::string_view name);

}  // namespace poinsot
