// The record's text in a PDF or an SVG.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace poinsot {

// Whether a file name is that of a vector format: it ends in .pdf or .svg.
bool is_vector_name(const std::filesystem::path& name);

bool is_svg_name(const std::filesystem::path& name);

// The key of the text in a PDF.
inline constexpr std::string_view pdf_text_name = "Poinsot";

// The hash of an SVG without its text, which is `text`.
std::string hash_of_svg(std::string svg, const std::string& text);

// The record's text in such a file, and the hash of the rest of the file. The text is empty if
// there is none.
struct VectorText {
    std::string text;
    std::string page_hash;
    bool is_last = true;  // of a PDF: nothing was appended after the text
};
VectorText vector_text_of(const std::string& bytes, const std::filesystem::path& name);

// The same for a file. Throws InputError if it cannot be read.
VectorText read_vector_text(const std::filesystem::path& file);

}  // namespace poinsot
