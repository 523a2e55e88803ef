// Sets labels and captions: from a TeX-like string to a coverage mask, ready to be coloured.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "typeset/font_search.h"
#include "typeset/label_error.h"

namespace poinsot {

constexpr int mask_side_limit_px = 16384;

enum class TypeMode {
    math,  // a label: one formula, set in display style
    text   // a caption: running text with $formulas$
};

enum class TypeAlignment { left, centre, right };

struct TypeStyle {
    double size_px = 24.0;  // px per em, 1…4096
    TypeMode mode = TypeMode::math;
    double max_width_px = 0.0;  // captions are wrapped at spaces to this width; 0: not wrapped
    TypeAlignment alignment = TypeAlignment::left;
    double line_spacing = 1.3;  // from baseline to baseline, in ems; lines that need more get more
    bool operator==(const TypeStyle&) const = default;
};

// Where the ink lies. The pen starts in the pixel column and on the row boundary given: place a
// mask's upper left corner at (pen_x + left_px, baseline_y − baseline_px), both whole, and it is as
// crisp as it can be and does not move when its text changes.
struct TypeExtent {
    int width = 0,
        height = 0;   // px, of the smallest whole-pixel box around the ink; 0 if there is none
    int left_px = 0;  // from the pen's start to the left side of the box, x right
    double baseline_px = 0.0;  // from the upper side of the box down to the first baseline; whole
    double advance_px = 0.0;   // from the pen's start to its end on the widest line
    int n_lines = 0;
};

// A glyph of a mask by its number in its font; pixels from the mask's upper left corner, y down.
struct SetGlyph {
    const std::filesystem::path* font_file = nullptr;  // lives as long as the typesetter
    std::uint32_t glyph = 0;
    double x_px = 0.0, baseline_px = 0.0;
    double em_px = 0.0;
};

struct SetRule {
    double left_px = 0.0, top_px = 0.0, width_px = 0.0, height_px = 0.0;
};

struct TypesetMask : TypeExtent {
    std::vector<std::uint8_t> coverage;  // width × height, row 0 on top, 255: inside
    std::vector<SetGlyph> glyphs;        // what the coverage shows, in reading order
    std::vector<SetRule> rules;
};

// Holds the fonts, and the outlines of the glyphs used so far, so that a caption whose numbers
// change with every video frame costs only its own pixels. One thread at a time may use it.
class Typesetter {
 public:
    // Opens no font before one is needed.
    explicit Typesetter(FontSearch search = {});
    ~Typesetter();
    Typesetter(Typesetter&&) noexcept;
    Typesetter& operator=(Typesetter&&) noexcept;

    // The mask of a label or caption (grammar: label_parser.h). The same string, style and fonts
    // give the same bytes on every machine.
    // What a run of text has and the fonts lack comes from another font of the system, or is a box.
    // throws: LabelError for what the string says, InputError for a style out of its domain or a
    // mask larger than mask_side_limit_px, EnvironmentError for a missing font.
    TypesetMask set(std::string_view text, const TypeStyle& style = {}) const;

    // The mask's extent without its pixels. throws: as set.
    TypeExtent measure(std::string_view text, const TypeStyle& style = {}) const;

    // The fonts of the system that stood in so far, and the characters that became boxes.
    const std::vector<std::filesystem::path>& fallbacks_used() const;
    const std::vector<char32_t>& missing() const;

 private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace poinsot
