// One picture of a scene as vectors: PDF or SVG, with its record. An OpenGL context is opened only
// for surfaces as pixels.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "production/records/page_text.h"
#include "production/records/record.h"
#include "production/session/picture_setting.h"
#include "production/session/session.h"
#include "typeset/latex.h"
#include "vector/picture.h"

namespace poinsot {

struct VectorChoices {
    std::string shading = "tone";  // style of surfaces: none, tone, picture
    std::string text = "font";     // representation of text: font, paths, latex
    bool operator==(const VectorChoices&) const = default;
};

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

}  // namespace poinsot
