// Type as coverage, placed in the picture.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "shapes/colour.h"

namespace poinsot {

// A glyph of set type, for renderers that draw outlines or write text. Pixels of the mask from its
// upper left corner, y down.
struct MaskLetter {
    const std::filesystem::path* font_file = nullptr;  // outlives the drawings that show it
    std::uint32_t glyph = 0;                           // by its number in the font
    double x_px = 0.0, baseline_px = 0.0;
    double em_px = 0.0;
};

// A filled rectangle of set type: the bar of a fraction.
struct MaskRule {
    double left_px = 0.0, top_px = 0.0, width_px = 0.0, height_px = 0.0;
};

// What was set, for renderers that leave setting to another: the string as typeset/ takes it.
struct SetText {
    std::string text;
    bool is_formula = true;     // else running text with formulas
    double em_px = 0.0;         // of the mask's pixels, as are these
    double baseline_px = 0.0;   // the first line's, from the mask's upper side
    double max_width_px = 0.0;  // of its lines; 0: it has one
};

// A shape already flattened to the picture that is looked at: glyph outlines and rules as one
// coverage mask. In a picture drawn with several samples a pixel each of the mask's pixels is
// `samples` of the picture's a side, and all samples of a pixel show the same ink: their mean is
// the type that one sample a pixel shows.
struct GlyphMask {
    std::uint64_t id = 0;  // unique for its pixels
    int width = 0, height = 0;
    int samples = 1;
    std::vector<std::uint8_t> coverage;  // row 0 on top
    std::vector<MaskLetter> letters;     // what the coverage shows
    std::vector<MaskRule> rules;
    SetText source;

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
    // From the left, the share of its width that stays in place where another sets its text and
    // makes it wider or narrower.
    double held_at = 0.5;
    int rank = 0;  // where there is no room for all on paper, what has a higher one is left out
};

}  // namespace poinsot
