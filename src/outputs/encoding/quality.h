// The settings of encoders for each --quality, and the measured results of the whole; those of
// drawings are in drawing/style/picture_quality.h.
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
    X264Effort x264;
    Vp9Effort vp9;
    std::string_view summary;
    QualityFigures figures;
};

std::span<const Quality> qualities();

// Returns a quality by name. Throws InputError with the nearest name.
const Quality& quality_named(std::string_view name);

}  // namespace poinsot
