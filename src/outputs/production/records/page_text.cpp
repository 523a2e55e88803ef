#include "production/records/page_text.h"

#include <fmt/format.h>

#include "error/error.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "system/sha256.h"
#include "text/printable.h"
#include "vector/pdf.h"
#include "vector/svg.h"

namespace poinsot {

bool is_vector_name(const std::filesystem::path& name) {
    return suffix_of(name) == ".pdf" || suffix_of(name) == ".svg";
}

bool is_svg_name(const std::filesystem::path& name) { return suffix_of(name) == ".svg"; }

std::string hash_of_svg(std::string svg, const std::string& text) {
    const std::string empty = vector::svg_text(svg);
    if (empty != text) return sha256_of(svg);
    const std::size_t from = svg.find("<metadata"), end = svg.find("</metadata>", from);
    if (from != std::string::npos && end != std::string::npos) svg.erase(from, end - from);
    return sha256_of(svg);
}

VectorText vector_text_of(const std::string& bytes, const std::filesystem::path& name) {
    VectorText found;
    if (is_svg_name(name)) {
        found.text = vector::svg_text(bytes);
        found.page_hash = hash_of_svg(bytes, found.text);
    } else {
        vector::PdfText text = vector::pdf_text(bytes, pdf_text_name);
        found.page_hash = sha256_of(std::string(text.before));
        found.is_last = text.is_last;
        found.text = std::move(text.text);
    }
    return found;
}

VectorText read_vector_text(const std::filesystem::path& file) {
    const FileKind kind = kind_of_file(file);
    if (kind != FileKind::regular)
        throw InputError(fmt::format("{}: {}", printable(file.string()), in_words(kind)));
    return vector_text_of(read_text(file), file);
}

}  // namespace poinsot
