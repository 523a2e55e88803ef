// compare: two pictures or two folders, exactly or within limits.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/program_run.h"
#include "cli/recorded_pictures.h"
#include "cli/small_scene.h"
#include "image/files/png_bands.h"
#include "image/files/png_files.h"

namespace poinsot::testing {
namespace {

namespace fs = std::filesystem;

using ComparedPictures = Pictures;
using CompareMessages = Messages;

TEST_F(ComparedPictures, ReportTheirDifferences) {
    draw("a.png", "--portable --time 0.1");
    draw("b.png", "--portable --time 0.11");
    draw("c.png", "--portable --time 0.1 --size 130x72");
    EXPECT_EQ(run("compare a.png a.png").code, 0);
    const ProgramRun pixels = run("compare a.png b.png --diff d.png");
    EXPECT_EQ(pixels.code, 1);
    EXPECT_TRUE(contains(pixels.out, "pixels: b: ")) << pixels.out;
    EXPECT_EQ(pixels.err, "");
    // Expected, difference and actual side by side.
    EXPECT_GE(read_png(folder_.path() / "d.png").width(), 3 * 128);
    const ProgramRun size = run("compare a.png c.png");
    EXPECT_EQ(size.code, 1);
    EXPECT_TRUE(contains(size.out, "size: c: ")) << size.out;
    const ProgramRun missing = run("compare a.png none.png");
    EXPECT_EQ(missing.code, 1);
    EXPECT_TRUE(contains(missing.out, "missing: none: ")) << missing.out;
    folder_.write("broken.png", text_of(folder_.path() / "a.png").substr(0, 500));
    const ProgramRun broken = run("compare a.png broken.png");
    EXPECT_EQ(broken.code, 2);
    EXPECT_TRUE(is_one_line(broken.err)) << broken.err;
}

TEST_F(ComparedPictures, AreNotOverwritten) {
    draw("a.png", "--portable --time 0.1");
    draw("b.png", "--portable --time 0.11");
    fs::create_symlink("a.png", folder_.path() / "link.png");
    const std::string before = text_of(folder_.path() / "a.png");
    for (const char* options :
         {"--diff a.png", "--diff ./b.png", "--diff link.png", "--report a.png", "--junit b.png",
          "--diff d.png --report d.png", "--report x.html --junit ./x.html"}) {
        const ProgramRun run_of = run(std::string("compare a.png b.png ") + options);
        EXPECT_EQ(run_of.code, 2) << options;
        EXPECT_TRUE(is_one_line(run_of.err)) << run_of.err;
        EXPECT_TRUE(text_of(folder_.path() / "a.png") == before) << options;
        EXPECT_FALSE(fs::exists(folder_.path() / "d.png")) << options;
    }
}

// File suffixes are case-insensitive.
TEST_F(ComparedPictures, WithSuffixesInCapitalsAreCompared) {
    draw("ref/a.png", "--portable --time 0.1");
    fs::rename(folder_.path() / "ref/a.png", folder_.path() / "ref/a.PNG");
    draw("new/a.png", "--portable --time 0.3");
    fs::copy(folder_.path() / "ref/a.PNG", folder_.path() / "new/b.Png");
    const ProgramRun compared = run("compare ref new");
    EXPECT_EQ(compared.code, 1);
    EXPECT_TRUE(contains(compared.out, "pixels: a: ")) << compared.out;
    EXPECT_TRUE(contains(compared.out, "unexpected: b: ")) << compared.out;
}

TEST_F(ComparedPictures, InFoldersAreComparedInOnePass) {
    draw("ref/same.png", "--portable --time 0.1");
    fs::copy(folder_.path() / "ref/same.png", folder_.path() / "new/same.png");
    fs::copy(folder_.path() / "ref/same.png", folder_.path() / "ref/gone.png");
    fs::copy(folder_.path() / "ref/same.png", folder_.path() / "ref/turned.png");
    draw("new/turned.png", "--portable --time 0.3");
    const ProgramRun compared = run("compare ref new --json --report page.html --junit tests.xml");
    EXPECT_EQ(compared.code, 1);
    // The worst is first, in the JSON, the page and the test results.
    for (const std::string& text : {compared.out, text_of(folder_.path() / "page.html"),
                                    text_of(folder_.path() / "tests.xml")})
        EXPECT_LT(text.find("gone"), text.find("turned"));
    const std::string xml = text_of(folder_.path() / "tests.xml");
    EXPECT_TRUE(contains(xml, R"(tests="3" failures="2" errors="0")")) << xml;
}

// Another processor may draw a native picture differently. A note says so if this may be the only
// cause: the same scene and instant, and a few pixels that differ by a few levels.
TEST_F(ComparedPictures, WithoutPortableAreTold) {
    draw("a.png", "--time 0.1");
    draw("b.png", "--time 0.3");
    PngInfo info;
    Image rounded = read_png(folder_.path() / "a.png", &info);
    Rgba8 pixel = rounded.at(5, 5);
    pixel.g = static_cast<std::uint8_t>(pixel.g > 0 ? pixel.g - 1 : 1);
    rounded.set(5, 5, pixel);
    write_png(folder_.path() / "rounded.png", rounded, {.texts = info.texts});
    const ProgramRun told = run("compare a.png rounded.png");
    EXPECT_EQ(told.code, 1);
    EXPECT_TRUE(is_one_line(told.err) && contains(told.err, "--portable")) << told.err;
    EXPECT_TRUE(
        contains(told.err, "note: 1 pair differs by no more than the rounding of two processors"))
        << told.err;
    EXPECT_EQ(run("compare a.png rounded.png --quiet").err, "");
    EXPECT_EQ(run("compare a.png rounded.png --profile native").err, "");
    EXPECT_EQ(run("compare a.png a.png").err, "");
    // 0.07/100 in doubles would be 0.0007000000000000001.
    const ProgramRun capped = run("compare a.png a.png --json --max-differing 0.07%");
    EXPECT_TRUE(contains(capped.out, "\"differing_share\": 0.0007,")) << capped.out;
    // Another instant, or another theme, is no rounding.
    EXPECT_EQ(run("compare a.png b.png").err, "");
    draw("dark.png", "--time 0.1 --set theme=dark");
    EXPECT_EQ(run("compare a.png dark.png").err, "");
}

TEST_F(ComparedPictures, MeasureLikenessWhenAsked) {
    draw("a.png", "--portable --time 0.1");
    draw("b.png", "--portable --time 0.3");
    EXPECT_TRUE(contains(run("compare a.png b.png --json").out, "\"flip\": null"));
    EXPECT_FALSE(contains(run("compare a.png b.png").out, "FLIP"));
    const ProgramRun measured = run("compare a.png b.png --measures");
    EXPECT_TRUE(contains(measured.out, "FLIP") && contains(measured.out, "SSIM")) << measured.out;
    EXPECT_FALSE(contains(run("compare a.png b.png --measures --json").out, "\"flip\": null"));
}

// Two pictures that differ with 16 bits and are equal with 8 bits.
TEST_F(ComparedPictures, OfSixteenBitsAreComparedExactly) {
    draw("new/a.png", "--portable --time 0.1 --depth 16");
    ASSERT_EQ(approve("a").code, 0);
    StoredPicture picture = read_stored_png(folder_.path() / "new/a.png");
    for (std::uint16_t& sample : picture.deep.samples())
        if (sample % 257 == 0 && sample != 65535) ++sample;
    PngOptions options;
    options.texts = picture.info.texts;
    PngBandWriter writer(folder_.path() / "new/a.png", picture.deep.width(), picture.deep.height(),
                         true, options, 16);
    writer.write(picture.deep);
    writer.finish();
    ASSERT_TRUE(read_png(folder_.path() / "new/a.png") == picture.image);
    const ProgramRun compared = run("compare ref new");
    EXPECT_EQ(compared.code, 1);
    EXPECT_TRUE(contains(compared.out, "pixels: a: ")) << compared.out;
    EXPECT_NE(approve("a").out, "a: unchanged\n");

    draw("new/a.png", "--portable --time 0.1");
    const ProgramRun shallow = run("compare ref new --profile native");
    EXPECT_EQ(shallow.code, 1);
    EXPECT_TRUE(contains(shallow.out, "depth: a: expected 16 bits per component, found 8"))
        << shallow.out;
}

TEST_F(CompareMessages, CompareSaysWhatItNeeds) {
    refuses("compare a.png", 2,
            {"needs two pictures or two folders; one is given", "see poinsot compare --help"});
    refuses("compare", 2, {"needs two pictures or two folders; none is given"});
    refuses("compare a b c", 2, {"needs two pictures or two folders; 3 are given"});
}

}  // namespace
}  // namespace poinsot::testing
