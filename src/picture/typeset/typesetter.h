// Typesets labels and captions: from a TeX-like string to a coverage mask that can be coloured.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "typeset/font_source.h"
#include "typeset/label_error.h"

namespace poinsot {

constexpr int mask_side_limit_px = 16384;

enum class TypeMode {
    math,  // a label: one formula, set in display style
    text   // a caption: running text with $formulas$
};

enum class TypeAlignment { left, centre, right };

// A word or some words of running text, or a formula without dollar signs, which a caption sets
// with a tint: term i of a list has tint i + 1.
struct CaptionTerm {
    std::string text;
    bool is_formula = false;
    bool operator==(const CaptionTerm&) const = default;
};

struct TypeStyle {
    double size_px = 24.0;  // px per em, 1…4096
    TypeMode mode = TypeMode::math;
    double max_width_px = 0.0;  // captions are wrapped at spaces to this width; 0: no wrapping
    TypeAlignment alignment = TypeAlignment::left;
    double line_spacing = 1.3;  // distance of baselines, in ems; increased for tall lines
    const std::vector<CaptionTerm>* terms = nullptr;  // of captions, which get tints
    bool operator==(const TypeStyle&) const = default;
};

// The bounding box of the ink. For sharp glyphs that do not move when the text changes, place the
// mask's upper left corner at (pen_x + left_px, baseline_y − baseline_px), both whole numbers.
struct TypeExtent {
    int width = 0,
        height = 0;   // px, of the smallest whole-pixel box around the ink; 0 if there is no ink
    int left_px = 0;  // from the pen's start to the left side of the box, x right
    double baseline_px = 0.0;  // from the upper side of the box down to the first baseline; a whole
                               // number
    double advance_px = 0.0;   // from the pen's start to its end on the widest line
    int n_lines = 0;
};

// A glyph of a mask, by its number in its font; positions in px from the mask's upper left corner,
// y down.
struct SetGlyph {
    const std::filesystem::path* font_file = nullptr;  // valid as long as the typesetter
    std::uint32_t glyph = 0;
    double x_px = 0.0, baseline_px = 0.0;
    double em_px = 0.0;
    int tint = 0;  // of a term; 0: none
};

struct SetRule {
    double left_px = 0.0, top_px = 0.0, width_px = 0.0, height_px = 0.0;
};

struct TypesetMask : TypeExtent {
    std::vector<std::uint8_t> coverage;  // width × height, row 0 is the top, 255: inside
    std::vector<std::uint8_t> tints;     // of the same pixels; empty: all 0
    std::vector<SetGlyph> glyphs;        // the glyphs of the mask, in reading order
    std::vector<SetRule> rules;
};

// Holds the fonts and caches outlines, so that a caption with changing numbers in each video frame
// costs only its own pixels. Only one thread at a time may use it.
class Typesetter {
 public:
    // Opens fonts only when they are needed.
    explicit Typesetter(FontSource fonts);
    ~Typesetter();
    Typesetter(Typesetter&&) noexcept;
    Typesetter& operator=(Typesetter&&) noexcept;

    // Returns the mask of a label or caption (grammar: label_parser.h). The same string, style and
    // fonts give byte-identical masks on every machine. Characters that the fonts lack come from a
    // system font, or are drawn as boxes. throws: LabelError for an invalid string, InputError for
    // an invalid style or a mask larger than mask_side_limit_px, EnvironmentError for a missing
    // font.
    TypesetMask set(std::string_view text, const TypeStyle& style = {}) const;

    // Returns the mask's extent without drawing it. throws: as set.
    TypeExtent measure(std::string_view text, const TypeStyle& style = {}) const;

    // The fallback fonts used so far, and the characters that were drawn as boxes.
    const std::vector<std::filesystem::path>& fallbacks_used() const;
    const std::vector<char32_t>& missing() const;

 private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace poinsot
