#include "typeset/files/font_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "error/error.h"
#include "system/files/program_files.h"

namespace poinsot {

std::vector<std::filesystem::path> default_font_folders() {
    return {program_share() / "fonts",  // fonts in a bundle
            "/usr/share/texmf/fonts/opentype/public/lm-math",
            "/usr/share/texmf/fonts/opentype/public/lm",
            "/usr/share/texlive/texmf-dist/fonts/opentype/public/lm-math",
            "/usr/share/texlive/texmf-dist/fonts/opentype/public/lm",
            "/usr/share/texmf-dist/fonts/opentype/public/lm-math",
            "/usr/share/texmf-dist/fonts/opentype/public/lm",
            "/usr/share/fonts/opentype/lmodern",
            "/usr/local/share/fonts"};
}

std::vector<std::filesystem::path> system_font_folders() {
    return {"/usr/share/fonts", "/usr/local/share/fonts"};
}

std::vector<std::filesystem::path> fonts_below(const std::vector<std::filesystem::path>& folders) {
    namespace fs = std::filesystem;
    // Prefer plain faces to slanted, bold, condensed and typewriter faces as the fallback.
    const auto rank = [](const fs::path& file) {
        const std::string name = file.filename().string();
        const auto has = [&name](std::string_view part) {
            return name.find(part) != std::string::npos;
        };
        const bool plain = !has("Bold") && !has("Italic") && !has("Oblique") && !has("Condensed") &&
                           !has("Mono") && !has("Light") && !has("Thin");
        if (name == "DejaVuSans.ttf") return 0;
        return (has("Sans") ? 1 : 2) + (plain ? 0 : 2);
    };
    std::vector<std::tuple<int, std::string, fs::path>> found;
    for (const fs::path& folder : folders) {
        std::error_code error;
        fs::recursive_directory_iterator at(folder, error);
        for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
            const std::string suffix = at->path().extension().string();
            std::error_code ignored;
            if ((suffix == ".ttf" || suffix == ".otf" || suffix == ".ttc") &&
                at->is_regular_file(ignored))
                found.emplace_back(rank(at->path()), at->path().string(), at->path());
        }
    }
    std::sort(found.begin(), found.end());
    std::vector<fs::path> files;
    files.reserve(found.size());
    for (auto& [order, name, path] : found) files.push_back(std::move(path));
    return files;
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
