// A font for the writers: the meaning of its glyphs, their outlines, and subsets of its file.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "vector/sheet_of_paper.h"

// Forward declarations of FreeType's types, as in its headers.
struct FT_FaceRec_;
struct FT_LibraryRec_;

namespace poinsot::vector {

class FontFace {
 public:
    // Throws EnvironmentError if the file cannot be read as a font.
    explicit FontFace(const std::filesystem::path& file);
    ~FontFace();
    FontFace(FontFace&&) noexcept;
    FontFace& operator=(FontFace&&) = delete;

    // The character of a glyph; 0 if it has none, such as a tall form of a bracket.
    char32_t character(std::uint32_t glyph) const;
    // The text of a glyph, for searching and copying: mathematical letters as plain letters,
    // ligatures as their letters, tall forms as their base characters. May be empty.
    std::u32string meaning(std::uint32_t glyph) const;
    // The outline, in units of the em, y down.
    Path outline(std::uint32_t glyph) const;
    // The advance width, in units of the em.
    double advance(std::uint32_t glyph) const;
    std::string family() const;
    // The font reduced to these characters, as an OpenType file; empty if the font cannot be
    // reduced.
    std::string subset(const std::set<char32_t>& characters) const;

    FT_FaceRec_* handle() const;

 private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
    std::map<std::uint32_t, char32_t> characters_;
};

// The plain letter for a mathematical letter (bold, italic, script …), as used in searches.
char32_t plain_letter(char32_t character);

// Caches the fonts of a sheet's type.
class FontFaces {
 public:
    FontFace& of(const std::filesystem::path& file);

 private:
    std::map<std::filesystem::path, FontFace> faces_;
};

}  // namespace poinsot::vector
