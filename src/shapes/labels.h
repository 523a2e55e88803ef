// Type as coverage, placed in the picture.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "shapes/colour.h"

namespace poinsot {

// A shape already flattened to the picture that is looked at: glyph outlines and rules as one
// coverage mask. In a picture drawn with several samples a pixel each of the mask's pixels is
// `samples` of the picture's a side, and all samples of a pixel show the same ink: their mean is
// the type that one sample a pixel shows.
struct GlyphMask {
    std::uint64_t id = 0;  // unique for its pixels
    int width = 0, height = 0;
    int samples = 1;
    std::vector<std::uint8_t> coverage;  // row 0 on top

    // In pixels of the picture that is drawn.
    int width_px() const { return samples * width; }
    int height_px() const { return samples * height; }
};

// Type set beforehand (typeset/), placed in pixels of the whole picture, drawn over everything of
// its view.
struct Label {
    const GlyphMask* mask = nullptr;
    Eigen::Vector2d top_left_px =
        Eigen::Vector2d::Zero();  // picture pixels, y down; whole pixels keep it crisp
    Colour colour;
    Colour halo_colour{1.0, 1.0, 1.0};
    double halo_px = 0.0;
    double opacity = 1.0;
};

}  // namespace poinsot
