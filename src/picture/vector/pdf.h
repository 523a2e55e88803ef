// Writes a sheet of paper as PDF with Cairo: paths, gradients and embedded fonts, without
// rasterising. The same sheet gives byte-identical files. Coordinates are rounded to 1/256 pt (1.4
// µm).
#pragma once

#include <string>
#include <string_view>

#include "vector/sheet_of_paper.h"

namespace poinsot::vector {

// Returns the bytes of the file. Throws EnvironmentError if a font cannot be read or Cairo fails.
std::string pdf_of(const SheetOfPaper& paper);

// Encodes pixels as PNG.
std::string png_of(const Raster& raster);

// Adds a title, and a text under a name, to the document's information dictionary by an incremental
// update (ISO 32000-1, 7.5.6).
std::string with_pdf_text(std::string pdf, std::string_view title, std::string_view name,
                          std::string_view text);

// The added text, and the file before the update; both empty if there is none.
struct PdfText {
    std::string text;
    std::string_view before;
    bool is_last = true;  // nothing was added after it
};
PdfText pdf_text(std::string_view pdf, std::string_view name);

}  // namespace poinsot::vector
