// A program that makes drawings needs neither OpenGL, FFmpeg nor files:
// tests/outputs/production/alone.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "places.h"
#include "production/alone/count_shapes.h"
#include "production/session/picture_setting.h"
#include "production/session/session.h"
#include "sanitized.h"
#include "scene/files/load_scene.h"
#include "system/files/file_contents.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

constexpr const char* program = POINSOT_DRAWING_OF;

// What a command line prints.
std::string printed_by(const std::string& command) {
    std::string text;
    FILE* const pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return text;
    std::array<char, 4096> block{};
    for (std::size_t n = 0; (n = std::fread(block.data(), 1, block.size(), pipe)) > 0;)
        text.append(block.data(), n);
    EXPECT_EQ(::pclose(pipe), 0) << command;
    return text;
}

// The programs' input: each file as a line "NAME N_BYTES" and its bytes.
class Given {
 public:
    Given() : path_(std::filesystem::path(testing::TempDir()) / "drawing_of_input") {
        std::ofstream(path_, std::ios::binary);
    }
    ~Given() { std::filesystem::remove(path_); }
    Given(const Given&) = delete;
    Given& operator=(const Given&) = delete;

    void add(std::string_view name, const std::string& bytes) const {
        std::ofstream(path_, std::ios::binary | std::ios::app)
            << name << ' ' << bytes.size() << '\n'
            << bytes;
    }
    const std::filesystem::path& path() const { return path_; }

 private:
    std::filesystem::path path_;
};

TEST(DrawingAlone, IsMadeFromBytesWithNoFileToOpen) {
    if (sanitized) GTEST_SKIP() << "the sanitizers read their lists of known reports from files";
    for (const char* const name : {"generic.toml", "heavy_top_looping.toml", "four_views.toml"}) {
        const std::filesystem::path file = source_folder() / "scenes" / name;
        const Given given;
        for (const std::string_view font : font_names())
            given.add(font, read_text(find_font(font)));
        given.add(name, read_text(file));
        const std::string said =
            printed_by(std::string(program) + " 1.5 < " + given.path().string());

        SessionRequest request{installed_fonts()};
        request.times_s = {1.5};
        const Session session = session_of(load_scene(file), request);
        const Stage stage =
            stage_of(session, {.first_time_s = 0.0, .last_time_s = 1.5}, setting_of(session.scene));
        const std::size_t n = n_shapes(stage.at(1.5));
        EXPECT_GT(n, 10u) << name;
        EXPECT_EQ(said, std::to_string(n) + "\n") << name;
    }
}

TEST(DrawingAlone, LinksNoFileOpenGLOrFFmpeg) {
    if (sanitized) GTEST_SKIP() << "the sanitizers link all of these";
    const std::string symbols =
        printed_by(std::string(POINSOT_NM) + " --dynamic --undefined-only " + program);
    const std::string libraries =
        printed_by(std::string(POINSOT_READELF) + " --dynamic " + program);
    // What it does need shows that the lists are those of this program.
    EXPECT_NE(symbols.find(" FT_Load_Glyph"), std::string::npos);
    EXPECT_NE(libraries.find("[libharfbuzz.so"), std::string::npos);

    // File streams and std::filesystem, except for its paths, are functions of libstdc++; open and
    // the like are functions of libc.
    const std::regex of_files(
        "_ZNK?St(13basic_filebuf|14basic_ifstream|14basic_ofstream|13basic_fstream)|"
        "_ZNK?St10filesystem(?!7__cxx114path)|"
        "^(open|openat|creat|fopen|freopen|opendir|mkstemp|dlopen|stat|lstat|fstatat|readlink|"
        "realpath)(64)?(@|$)");
    const std::regex of_others("^(gl[A-Z]|egl[A-Z]|OSMesa|av_|avcodec_|avformat_|sws_|cairo_)");
    std::istringstream lines(symbols);
    int n_symbols = 0;
    for (std::string kind, symbol; lines >> kind >> symbol; ++n_symbols) {
        EXPECT_FALSE(std::regex_search(symbol, of_files)) << symbol;
        EXPECT_FALSE(std::regex_search(symbol, of_others)) << symbol;
    }
    EXPECT_GT(n_symbols, 100);
    for (const char* const library : {"libav", "libsw", "libGL", "libEGL", "libOSMesa", "libcairo"})
        EXPECT_EQ(libraries.find(std::string("[") + library), std::string::npos) << library;
}

}  // namespace
}  // namespace poinsot
