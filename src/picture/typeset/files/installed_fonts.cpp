#include "typeset/files/installed_fonts.h"

#include <cerrno>
#include <new>
#include <utility>

namespace poinsot {

namespace {

// Maps the file into memory: fonts with all of Unicode have tens of megabytes, of which a label
// needs little.
FontFile font_in(const std::filesystem::path& file) {
    errno = 0;
    FontBlob blob(hb_blob_create_from_file_or_fail(file.c_str()));
    if (!blob && errno == ENOMEM) throw std::bad_alloc();
    return {std::move(blob), file};
}

}  // namespace

FontSource installed_fonts(FontSearch search) {
    FontSource source;
    source.fallbacks = [folders = search.fallback_folders] { return fonts_below(folders); };
    source.open = [search = std::move(search)](std::string_view name) {
        return font_in(find_font(name, search));
    };
    source.open_fallback = font_in;
    return source;
}

}  // namespace poinsot
