// Checks the includes that includes.txt allows: the layers of src/, their subfolders, and the
// folders that may use a library; and that tests are found by the names of their sources.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "places.h"

namespace {

namespace fs = std::filesystem;

using Table = std::map<std::string, std::set<std::string>>;

// A section of includes.txt: the words of each row by the row's name.
const Table& rows_of(const std::string& section) {
    static const std::map<std::string, Table> sections = [] {
        std::map<std::string, Table> read;
        std::ifstream file(poinsot::source_folder() / "tests" / "house" / "includes.txt");
        std::string within;
        for (std::string line, name; std::getline(file, line);) {
            std::istringstream words(line.substr(0, line.find('#')));
            if (!(words >> name)) continue;
            name.pop_back();
            if (name.front() == '[')
                within = name.substr(1);
            else
                read[within][name].insert(std::istream_iterator<std::string>(words), {});
        }
        return read;
    }();
    return sections.at(section);
}

bool has(const Table& rows, const std::string& name, const std::string& word) {
    const auto row = rows.find(name);
    return row != rows.end() && row->second.contains(word);
}

// A list of this length is still readable.
constexpr int most_headers = 20;

std::vector<fs::path> sources_below(const std::string& folder) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(poinsot::source_folder() / folder)) {
        const std::string extension = entry.path().extension().string();
        if (extension == ".h" || extension == ".cpp") found.push_back(entry.path());
    }
    return found;
}

std::vector<std::string> lines_of(const fs::path& path) {
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

struct Include {
    std::string from_file;  // without src/ and its wing
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

// "mechanics/torque.h" of src/motion/mechanics/torque.h.
fs::path inside_its_wing(const fs::path& source) {
    const fs::path relative = fs::relative(source, poinsot::source_folder() / "src");
    return relative.lexically_relative(*relative.begin());
}

// The wing of each folder of src/.
const std::map<std::string, std::string>& wings() {
    static const std::map<std::string, std::string> found = [] {
        std::map<std::string, std::string> wing_of;
        for (const auto& [wing, before] : rows_of("wings"))
            for (const auto& entry :
                 fs::directory_iterator(poinsot::source_folder() / "src" / wing))
                if (entry.is_directory()) wing_of[entry.path().filename().string()] = wing;
        return wing_of;
    }();
    return found;
}

std::vector<Include> includes_of_sources() {
    std::vector<Include> found;
    for (const fs::path& source : sources_below("src")) {
        const fs::path relative = inside_its_wing(source);
        if (relative.begin() == std::prev(relative.end())) continue;  // main.cpp
        for (const std::string& line : lines_of(source)) {
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
    const Table& allowed = rows_of("folders");
    ASSERT_GT(found.size(), 100u);
    for (const Include& include : found) {
        if (!include.quoted) continue;
        const auto slash = include.header.find('/');
        ASSERT_NE(slash, std::string::npos)
            << include.from_file << " includes \"" << include.header << "\" without its folder";
        const std::string folder = include.header.substr(0, slash);
        ASSERT_TRUE(allowed.contains(include.from_folder)) << include.from_folder;
        EXPECT_TRUE(folder == include.from_folder || has(allowed, include.from_folder, folder))
            << include.from_file << " must not include \"" << include.header << "\"";
    }
}

TEST(House, AWingIncludesOnlyTheWingsBeforeIt) {
    std::set<std::string> in_src;
    for (const auto& entry : fs::directory_iterator(poinsot::source_folder() / "src"))
        if (entry.is_directory()) in_src.insert(entry.path().filename().string());
    EXPECT_EQ(in_src,
              (std::set<std::string>{"base", "cmake", "doors", "motion", "outputs", "picture"}));
    EXPECT_EQ(wings().size(), rows_of("folders").size());
    int n_between = 0;
    for (const Include& include : includes_of_sources()) {
        const std::string folder = include.header.substr(0, include.header.find('/'));
        if (!include.quoted || folder == "shaders") continue;
        ASSERT_TRUE(wings().contains(folder)) << include.from_file << ": " << include.header;
        const std::string& from = wings().at(include.from_folder);
        const std::string& to = wings().at(folder);
        n_between += from != to;
        EXPECT_TRUE(from == to || has(rows_of("wings"), from, to))
            << include.from_file << " of src/" << from << " must not include \"" << include.header
            << "\" of src/" << to;
    }
    EXPECT_GT(n_between, 100);
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
        const std::string to = include.quoted ? subfolder_of(include.header) : "";
        if (to.empty() || to == from || to.substr(0, to.find('/')) != include.from_folder) continue;
        EXPECT_TRUE(has(rows_of("subfolders"), from, to))
            << include.from_file << " must not include \"" << include.header << "\"";
    }
}

TEST(House, OtherFoldersIncludeOnlyTheShownSubfolder) {
    int n_includes = 0;
    for (const Include& include : includes_of_sources()) {
        const auto slash = include.header.find('/');
        if (!include.quoted || slash == std::string::npos) continue;
        const std::string folder = include.header.substr(0, slash);
        if (!rows_of("shown").contains(folder) || folder == include.from_folder) continue;
        ++n_includes;
        EXPECT_TRUE(has(rows_of("shown"), folder, subfolder_of(include.header)))
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
        const std::string& wing = wings().at(folder.substr(0, folder.find('/')));
        for (const auto& entry : fs::directory_iterator(src / wing / folder)) {
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
        const std::string subfolder = subfolder_of(include.from_file);
        if (!rows_of("less").contains(subfolder) || !include.quoted) continue;
        ++n_includes;
        const std::string folder = include.header.substr(0, include.header.find('/'));
        EXPECT_TRUE(folder == include.from_folder || has(rows_of("less"), subfolder, folder))
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
        EXPECT_FALSE(has(rows_of("without_files"), "folders", include.from_folder) ||
                     has(rows_of("without_files"), "subfolders", subfolder))
            << include.from_file << " must not include " << include.header
            << "; code that reads the disk belongs to a subfolder files/";
    }
    EXPECT_GT(n_in_files, 10);
}

TEST(House, FoldersHaveFewHeaders) {
    std::map<std::string, int> n_headers;
    for (const fs::path& source : sources_below("src"))
        if (source.extension() == ".h") ++n_headers[source.parent_path().string()];
    EXPECT_GT(n_headers.size(), 20u);
    for (const auto& [folder, n] : n_headers)
        EXPECT_LE(n, most_headers) << folder << ": give it subfolders";
}

TEST(House, LibrariesAreUsedOnlyInTheirFolders) {
    for (const Include& include : includes_of_sources()) {
        for (const auto& [beginning, owners] : rows_of("libraries")) {
            if (include.header.rfind(beginning, 0) != 0 || include.quoted) continue;
            EXPECT_TRUE(owners.contains(include.from_folder))
                << include.from_file << " must not include <" << include.header << ">";
        }
    }
}

// A long double has 53, 64 or 113 bits, so digits would depend on the platform. A value that is
// rounded to it and then to double is rounded twice.
TEST(House, NoResultPassesThroughLongDouble) {
    const std::vector<fs::path> sources = sources_below("src");
    for (const fs::path& source : sources)
        for (const std::string& line : lines_of(source))
            EXPECT_EQ(line.substr(0, line.find("//")).find("long double"), std::string::npos)
                << fs::relative(source, poinsot::source_folder()) << ": " << line;
    EXPECT_GT(sources.size(), 100u);
}

// Eigen's functions of arrays are not those of the C library in whole packets, and its stableNorm
// sums differently; where packets begin depends on the address. So norm_of and std::exp instead.
TEST(House, NoDigitDependsOnWhereAVectorLies) {
    const std::regex forbidden(
        R"(\b(stableNorm|blueNorm|hypotNorm)\(|\.(exp|expm1|log|log1p|pow|sin|cos|tan|asin|acos|atan|sinh|cosh|tanh)\(\))");
    ASSERT_TRUE(std::regex_search("v.array().exp()", forbidden));
    const std::vector<fs::path> sources = sources_below("src");
    for (const fs::path& source : sources)
        for (const std::string& line : lines_of(source))
            EXPECT_FALSE(std::regex_search(line.substr(0, line.find("//")), forbidden))
                << fs::relative(source, poinsot::source_folder()) << ": " << line;
    EXPECT_GT(sources.size(), 100u);
}

// fmt 11 has join in ranges.h alone; fmt 9 gives it without, so that Debian 12 misses nothing.
TEST(House, WhoJoinsIncludesRanges) {
    int n_joining = 0;
    for (const std::string folder : {"src", "tests"}) {
        for (const fs::path& source : sources_below(folder)) {
            bool joins = false;
            bool includes_ranges = false;
            for (const std::string& line : lines_of(source)) {
                // Split, so that this file does not contain the searched string.
                joins = joins || line.find(std::string("fmt:") + ":join(") != std::string::npos;
                includes_ranges = includes_ranges || included_header(line) == "<fmt/ranges.h";
            }
            n_joining += joins;
            EXPECT_TRUE(!joins || includes_ranges)
                << fs::relative(source, poinsot::source_folder()) << " uses fmt::"
                << "join"
                << " without <fmt/ranges.h>";
        }
    }
    EXPECT_GT(n_joining, 10);
}

TEST(House, MainIncludesOnlyTheCommandLine) {
    const std::vector<std::string> lines =
        lines_of(poinsot::source_folder() / "src" / "doors" / "main.cpp");
    ASSERT_FALSE(lines.empty());
    for (const std::string& line : lines) {
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
        if (relative.string().starts_with("doors/cli/") ||
            (!is_cmake && extension != ".cpp" && extension != ".h"))
            continue;
        ++n_files;
        for (const std::string& line : lines_of(entry.path())) {
            if (is_cmake)
                EXPECT_EQ(line.find("poinsot_cli"), std::string::npos) << relative << ": " << line;
            else
                EXPECT_NE(included_header(line).rfind("\"cli/", 0), 0u) << relative << ": " << line;
        }
    }
    EXPECT_GT(n_files, 100);
}

// Who reads src/doors/cli/still.cpp looks for still_test.cpp.
TEST(House, TestsBearTheNamesOfSources) {
    std::set<std::string> sources;
    for (const fs::path& source : sources_below("src")) sources.insert(source.stem().string());
    std::size_t n_without = 0;
    const fs::path tests = poinsot::source_folder() / "tests";
    for (const fs::path& source : sources_below("tests")) {
        std::string file = fs::relative(source, tests).string();
        if (!file.ends_with("_test.cpp")) continue;
        if (rows_of("wings").contains(file.substr(0, file.find('/'))))
            file.erase(0, file.find('/') + 1);
        const std::string test = file.substr(0, file.size() - std::string("_test.cpp").size());
        const bool listed = rows_of("tests_without_source").contains(test);
        n_without += listed;
        EXPECT_NE(sources.contains(fs::path(test).filename().string()), listed)
            << file
            << ": give it the name of the source file that it tests, or list it in includes.txt";
    }
    EXPECT_EQ(n_without, rows_of("tests_without_source").size());
}

TEST(House, EveryFolderHasTestsAndATarget) {
    for (const auto& [folder, others] : rows_of("folders")) {
        if (folder == "error") continue;
        const fs::path in_wing = fs::path(wings().at(folder)) / folder / "CMakeLists.txt";
        EXPECT_TRUE(fs::exists(poinsot::source_folder() / "src" / in_wing)) << in_wing;
        EXPECT_TRUE(fs::exists(poinsot::source_folder() / "tests" / in_wing)) << in_wing;
    }
}

}  // namespace
