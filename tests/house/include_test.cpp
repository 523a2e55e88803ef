// Checks the allowed includes: the layers of src/, their subfolders, and the folders that may use a
// library; and that tests are found by the names of their sources.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "places.h"

namespace {

namespace fs = std::filesystem;

// Folder → the folders whose headers it may include besides its own.
const std::map<std::string, std::set<std::string>> allowed{
    {"libm", {}},
    {"error", {}},
    {"colour", {}},
    {"text", {}},
    {"system", {"error"}},
    {"numerics", {"error"}},
    {"mesh", {"error", "text", "system"}},
    {"mechanics", {"error", "text", "numerics"}},
    {"measured", {"error", "text", "system", "mechanics"}},
    {"image", {"error", "colour", "text", "system"}},
    {"typeset", {"error", "text", "system"}},
    {"scene", {"error", "text", "system", "mesh", "mechanics", "measured", "image"}},
    {"construction", {"error", "numerics", "mechanics"}},
    {"shapes", {"error", "numerics"}},
    {"drawing",
     {"error", "colour", "text", "numerics", "mesh", "mechanics", "measured", "scene",
      "construction", "typeset", "shapes"}},
    // Renderers of shapes do not depend on the code that makes shapes.
    {"render", {"error", "colour", "text", "system", "image", "shapes"}},
    // shaders/light.glsl is written in the common subset of GLSL and C++.
    {"vector", {"error", "colour", "text", "numerics", "shapes", "shaders"}},
    {"output", {"error", "text", "system", "image"}},
    {"production",
     {"error", "colour", "text", "system", "mesh", "mechanics", "measured", "scene", "construction",
      "typeset", "shapes", "drawing", "render", "vector", "image", "output"}},
    // Pages: their module for browsers, and what writes them.
    {"web",
     {"error", "text", "system", "mechanics", "measured", "image", "typeset", "scene",
      "construction", "shapes", "drawing", "render", "vector", "output", "production"}},
    // What several doors ask for: the command line, the library, Python.
    {"work",
     {"error", "text", "system", "scene", "drawing", "image", "output", "report", "production",
      "web"}},
    // The library for programs in C++.
    {"library",
     {"error", "text", "system", "mesh", "mechanics", "measured", "scene", "construction",
      "typeset", "shapes", "drawing", "render", "vector", "image", "output", "production", "work"}},
    {"lab",
     {"error", "text", "system", "mechanics", "scene", "construction", "shapes", "drawing",
      "render", "image", "output", "production"}},
    {"report", {"error", "text", "system", "image", "scene", "output", "production"}},
    // The module of the Python package; the library's headers are included as programs do.
    {"python", {"system", "measured", "image", "report", "production", "library", "work"}},
    {"cli",
     {"error", "text", "system", "mesh", "mechanics", "measured", "scene", "construction",
      "typeset", "shapes", "drawing", "render", "image", "output", "report", "production", "work",
      "lab"}},
};

// Subfolder → the other subfolders of its folder that it may include. Files directly in the folder
// may be included by all subfolders and may include all of them.
const std::map<std::string, std::set<std::string>> allowed_subfolders{
    {"error/poinsot", {}},
    {"mechanics/free", {}},
    {"mechanics/top", {}},
    {"mechanics/stepped", {}},
    {"system/files", {}},
    {"image/files", {}},
    {"mesh/files", {}},
    {"measured/files", {}},
    {"scene/files", {"scene/toml"}},
    {"scene/toml", {}},
    {"typeset/files", {}},
    {"production/session", {}},
    {"production/session/files", {"production/session"}},
    {"production/sampling", {}},
    {"production/sampling/files", {"production/sampling"}},
    {"production/fits", {}},
    {"production/records", {"production/session"}},
    {"production/vectors", {"production/session", "production/records"}},
    {"production/stills",
     {"production/session", "production/session/files", "production/records",
      "production/vectors"}},
    {"production/films",
     {"production/session", "production/records", "production/vectors", "production/stills"}},
    {"production/cluster", {"production/session", "production/films"}},
    {"production/slides",
     {"production/session", "production/session/files", "production/records", "production/vectors",
      "production/stills", "production/films"}},
    {"drawing/style", {}},
    {"drawing/stage/type", {"drawing/style"}},
    {"drawing/stage", {"drawing/style", "drawing/stage/type"}},
    {"drawing/figures/charts", {"drawing/style", "drawing/stage", "drawing/stage/type"}},
    {"drawing/figures/elements", {"drawing/style", "drawing/stage", "drawing/stage/type"}},
    {"drawing/figures/panels",
     {"drawing/style", "drawing/stage", "drawing/stage/type", "drawing/figures/charts",
      "drawing/figures/elements"}},
    {"work/poinsot", {}},
    {"library/poinsot", {}},
    {"library/mechanics", {"library/poinsot"}},
    {"library/construction", {"library/poinsot", "library/mechanics"}},
    {"library/production", {"library/poinsot", "library/mechanics", "library/construction"}},
    {"vector/passes", {}},
    {"web/host", {}},
    {"web/module", {"web/host"}},
    {"web/pack", {}},
    {"render/context", {}},
    {"render/passes", {"render/context"}},
    {"render/cache", {"render/context", "render/passes"}},
};

// Folder → the only subfolder of it that other folders may include. The module of pages and its
// host are a program of their own; pack/ is what the native program has of pages.
const std::map<std::string, std::string> shown_subfolder{{"web", "web/pack"}};

// Subfolders that may include less than their folder: a page in a browser and a Python module need
// no output.
const std::map<std::string, std::set<std::string>> allowed_folders{
    {"production/session",
     {"error", "text", "system", "image", "mesh", "mechanics", "measured", "scene", "construction",
      "typeset", "shapes", "drawing"}},
    {"production/sampling", {"error", "text", "system", "mechanics", "construction"}},
    {"production/fits", {"error", "text", "mechanics", "measured", "scene"}},
    // A host defines functions of other layers and knows no scene.
    {"web/host", {"error", "system", "image", "typeset", "render", "vector", "production"}},
    {"web/pack", {"error", "text", "system", "image", "typeset", "output", "production"}},
    // Components of the library that need Eigen alone.
    {"library/mechanics", {"error", "mechanics"}},
    {"library/construction", {"error", "mechanics", "construction"}},
};

// Parsers take text and a name; only the subfolders files/ of these folders read or write the disk.
const std::set<std::string> without_files{"libm",
                                          "error",
                                          "colour",
                                          "text",
                                          "system",
                                          "numerics",
                                          "mesh",
                                          "mechanics",
                                          "measured",
                                          "image",
                                          "typeset",
                                          "scene",
                                          "construction",
                                          "shapes",
                                          "drawing",
                                          "production/session",
                                          "production/sampling",
                                          "production/fits"};

// A list of this length is still readable.
constexpr int most_headers = 20;

// Beginning of a library's header → the folders that may include it.
const std::map<std::string, std::set<std::string>> library_owners{
    {"glad/", {"render", "web"}},  {"glm/", {"render"}},
    {"GL/", {"render"}},           {"EGL/", {"render"}},
    {"libav", {"output"}},         {"libsw", {"output"}},
    {"toml", {"scene"}},           {"CLI/", {"cli"}},
    {"png.h", {"image"}},          {"libdeflate.h", {"image"}},
    {"cairo", {"vector"}},         {"ft2build.h", {"typeset", "vector"}},
    {"hb", {"typeset", "vector"}}, {"boost/", {"text", "numerics", "mechanics"}},
    {"sleef.h", {"libm"}},         {"xxhash.h", {"image"}},
    {"pybind11/", {"python"}},     {"stb_image.h", {"web"}},
};

// Test files that no source file gives its name, and why.
const std::map<std::string, std::string> tests_without_source{
    {"cli/bad_input", "all commands refuse bad input in the same way"},
    {"cli/extremes", "extreme scenes in several commands"},
    {"cli/suffixes", "all commands ignore the case of suffixes"},
    {"cli/unfinished", "what lies in the place of the unfinished work of every command"},
    {"drawing/dissipation", "friction and drag in all panels"},
    {"drawing/level_scale", "the scale of distances beside the body"},
    {"drawing/evaluations", "what panels and elements do not compute"},
    {"drawing/kept_curves", "the bound of every curve of every panel"},
    {"production/page_labels", "labels over the whole page, in all scenes"},
    {"drawing/lecture_claims", "what the scenes of the lecture say, in all panels"},
    {"drawing/legible", "text and lines of every scene in every theme"},
    {"drawing/pixel_geometry", "errors in pixels over whole films"},
    {"drawing/samples", "supersampling changes no drawing"},
    {"drawing/user_style", "words, symbols, units and sizes that a scene chooses"},
    {"house/include", "reads all source files"},
    {"measured/racket", "fits of real throws"},
    {"mechanics/extremes", "free motions at every extreme"},
    {"production/label_rules", "the rules that names keep in every scene"},
    {"production/alone", "a drawing made without files, OpenGL or FFmpeg"},
    {"production/drawn_geometry", "pixels compared with geometry computed independently of src/"},
    {"production/taught_construction", "pixels compared with the textbooks' construction"},
    {"report/shown_films", "films of the same coded pictures that players show otherwise"},
    {"vector/contours", "outlines of surfaces that are not filled"},
    {"scene/lecture_scenes", "the files of scenes/"},
    {"scene/random_scenes", "all keys at once, read and written"},
};

struct Include {
    std::string from_file;
    std::string from_folder;
    std::string header;
    bool quoted;
};

// The header of an include directive with its delimiter in front: `"a/b.h` or `<a.h`; empty for
// other lines.
std::string included_header(const std::string& line) {
    std::size_t at = line.find_first_not_of(" \t");
    if (at == std::string::npos || line[at] != '#') return "";
    at = line.find_first_not_of(" \t", at + 1);
    if (at == std::string::npos || line.compare(at, 7, "include") != 0) return "";
    const std::size_t open = line.find_first_of("<\"", at + 7);
    if (open == std::string::npos) return "";
    const std::size_t close = line.find_first_of(">\"", open + 1);
    return close == std::string::npos ? "" : line.substr(open, close - open);
}

std::vector<Include> includes_of_sources() {
    std::vector<Include> found;
    const fs::path src = poinsot::source_folder() / "src";
    for (const auto& entry : fs::recursive_directory_iterator(src)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".h" && extension != ".cpp") continue;
        const fs::path relative = fs::relative(entry.path(), src);
        if (relative.begin() == std::prev(relative.end())) continue;  // main.cpp
        std::ifstream file(entry.path());
        for (std::string line; std::getline(file, line);) {
            const std::string header = included_header(line);
            if (header.empty()) continue;
            found.push_back({relative.string(), relative.begin()->string(), header.substr(1),
                             header.front() == '"'});
        }
    }
    return found;
}

TEST(House, EveryIncludeFollowsTheLayers) {
    const auto found = includes_of_sources();
    ASSERT_GT(found.size(), 100u);
    for (const Include& include : found) {
        if (!include.quoted) continue;
        const auto slash = include.header.find('/');
        ASSERT_NE(slash, std::string::npos)
            << include.from_file << " includes \"" << include.header << "\" without its folder";
        const std::string folder = include.header.substr(0, slash);
        ASSERT_TRUE(allowed.contains(include.from_folder)) << include.from_folder;
        EXPECT_TRUE(folder == include.from_folder ||
                    allowed.at(include.from_folder).contains(folder))
            << include.from_file << " must not include \"" << include.header << "\"";
    }
}

// "drawing/stage" for "drawing/stage/panel.h"; empty for files outside of subfolders.
std::string subfolder_of(const std::string& file) {
    const auto last = file.rfind('/');
    return file.find('/') == last ? "" : file.substr(0, last);
}

TEST(House, SubfoldersIncludeOnlyAllowedSubfolders) {
    for (const Include& include : includes_of_sources()) {
        const std::string from = subfolder_of(include.from_file);
        if (from.empty()) continue;
        ASSERT_TRUE(allowed_subfolders.contains(from)) << from;
        const std::string to = include.quoted ? subfolder_of(include.header) : "";
        if (to.empty() || to == from || to.substr(0, to.find('/')) != include.from_folder) continue;
        EXPECT_TRUE(allowed_subfolders.at(from).contains(to))
            << include.from_file << " must not include \"" << include.header << "\"";
    }
}

TEST(House, OtherFoldersIncludeOnlyTheShownSubfolder) {
    int n_includes = 0;
    for (const Include& include : includes_of_sources()) {
        const auto slash = include.header.find('/');
        if (!include.quoted || slash == std::string::npos) continue;
        const std::string folder = include.header.substr(0, slash);
        const auto shown = shown_subfolder.find(folder);
        if (shown == shown_subfolder.end() || folder == include.from_folder) continue;
        ++n_includes;
        EXPECT_EQ(subfolder_of(include.header), shown->second)
            << include.from_file << " must not include \"" << include.header << "\"";
    }
    EXPECT_GT(n_includes, 0);
}

// Files directly in a folder may be included by all of its subfolders and may include all of them.
// Where the subfolders see each other one way, such a file would be a way round.
TEST(House, FoldersWhoseSubfoldersAreLayersHaveNoFilesOfTheirOwn) {
    const std::set<std::string> layered{"drawing", "drawing/figures", "web"};
    const fs::path src = poinsot::source_folder() / "src";
    for (const std::string& folder : layered) {
        int n_subfolders = 0;
        for (const auto& entry : fs::directory_iterator(src / folder)) {
            n_subfolders += entry.is_directory();
            const std::string extension = entry.path().extension().string();
            EXPECT_TRUE(extension != ".h" && extension != ".cpp") << entry.path();
        }
        EXPECT_GE(n_subfolders, 3) << folder;
    }
}

// The headers that a header includes, and those that these include, and so on.
TEST(House, NoHeaderIncludesItself) {
    std::map<std::string, std::vector<std::string>> included;
    for (const Include& include : includes_of_sources())
        if (include.quoted && include.from_file.ends_with(".h"))
            included[include.from_file].push_back(include.header);
    EXPECT_GT(included.size(), 100u);
    for (const auto& [header, first] : included) {
        std::set<std::string> reached;
        std::vector<std::string> next = first;
        while (!next.empty()) {
            const std::string at = next.back();
            next.pop_back();
            if (!reached.insert(at).second) continue;
            if (const auto found = included.find(at); found != included.end())
                next.insert(next.end(), found->second.begin(), found->second.end());
        }
        EXPECT_FALSE(reached.contains(header)) << header;
    }
}

TEST(House, SubfoldersWithoutOutputIncludeNone) {
    int n_includes = 0;
    for (const Include& include : includes_of_sources()) {
        const auto subfolder = allowed_folders.find(subfolder_of(include.from_file));
        if (subfolder == allowed_folders.end() || !include.quoted) continue;
        ++n_includes;
        const std::string folder = include.header.substr(0, include.header.find('/'));
        EXPECT_TRUE(folder == include.from_folder || subfolder->second.contains(folder))
            << include.from_file << " must not include \"" << include.header << "\"";
    }
    EXPECT_GT(n_includes, 50);
}

// Installed headers need nothing of the repository, and no other library than Eigen.
TEST(House, PublicHeadersIncludeOnlyTheStandardLibraryAndEigen) {
    std::set<std::string> headers;
    for (const Include& include : includes_of_sources()) {
        if (!subfolder_of(include.from_file).ends_with("/poinsot")) continue;
        headers.insert(include.from_file);
        const bool is_public = include.header.starts_with("poinsot/");
        EXPECT_TRUE(!include.quoted && (is_public || include.header.starts_with("Eigen/") ||
                                        include.header.find_first_of("./") == std::string::npos))
            << include.from_file << " must not include " << include.header;
    }
    EXPECT_GE(headers.size(), 3u);
}

TEST(House, ReadingFilesStandsApartFromParsing) {
    int n_in_files = 0;
    for (const Include& include : includes_of_sources()) {
        const std::string subfolder = subfolder_of(include.from_file);
        const bool reads = include.quoted ? subfolder_of(include.header).ends_with("/files")
                                          : include.header == "fstream";
        if (subfolder.ends_with("/files")) n_in_files += reads ? 1 : 0;
        if (!reads || subfolder.ends_with("/files")) continue;
        EXPECT_FALSE(without_files.contains(include.from_folder) ||
                     without_files.contains(subfolder))
            << include.from_file << " must not include " << include.header
            << "; code that reads the disk belongs to a subfolder files/";
    }
    EXPECT_GT(n_in_files, 10);
}

TEST(House, FoldersHaveFewHeaders) {
    std::map<std::string, int> n_headers;
    for (const auto& entry : fs::recursive_directory_iterator(poinsot::source_folder() / "src"))
        if (entry.path().extension() == ".h") ++n_headers[entry.path().parent_path().string()];
    EXPECT_GT(n_headers.size(), 20u);
    for (const auto& [folder, n] : n_headers)
        EXPECT_LE(n, most_headers) << folder << ": give it subfolders";
}

TEST(House, LibrariesAreUsedOnlyInTheirFolders) {
    for (const Include& include : includes_of_sources()) {
        for (const auto& [beginning, owners] : library_owners) {
            if (include.header.rfind(beginning, 0) != 0 || include.quoted) continue;
            EXPECT_TRUE(owners.contains(include.from_folder))
                << include.from_file << " must not include <" << include.header << ">";
        }
    }
}

// A long double has 53, 64 or 113 bits, so digits would depend on the platform. A value that is
// rounded to it and then to double is rounded twice.
TEST(House, NoResultPassesThroughLongDouble) {
    int n_files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(poinsot::source_folder() / "src")) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".h" && extension != ".cpp") continue;
        ++n_files;
        std::ifstream file(entry.path());
        for (std::string line; std::getline(file, line);)
            EXPECT_EQ(line.substr(0, line.find("//")).find("long double"), std::string::npos)
                << fs::relative(entry.path(), poinsot::source_folder()) << ": " << line;
    }
    EXPECT_GT(n_files, 100);
}

// fmt 11 has join in ranges.h alone; fmt 9 gives it without, so that Debian 12 misses nothing.
TEST(House, WhoJoinsIncludesRanges) {
    int n_joining = 0;
    for (const std::string folder : {"src", "tests"}) {
        for (const auto& entry :
             fs::recursive_directory_iterator(poinsot::source_folder() / folder)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".h" && extension != ".cpp") continue;
            std::ifstream file(entry.path());
            bool joins = false;
            bool includes_ranges = false;
            for (std::string line; std::getline(file, line);) {
                // Split, so that this file does not contain the searched string.
                joins = joins || line.find(std::string("fmt:") + ":join(") != std::string::npos;
                includes_ranges = includes_ranges || included_header(line) == "<fmt/ranges.h";
            }
            n_joining += joins;
            EXPECT_TRUE(!joins || includes_ranges)
                << fs::relative(entry.path(), poinsot::source_folder()) << " uses fmt::"
                << "join"
                << " without <fmt/ranges.h>";
        }
    }
    EXPECT_GT(n_joining, 10);
}

TEST(House, MainIncludesOnlyTheCommandLine) {
    std::ifstream file(poinsot::source_folder() / "src" / "main.cpp");
    ASSERT_TRUE(file);
    for (std::string line; std::getline(file, line);) {
        const std::string header = included_header(line);
        if (header.empty() || header.front() != '"') continue;
        const std::string folder = header.substr(1, header.find('/') - 1);
        EXPECT_TRUE(folder == "cli" || folder == "error" || folder == "text") << line;
    }
}

// Tests run commands as programs; a test that needs a picture uses production/.
TEST(House, TestsOfOtherLayersDoNotUseTheCommandLine) {
    const fs::path tests = poinsot::source_folder() / "tests";
    int n_files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(tests)) {
        const fs::path relative = fs::relative(entry.path(), tests);
        const std::string extension = entry.path().extension().string();
        const bool is_cmake = entry.path().filename() == "CMakeLists.txt";
        if (*relative.begin() == "cli" || (!is_cmake && extension != ".cpp" && extension != ".h"))
            continue;
        ++n_files;
        std::ifstream file(entry.path());
        for (std::string line; std::getline(file, line);) {
            if (is_cmake)
                EXPECT_EQ(line.find("poinsot_cli"), std::string::npos) << relative << ": " << line;
            else
                EXPECT_NE(included_header(line).rfind("\"cli/", 0), 0u) << relative << ": " << line;
        }
    }
    EXPECT_GT(n_files, 100);
}

// Who reads src/cli/still.cpp looks for still_test.cpp.
TEST(House, TestsBearTheNamesOfSources) {
    std::set<std::string> sources;
    for (const auto& entry : fs::recursive_directory_iterator(poinsot::source_folder() / "src")) {
        const std::string extension = entry.path().extension().string();
        if (extension == ".h" || extension == ".cpp") sources.insert(entry.path().stem().string());
    }
    std::size_t n_without = 0;
    const fs::path tests = poinsot::source_folder() / "tests";
    for (const auto& entry : fs::recursive_directory_iterator(tests)) {
        const std::string file = fs::relative(entry.path(), tests).string();
        if (!file.ends_with("_test.cpp")) continue;
        const std::string test = file.substr(0, file.size() - std::string("_test.cpp").size());
        const bool listed = tests_without_source.contains(test);
        n_without += listed;
        EXPECT_NE(sources.contains(fs::path(test).filename().string()), listed)
            << file << ": give it the name of the source file that it tests, or list it above";
    }
    EXPECT_EQ(n_without, tests_without_source.size());
}

TEST(House, EveryFolderHasTestsAndATarget) {
    for (const auto& [folder, others] : allowed) {
        if (folder == "error") continue;
        EXPECT_TRUE(fs::exists(poinsot::source_folder() / "src" / folder / "CMakeLists.txt"));
        EXPECT_TRUE(fs::exists(poinsot::source_folder() / "tests" / folder / "CMakeLists.txt"));
    }
}

}  // namespace
