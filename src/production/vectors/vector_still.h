// One picture of a scene as vectors: PDF or SVG, with its record. An OpenGL context is opened only
// for surfaces as pixels.
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
    std::string shading = "tone";  // style of surfaces: none, tone, picture
    std::string text = "font";     // representation of text: font, paths, latex
    bool operator==(const VectorChoices&) const = default;
};

// Whether a file name is that of a vector format: it ends in .pdf or .svg.
bool is_vector_name(const std::filesystem::path& name);

// The choices with the dots per inch in which sizes are measured, since vectors are always on
// paper: with a width or a height in millimetres, those with which the scene's whole number of
// pixels has exactly this size. Throws InputError for a side longer than PDF allows (200 inches).
PrintChoices on_paper(PrintChoices print, int width_px, int height_px);

// Throws InputError for an unknown shading or text representation, with the list.
void check_vector_choices(const VectorChoices& choices);

// The setting of a drawing for vectors: curves stay curves, and text is set once per position.
// Throws as on_paper().
PictureSetting vector_setting(const Scene& scene, const PrintChoices& print);

struct VectorStill {
    std::string bytes;
    std::string latex;  // contents of the .tex file, with --text latex
    LatexGaps latex_gaps;
    double off_um = 0.0;  // largest distance of a path from its exact form, before rounding
};

// Whether surfaces are pixels, which need a context.
bool has_pixels(const VectorChoices& choices);

// The document's title: the scene's, or its name if it has none.
std::string title_of(const Scene& scene);

// The bytes of the file of a drawing; completes `record` with the page's own fields.
VectorStill vector_still(const std::filesystem::path& path, const std::string& title,
                         const Drawing& drawing, const VectorChoices& choices, Record record,
                         const vector::DrawPixels& draw_pixels);

// The record's text in such a file, and the hash of the rest of the file. The text is empty if
// there is none.
struct VectorText {
    std::string text;
    std::string page_hash;
    bool is_last = true;  // of a PDF: nothing was appended after the text
};
VectorText read_vector_text(const std::filesystem::path& file);

}  // namespace poinsot
