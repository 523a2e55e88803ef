// A font as writers need it: what its glyphs mean, their outlines, its file.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "vector/page.h"

// FreeType's, forward declared as its headers do.
struct FT_FaceRec_;
struct FT_LibraryRec_;

namespace poinsot::vector {

class FontFace {
 public:
    // Throws EnvironmentError where the file cannot be read as a font.
    explicit FontFace(const std::filesystem::path& file);
    ~FontFace();
    FontFace(FontFace&&) noexcept;
    FontFace& operator=(FontFace&&) = delete;

    // The character that the font draws with a glyph; 0: none, as of a tall form of a bracket.
    char32_t character(std::uint32_t glyph) const;
    // What a glyph says, for searching and copying: mathematical letters as plain ones, ligatures
    // as their letters, tall forms as what they are forms of. May be empty.
    std::u32string meaning(std::uint32_t glyph) const;
    // Its outline with the em as unit, y down.
    Path outline(std::uint32_t glyph) const;
    // How far the pen goes with a glyph, the em as unit.
    double advance(std::uint32_t glyph) const;
    std::string family() const;
    // The font with these characters alone, as an OpenType file; empty if it cannot be cut.
    std::string subset(const std::set<char32_t>& characters) const;

    FT_FaceRec_* handle() const;

 private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
    std::map<std::uint32_t, char32_t> characters_;
};

// A letter of mathematics (bold, italic, script …) as the plain letter that one would search for.
char32_t plain_letter(char32_t character);

// The faces of a page's type, opened once each.
class FontFaces {
 public:
    FontFace& of(const std::filesystem::path& file);

 private:
    std::map<std::filesystem::path, FontFace> faces_;
};

}  // namespace poinsot::vector
