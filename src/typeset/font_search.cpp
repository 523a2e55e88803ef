#include "typeset/font_search.h"

#include <fmt/format.h>

#include "error/error.h"

namespace poinsot {

std::vector<std::filesystem::path> default_font_folders() {
    return {"/usr/share/texmf/fonts/opentype/public/lm-math",
            "/usr/share/texmf/fonts/opentype/public/lm",
            "/usr/share/texlive/texmf-dist/fonts/opentype/public/lm-math",
            "/usr/share/texlive/texmf-dist/fonts/opentype/public/lm",
            "/usr/share/texmf-dist/fonts/opentype/public/lm-math",
            "/usr/share/texmf-dist/fonts/opentype/public/lm",
            "/usr/share/fonts/opentype/lmodern",
            "/usr/local/share/fonts"};
}

const std::array<std::string_view, 7>& font_names() {
    static constexpr std::array<std::string_view, 7> kNames{
        "latinmodern-math.otf", "lmsans10-regular.otf",  "lmsans10-bold.otf",
        "lmsans10-oblique.otf", "lmroman10-regular.otf", "lmroman10-bold.otf",
        "lmroman10-italic.otf"};
    return kNames;
}

std::filesystem::path find_font(std::string_view name, const FontSearch& search) {
    for (const std::filesystem::path& folder : search.folders) {
        std::filesystem::path file = folder / name;
        std::error_code ignored;
        if (std::filesystem::is_regular_file(file, ignored)) return file;
    }
    throw EnvironmentError(fmt::format(
        "font {} not found in {} folders, the first {}; install the package fonts-lmodern", name,
        search.folders.size(),
        search.folders.empty() ? "(none given)" : search.folders.front().string()));
}

}  // namespace poinsot
