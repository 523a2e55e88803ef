// Who may include whom: the layers of src/ and the folders that alone may know a library.
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
    {"mesh", {"error"}},
    {"mechanics", {"error"}},
    {"image", {"error"}},
    {"typeset", {"error"}},
    {"scene", {"error", "mesh", "mechanics"}},
    {"construction", {"error", "mechanics"}},
    {"drawing", {"error", "mesh", "mechanics", "scene", "construction", "typeset"}},
    {"render", {"error", "drawing", "image"}},
    {"output", {"error", "image"}},
    {"report", {"error", "image"}},
    {"cli",
     {"error", "mesh", "mechanics", "scene", "construction", "typeset", "drawing", "render",
      "image", "output", "report"}},
};

// Beginning of a library's header → the one folder that may know it.
const std::map<std::string, std::string> library_owner{
    {"glad/", "render"},       {"glm/", "render"},        {"GL/", "render"},
    {"EGL/", "render"},        {"libav", "output"},       {"libsw", "output"},
    {"toml", "scene"},         {"CLI/", "cli"},           {"png.h", "image"},
    {"libdeflate.h", "image"}, {"ft2build.h", "typeset"}, {"hb", "typeset"},
    {"boost/", "mechanics"},   {"sleef.h", "libm"},
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

TEST(House, LibrariesStayInTheirFolder) {
    for (const Include& include : includes_of_sources()) {
        for (const auto& [beginning, owner] : library_owner) {
            if (include.header.rfind(beginning, 0) != 0 || include.quoted) continue;
            EXPECT_EQ(include.from_folder, owner)
                << include.from_file << " must not include <" << include.header << ">";
        }
    }
}

TEST(House, MainSeesOnlyTheCommandLine) {
    std::ifstream file(poinsot::source_folder() / "src" / "main.cpp");
    ASSERT_TRUE(file);
    for (std::string line; std::getline(file, line);) {
        const std::string header = included_header(line);
        if (header.empty() || header.front() != '"') continue;
        EXPECT_TRUE(header.rfind("\"cli/", 0) == 0 || header.rfind("\"error/", 0) == 0) << line;
    }
}

TEST(House, EveryFolderHasItsTestsAndTarget) {
    for (const auto& [folder, others] : allowed) {
        if (folder == "error") continue;
        EXPECT_TRUE(fs::exists(poinsot::source_folder() / "src" / folder / "CMakeLists.txt"));
        EXPECT_TRUE(fs::exists(poinsot::source_folder() / "tests" / folder / "CMakeLists.txt"));
    }
}

}  // namespace
