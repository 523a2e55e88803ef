// One picture of a scene as vectors: PDF or SVG, with its record. No OpenGL context is opened but
// for pixels between the lines.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "production/picture.h"
#include "production/record.h"
#include "production/session.h"
#include "typeset/latex.h"
#include "vector/picture.h"

namespace poinsot {

struct VectorChoices {
    std::string shading = "tone";  // how surfaces are filled: none, tone, picture
    std::string text = "font";     // what type is: font, paths, latex
    bool operator==(const VectorChoices&) const = default;
};

// Whether a name asks for vectors: it ends in .pdf or .svg.
bool is_vector_name(const std::filesystem::path& name);

// On paper, whatever has been asked for: the dots per inch that sizes are counted in are filled in.
// Throws InputError for a side longer than a PDF has (200 inches).
PrintChoices on_paper(PrintChoices print, int width_px, int height_px);

// Throws InputError for a shading or a kind of type that does not exist, with those that do.
void check_vector_choices(const VectorChoices& choices);

// How finely a drawing is made that becomes vectors: curves are asked for as curves, and type is
// set once for each place. Throws as on_paper().
PictureSetting vector_setting(const Scene& scene, const PrintChoices& print);

struct VectorStill {
    std::string bytes;
    std::string latex;  // what stands in the file beside it, with --text latex
    LatexGaps latex_gaps;
    double off_um = 0.0;  // no path is further than this from what it shows, before rounding
};

// Whether surfaces are pixels, for which a context is opened.
bool has_pixels(const VectorChoices& choices);

// The bytes of the file: `record` is completed with what the page says of itself.
VectorStill vector_still(const std::filesystem::path& path, const Stage& stage,
                         const FilmMoment& moment, const VectorChoices& choices, double dpi,
                         Record record, const vector::DrawPixels& draw_pixels);

// What such a file carries, and the hash of all else in it. The text is empty if it carries none.
struct VectorText {
    std::string text;
    std::string page_hash;
    bool is_last = true;  // of a PDF: nothing was added after the text
};
VectorText read_vector_text(const std::filesystem::path& file);

}  // namespace poinsot
