// A page as PDF, by Cairo: paths, gradients and embedded fonts; nothing of it is a picture. The
// same page gives the same bytes. Coordinates are rounded to 1/256 pt (1.4 µm).
#pragma once

#include <string>
#include <string_view>

#include "vector/page.h"

namespace poinsot::vector {

// The bytes of the file. Throws EnvironmentError where a font cannot be read or Cairo fails.
std::string pdf_of(const Page& page);

// Pixels as a PNG.
std::string png_of(const Raster& raster);

// The same file with a title and a text of its own in the document's information, this under a
// name, as an update appended to it (ISO 32000-1, 7.5.6).
std::string with_pdf_text(std::string pdf, std::string_view title, std::string_view name,
                          std::string_view text);

// That text, and the file before it was added; both empty if there is none.
struct PdfText {
    std::string text;
    std::string_view before;
    bool is_last = true;  // nothing was added after it
};
PdfText pdf_text(std::string_view pdf, std::string_view name);

}  // namespace poinsot::vector
