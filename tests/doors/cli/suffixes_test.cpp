// File suffixes are case-insensitive in every command: no source file is responsible for all of
// them.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/program_run.h"
#include "cli/recorded_pictures.h"
#include "cli/small_scene.h"
#include "encoding/frame_sink.h"

namespace poinsot::testing {
namespace {

namespace fs = std::filesystem;

using PicturesOfSuffixes = Pictures;
using MessagesOfSuffixes = Messages;

TEST_F(PicturesOfSuffixes, WithSuffixesInCapitalsWorkInEveryCommand) {
    draw("ref/a.PNG", "--portable --time 0.1");
    draw("new/a.PNG", "--portable --time 0.1");
    EXPECT_EQ(run("compare ref/a.PNG new/a.PNG").code, 0);
    EXPECT_EQ(run("compare ref/a.PNG new/a.PNG --diff d.PNG").code, 0);
    EXPECT_TRUE(fs::exists(folder_.path() / "d.PNG"));
    const ProgramRun explained = run("explain new/a.PNG --verify");
    EXPECT_EQ(explained.code, 0) << explained.err << explained.out;
    EXPECT_EQ(run("rerender new/a.PNG -o again.Png -q").code, 0);
    EXPECT_TRUE(text_of(folder_.path() / "again.Png") == text_of(folder_.path() / "new/a.PNG"));
    fs::remove_all(folder_.path() / "ref");
    EXPECT_EQ(approve("a.PNG").out, "a: new\n");
    EXPECT_EQ(approve("a").out, "a: unchanged\n");
    EXPECT_EQ(run("compare ref new").code, 0);

    for (const char* film : {"f.MP4", "f.WebM", "f.GIF"}) {
        const std::string name = film;
        const ProgramRun made = run("render scene.toml --frames 0-2 --portable -q -o " + name);
        EXPECT_EQ(made.code, 0) << made.err;
        EXPECT_EQ(run("explain --verify " + name).code, 0) << name;
        EXPECT_EQ(run("rerender -q -o again_" + name + " " + name).code, 0) << name;
        EXPECT_TRUE(text_of(folder_.path() / name) == text_of(folder_.path() / ("again_" + name)));
    }
    EXPECT_EQ(run("render scene.toml --frames 0-2 --portable -q -o 's_##.PNG'").code, 0);
    EXPECT_EQ(run("explain --verify s_02.PNG").code, 0);
    EXPECT_EQ(run("rerender s_02.PNG -q -o again_02.PNG").code, 0);
    EXPECT_TRUE(text_of(folder_.path() / "s_02.PNG") == text_of(folder_.path() / "again_02.PNG"));
}

TEST_F(MessagesOfSuffixes, RenderNamesEveryFilm) {
    const std::string help = run("render --help").out;
    for (const OutputFormat& format : output_formats()) {
        if (!format.film) continue;
        EXPECT_NE(help.find(format.suffix), std::string::npos) << format.name;
    }
}

TEST_F(MessagesOfSuffixes, SuffixesAreCaseInsensitive) {
    ASSERT_EQ(run("render scene.toml --frames 0-1 -o a.mp4").code, 0);
    ASSERT_EQ(run("render scene.toml --frames 0-1 -o B.MP4").code, 0);
    EXPECT_EQ(text_of(folder_.path() / "a.mp4"), text_of(folder_.path() / "B.MP4"));
    ASSERT_EQ(run("still scene.toml -o A.PNG").code, 0);
    ASSERT_EQ(run("rerender A.PNG -o B.Png").code, 0);
    EXPECT_EQ(text_of(folder_.path() / "A.PNG"), text_of(folder_.path() / "B.Png"));
    EXPECT_EQ(run("explain B.MP4").code, 0);
    ASSERT_EQ(run("render scene.toml -q --frames 0-2 -o 'f_#.PNG'").code, 0);
    const ProgramRun joined = run("join 'f_#.PNG' -q -o 'g_#.PNG'");
    EXPECT_EQ(joined.code, 0) << joined.err;
    EXPECT_EQ(text_of(folder_.path() / "f_2.PNG"), text_of(folder_.path() / "g_2.PNG"));
}

}  // namespace
}  // namespace poinsot::testing
