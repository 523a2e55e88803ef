// compare: two pictures or two folders, exactly or within limits.
#include <gtest/gtest.h>

#include <array>
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
    // What the records say comes first.
    EXPECT_TRUE(contains(pixels.out, "pixels: b: time in s: 0.1 → 0.11; ")) << pixels.out;
    // Without a second picture there is no difference to show, and nothing says that none differs.
    const ProgramRun missing = run("compare a.png none.png --diff none_d.png");
    EXPECT_EQ(missing.code, 1);
    EXPECT_TRUE(contains(missing.out, "missing: none: ")) << missing.out;
    EXPECT_EQ(missing.err, "");
    EXPECT_FALSE(fs::exists(folder_.path() / "none_d.png"));
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
    EXPECT_TRUE(contains(shallow.out, "depth: a: ") &&
                contains(shallow.out, "expected 16 bits per component, found 8"))
        << shallow.out;
}

// Ignoring what changed makes pictures pass; ignoring something else does not.
TEST_F(ComparedPictures, PassWhereWhatChangedIsIgnored) {
    draw("a.png", "--portable --time 0.1 --set caption=first --size 640x360");
    draw("caption.png", "--portable --time 0.1 --set caption=other --size 640x360");
    draw("polhode.png",
         "--portable --time 0.1 --set caption=first --set style.polhode='\"#1060ff\"' --size "
         "640x360");
    draw("labels.png",
         "--portable --time 0.1 --set caption=first --set labels=false --size 640x360");
    for (const auto& [picture, region, other] :
         {std::array{"caption", "caption", "title"}, std::array{"polhode", "polhode", "clock"},
          std::array{"labels", "labels", "caption"}}) {
        const std::string pair = std::string("compare a.png ") + picture + ".png ";
        EXPECT_EQ(run(pair).code, 1) << picture;
        const ProgramRun passes = run(pair + "--ignore " + region);
        EXPECT_EQ(passes.code, 0) << passes.out << passes.err;
        EXPECT_EQ(run(pair + "--ignore " + other).code, 1) << picture;
        // A region is a part of the picture.
        const ProgramRun json = run(pair + "--json --ignore " + region);
        const std::string n_ignored = json.out.substr(json.out.find("\"n_ignored\": ") + 13);
        EXPECT_GT(std::stoi(n_ignored), 0);
        EXPECT_LT(std::stoi(n_ignored), 640 * 360 / 4) << region;
    }
    const ProgramRun style = run("compare a.png polhode.png");
    EXPECT_TRUE(contains(style.out, "pixels: polhode: style.polhode: default → #1060ff; "))
        << style.out;
    const ProgramRun unused = run("compare a.png caption.png --ignore cones");
    EXPECT_TRUE(
        contains(unused.err, "note: \"cones\" is ignored, but none of the pictures that differ"))
        << unused.err;
}

// Panel body also draws the other polhodes, in the same style.
TEST_F(ComparedPictures, OfPanelBodyPassWhereThePolhodesAreIgnored) {
    folder_.write("body.toml", racket + "[[panels]]\nkind = \"body\"\n");
    const std::string still = "still body.toml -q --portable --time 0.1 --size 480x270 ";
    ASSERT_EQ(run(still + "-o a.png").code, 0);
    ASSERT_EQ(run(still + "-o b.png --set 'style.polhode=\"#1060ff\"'").code, 0);
    EXPECT_EQ(run("compare a.png b.png").code, 1);
    EXPECT_EQ(run("compare a.png b.png --ignore separatrix --diff d.png").code, 1);
    const ProgramRun passes = run("compare a.png b.png --ignore polhode");
    EXPECT_EQ(passes.code, 0) << passes.out;
    // The motion's own polhode is left.
    EXPECT_EQ(run("compare a.png b.png --ignore polhodes").code, 1);
    // In --diff, ignored regions are grey.
    const Image sheet = read_png(folder_.path() / "d.png");
    int n_grey = 0;
    for (int y = 0; y < sheet.height(); ++y)
        for (int x = 480; x < 960; ++x) n_grey += sheet.at(x, y) == Rgba8{110, 110, 110, 255};
    EXPECT_GT(n_grey, 500);
    EXPECT_LT(n_grey, 480 * 270 / 2);
}

// A JPEG beside PNGs is easily taken for compared.
TEST_F(ComparedPictures, OfOtherKindsAreNamedInANote) {
    draw("ref/a.png", "--portable --time 0.1");
    fs::copy(folder_.path() / "ref/a.png", folder_.path() / "new/a.png");
    EXPECT_EQ(run("compare ref new").err, "");
    for (const char* name : {"b.jpg", "c.JPEG", "d.webp", "e.tif"})
        folder_.write(std::string("new/") + name, "x");
    const ProgramRun compared = run("compare ref new");
    EXPECT_EQ(compared.code, 0);
    EXPECT_EQ(compared.err,
              "note: new: not compared, because these pictures are not PNGs: b.jpg, c.JPEG, d.webp "
              "and 1 more\n");
    EXPECT_EQ(run("compare -q ref new").err, "");
}

TEST_F(ComparedPictures, PassByTheLimitsOfMeasures) {
    draw("a.png", "--portable --time 0.1");
    draw("b.png", "--portable --time 0.11");
    EXPECT_EQ(run("compare a.png b.png --max-flip 0.9 --min-ssim 0.1").code, 0);
    const ProgramRun flip = run("compare a.png b.png --max-flip 1e-9");
    EXPECT_EQ(flip.code, 1);
    EXPECT_TRUE(contains(flip.out, "FLIP") && !contains(flip.out, "SSIM")) << flip.out;
    EXPECT_EQ(run("compare a.png b.png --min-ssim 1").code, 1);
    // Entries name baselines.
    folder_.write("compare.toml", "[[pictures]]\nname = \"a\"\nmax_flip = 0.9\n");
    EXPECT_EQ(run("compare a.png b.png").code, 0);
    // In two files, an entry may be for another picture; the command line is above the file.
    EXPECT_EQ(run("compare a.png b.png --max-flip 0").code, 1);
    folder_.write("compare.toml", "[[pictures]]\nname = \"b\"\nmax_flip = 0.9\n");
    EXPECT_EQ(run("compare a.png b.png").code, 1);
    const ProgramRun json = run("compare a.png b.png --antialiasing --json");
    EXPECT_TRUE(contains(json.out, "\"antialiasing\": true") &&
                !contains(json.out, "\"antialiasing\": false"))
        << json.out;
}

TEST_F(ComparedPictures, HaveReportsWithTheirPicturesBesideThem) {
    draw("ref/a.png", "--portable --time 0.1");
    draw("new/a.png", "--portable --time 0.3");
    EXPECT_EQ(run("compare ref new --report report.html").code, 1);
    EXPECT_TRUE(fs::exists(folder_.path() / "report_pictures/a-difference.png"));
    const std::string page = text_of(folder_.path() / "report.html");
    EXPECT_TRUE(contains(page, "--results new --baselines ref")) << page;
    fs::remove_all(folder_.path() / "report_pictures");
    EXPECT_EQ(run("compare ref new --report report.html --single-file").code, 1);
    EXPECT_FALSE(fs::exists(folder_.path() / "report_pictures"));
    for (const char* line :
         {"compare ref new --report new/report.html", "compare ref new --single-file"}) {
        const ProgramRun refused = run(line);
        EXPECT_EQ(refused.code, 2) << line;
        EXPECT_TRUE(is_one_line(refused.err)) << refused.err;
    }
}

TEST_F(ComparedPictures, GiveGitHubAJobSummary) {
    draw("ref/a.png", "--portable --time 0.1");
    draw("new/a.png", "--portable --time 0.3");
    const ProgramRun github =
        run_program_in(folder_, "compare ref new --github", "GITHUB_STEP_SUMMARY=summary.md");
    EXPECT_EQ(github.code, 1);
    EXPECT_TRUE(contains(github.out, "\n::error file=ref/a.png,title=pixels%3A a::")) << github.out;
    EXPECT_TRUE(contains(text_of(folder_.path() / "summary.md"), "| pixels | a | time in s: 0.1"));
    EXPECT_EQ(run("compare ref new --github").code, 1);
}

// A film against itself, against one that differs from some instant on, against a shorter one and
// against other formats.
TEST_F(ComparedPictures, MayBeFilms) {
    const auto film = [this](const std::string& file, const std::string& options) {
        const ProgramRun made = run("render scene.toml -q --portable -o " + file + " " + options);
        ASSERT_EQ(made.code, 0) << made.err;
    };
    film("a.mp4", "");
    film("b.mp4", "--theme dark");
    film("short.mp4", "--frames 0-9");
    film("slow.mp4", "--fps 15");
    film("wide.mp4", "--size 130x72");
    film("a_####.png", "");
    film("a20.mp4", "--fps 20");
    film("a.gif", "--fps 20");
    film("a.webm", "");
    EXPECT_EQ(run("compare a.mp4 a.mp4").code, 0);
    EXPECT_EQ(run("compare 'a_####.png' 'a_####.png'").code, 0);
    const ProgramRun dark = run("compare a.mp4 b.mp4 --diff strip.png --report report.html");
    EXPECT_EQ(dark.code, 1);
    EXPECT_EQ(
        dark.out.find("pixels: b.mp4: theme: light → dark; 15 of 15 frames exceed the limits; "
                      "first frame 0 (0 s), worst frame "),
        0u)
        << dark.out;
    EXPECT_EQ(read_png(folder_.path() / "strip.png").width(), 3 * 128);
    EXPECT_TRUE(fs::exists(folder_.path() / "report_pictures/b.mp4-strip.png"));
    const ProgramRun shorter = run("compare a.mp4 short.mp4 --max-flip 1");
    EXPECT_EQ(shorter.code, 1);
    EXPECT_TRUE(contains(shorter.out, "length: short.mp4: ") &&
                contains(shorter.out, "expected 15 frames, found 10; of the first 10, "))
        << shorter.out;
    EXPECT_TRUE(
        contains(run("compare a.mp4 slow.mp4").out, "expected 30 frames a second, found 15"));
    EXPECT_TRUE(
        contains(run("compare a.mp4 wide.mp4").out, "expected 128×72 pixels, found 130×72"));
    // Lossy encoding is within a limit of what is seen.
    EXPECT_EQ(run("compare 'a_####.png' a.mp4").code, 1);
    const ProgramRun lossy = run("compare 'a_####.png' a.mp4 --max-flip 0.1");
    EXPECT_EQ(lossy.code, 0) << lossy.out;
    // FLIP 0.056 and 0.039 are measured.
    for (const char* pair : {"compare a20.mp4 a.gif", "compare a.mp4 a.webm"}) {
        EXPECT_EQ(run(pair).code, 1) << pair;
        const ProgramRun within = run(std::string(pair) + " --max-flip 0.1");
        EXPECT_EQ(within.code, 0) << within.out << within.err;
    }
    // Two of the ten delays of 0.05 s are 0.06 s: together less than half a frame.
    std::string gif = text_of(folder_.path() / "a.gif");
    std::size_t delay = 0;
    for (int k = 0; k < 2; ++k) {
        delay = gif.find(std::string("\x21\xF9\x04", 3), delay) + 4;
        ASSERT_EQ(gif.at(delay), 5);
        gif[delay] = 6;
    }
    folder_.write("uneven.gif", gif);
    const ProgramRun uneven = run("compare a20.mp4 uneven.gif --max-flip 0.1");
    EXPECT_EQ(uneven.code, 0) << uneven.out << uneven.err;
    const ProgramRun nothing = run("compare a.mp4 b.mp4 --ignore 0%,0%,100%,100%");
    EXPECT_EQ(nothing.code, 1);
    EXPECT_TRUE(contains(nothing.out, "region: b.mp4: ")) << nothing.out;
    // A sequence, and a film of the same frames.
    EXPECT_TRUE(contains(run("compare 'a_####.png' a.mp4").out,
                         "pixels: a.mp4: scene, settings and versions are the same; "));
    for (const char* output : {"--diff a_0003.png", "--report a_0003.png", "--diff ./a_0040.png"}) {
        const std::string before = text_of(folder_.path() / "a_0003.png");
        const ProgramRun refused = run(std::string("compare a.mp4 'a_####.png' ") + output);
        EXPECT_EQ(refused.code, 2) << output;
        EXPECT_TRUE(contains(refused.err, "is a picture of a sequence")) << refused.err;
        EXPECT_TRUE(text_of(folder_.path() / "a_0003.png") == before) << output;
    }
    EXPECT_EQ(run("compare none.mp4 'a_####.png'").code, 2);
    fs::remove(folder_.path() / "a_0007.png");
    const ProgramRun gap = run("compare a.mp4 'a_####.png'");
    EXPECT_EQ(gap.code, 2);
    EXPECT_TRUE(contains(gap.err, "a_0007.png: this picture of the sequence is missing"))
        << gap.err;
    folder_.write("broken.mp4", text_of(folder_.path() / "a.mp4").substr(0, 700));
    const ProgramRun broken = run("compare a.mp4 broken.mp4");
    EXPECT_EQ(broken.code, 2);
    EXPECT_TRUE(is_one_line(broken.err)) << broken.err;
    EXPECT_TRUE(contains(run("compare a.mp4 a_0001.png").err, "different kinds of files"));
}

// A folder with films and figures: each is compared with its like, by its full name.
TEST_F(ComparedPictures, MayBeInFoldersWithFilmsAndFigures) {
    for (const char* folder : {"ref", "new"}) {
        const std::string options = std::string(folder) == "ref" ? "" : " --theme dark";
        draw(folder + std::string("/a.png"), "--portable --time 0.1");
        draw(folder + std::string("/a.pdf"), "--time 0.1 --width-mm 120 --height-mm 90" + options);
        ASSERT_EQ(run(std::string("render scene.toml -q --portable -o ") + folder +
                      "/a.mp4 --frames 0-3" + options)
                      .code,
                  0);
    }
    const ProgramRun compared = run("compare ref new");
    EXPECT_EQ(compared.code, 1);
    EXPECT_TRUE(contains(compared.out, ": a.mp4: theme: light → dark; ")) << compared.out;
    EXPECT_TRUE(contains(compared.out, ": a.pdf: theme: light → dark; ")) << compared.out;
    EXPECT_TRUE(contains(compared.out, "3 compared, 2 failed, 1 the same")) << compared.out;
    EXPECT_EQ(run("approve --all --results new --baselines fresh").out,
              "a: new\na.mp4: new\na.pdf: new\n");
}

TEST_F(CompareMessages, CompareSaysWhatItNeeds) {
    refuses("compare a.png", 2,
            {"needs two pictures or two folders; one is given", "see poinsot compare --help"});
    refuses("compare", 2, {"needs two pictures or two folders; none is given"});
    refuses("compare a.png a.png --max-flip 2", 2, {"--max-flip 2: not a FLIP value"});
    refuses("compare a.png a.png --min-ssim two", 2, {"--min-ssim"});
    refuses("compare a.png a.png --max-differing 101%", 2,
            {"--max-differing 101%: not a share of the pixels"});
    refuses("compare a.png a.png --ignore clok", 2,
            {"--ignore unknown region \"clok\"; did you mean \"clock\"?"});
    refuses("compare a.png a.png --ignore 1,2,3", 2, {"--ignore 1,2,3: not a rectangle"});
    refuses("compare 'none_##.png' a.png", 2, {"none_##.png: no picture has such a name"});
    refuses("compare a b c", 2, {"needs two pictures or two folders; 3 are given"});
}

}  // namespace
}  // namespace poinsot::testing
