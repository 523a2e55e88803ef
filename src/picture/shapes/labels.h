// Typeset text as coverage masks, placed in the picture.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shapes/colour.h"
#include "shapes/shape_name.h"

namespace poinsot {

// A glyph of typeset text, for renderers that draw outlines or write text. Positions are in pixels
// of the mask from its upper left corner, y down.
struct MaskLetter {
    const std::filesystem::path* font_file = nullptr;  // outlives the drawings that use it
    std::uint32_t glyph = 0;                           // glyph number in the font
    double x_px = 0.0, baseline_px = 0.0;
    double em_px = 0.0;
    int tint = 0;
};

// A filled rectangle of typeset text, such as the bar of a fraction.
struct MaskRule {
    double left_px = 0.0, top_px = 0.0, width_px = 0.0, height_px = 0.0;
};

// The text of a mask, for programs that typeset it themselves: the string in the grammar of
// typeset/.
struct SetText {
    std::string text;
    bool is_formula = true;     // false: running text with formulas
    double em_px = 0.0;         // in pixels of the mask, as the following members
    double baseline_px = 0.0;   // of the first line, from the mask's upper side
    double max_width_px = 0.0;  // of its lines; 0: one line
};

// Typeset text as one coverage mask of glyph outlines and rules. If a picture is drawn with several
// samples per pixel, each pixel of the mask is a square of `samples` × `samples` picture pixels,
// and all samples of a pixel have the same ink, so that their mean equals the text drawn with one
// sample per pixel.
struct GlyphMask {
    std::uint64_t id = 0;  // unique for these pixels
    int width = 0, height = 0;
    int samples = 1;
    std::vector<std::uint8_t> coverage;  // row 0 is the top
    std::vector<std::uint8_t> tints;     // 1…: see Label::inks; 0: the label's own; empty: all 0
    std::vector<MaskLetter> letters;     // the glyphs in the mask
    std::vector<MaskRule> rules;
    SetText source;

    // In pixels of the picture being drawn.
    int width_px() const { return samples * width; }
    int height_px() const { return samples * height; }
};

constexpr std::size_t most_inks = 16;

// Typeset text placed in pixels of the whole picture, drawn over everything else in its view.
struct Label {
    const GlyphMask* mask = nullptr;
    Eigen::Vector2d top_left_px =
        Eigen::Vector2d::Zero();  // picture pixels, y down; whole pixels keep the text sharp
    Colour colour;
    std::vector<Colour> inks;  // colours of the tints 1, 2, … of the mask; at most most_inks
    Colour halo_colour{1.0, 1.0, 1.0};
    double halo_px = 0.0;
    bool over_figure = false;  // whether the shapes of another view may run under it
    double opacity = 1.0;
    // The share of its width, from the left, that stays in place if another program typesets the
    // text wider or narrower.
    double held_at = 0.5;
    // The named point, view axes; if `with_point`, a renderer that knows the point's visibility
    // omits the label where bodies hide the point.
    std::optional<Eigen::Vector3d> at{};
    bool with_point = false;
    int rank = 0;  // if there is not enough room on paper, labels with the highest rank are omitted
                   // first
    ShapeName name{};
};

}  // namespace poinsot
