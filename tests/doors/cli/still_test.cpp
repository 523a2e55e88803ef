// still: pictures of any scene, in any environment of the renderer, and for paper: their size,
// density, line widths, depth and bands.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <regex>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "cli/program_run.h"
#include "cli/small_scene.h"
#include "image/files/png_files.h"
#include "places.h"

namespace poinsot::testing {
namespace {

using StillMessages = Messages;

TEST(Still, HasTheRequestedSize) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const ProgramRun run =
        run_program_in(folder, "still scene.toml --time 0.5 --size 200x120 -o a.png");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.out, "");
    const Image image = read_png(folder.path() / "a.png");
    EXPECT_EQ(image.width(), 200);
    EXPECT_EQ(image.height(), 120);
}

// The pictures of all stops have one accuracy, said once.
TEST(Still, OfAllChaptersSaysItsAccuracyOnce) {
    const ScratchFolder folder;
    folder.write("scene.toml", std::string(racket) +
                                   "\n[[stops]]\nat_s = 0.1\n[[stops]]\nat_s = 0.2\n[[stops]]\n"
                                   "at_s = 0.3\n");
    const ProgramRun run =
        run_program_in(folder, "still scene.toml --chapters --size 64x36 -o a_##.png");
    ASSERT_EQ(run.code, 0) << run.err;
    const auto n_of = [&run](const std::string& text) {
        int n = 0;
        for (std::size_t at = run.err.find(text); at != std::string::npos;
             at = run.err.find(text, at + 1))
            ++n;
        return n;
    };
    EXPECT_EQ(n_of(" of the truth"), 1) << run.err;
    for (const char* name : {"a_01.png", "a_02.png", "a_03.png"}) EXPECT_EQ(n_of(name), 1) << name;
}

TEST(Still, IsReproducible) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    ASSERT_EQ(run_program_in(folder, "still scene.toml -o a.png").code, 0);
    ASSERT_EQ(run_program_in(folder, "still scene.toml -o b.png").code, 0);
    EXPECT_EQ(text_of(folder.path() / "a.png"), text_of(folder.path() / "b.png"));
}

// The dynamic loader logs every library that it opens.
TEST(Still, DoesNotLoadFFmpeg) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const std::string loader = "LD_DEBUG=files";
    const ProgramRun still = run_program_in(folder, "still scene.toml -o a.png", loader);
    ASSERT_EQ(still.code, 0);
    EXPECT_NE(still.err.find("libpng"), std::string::npos);
    EXPECT_EQ(still.err.find("libav"), std::string::npos);
    EXPECT_EQ(still.err.find("libsw"), std::string::npos);
    const ProgramRun film =
        run_program_in(folder, "render scene.toml --set film.duration_s=0.1 -o a.mp4", loader);
    ASSERT_EQ(film.code, 0);
    EXPECT_NE(film.err.find("libavcodec"), std::string::npos);
}

// The default title of a scene is its file's name, whatever characters that has.
TEST(Still, AcceptsAnySceneName) {
    const ScratchFolder folder;
    std::string untitled = racket;
    untitled.erase(untitled.find("title"), std::string("title = \"Racket\"\n").size());
    for (const std::string name :
         {"a$b", "{x", "a\\b", "a_b^c", "--5--", "~`'%&#", "Волчок", "陀螺", "a\xff", "\u202ea"}) {
        folder.write(name + ".toml", untitled);
        std::string quoted;
        for (const char c : name) quoted += c == '\'' ? "'\\''" : std::string(1, c);
        const std::string file = "'./" + quoted + ".toml'";
        const ProgramRun still = run_program_in(folder, "still " + file + " -o a.png");
        EXPECT_EQ(still.code, 0) << name << ": " << still.err;
        EXPECT_EQ(run_program_in(folder, "check -q " + file).code, 0) << name;
        const ProgramRun again = run_program_in(folder, "rerender -q a.png -o b.png");
        EXPECT_EQ(again.code, 0) << name << ": " << again.err;
        // Replaced letters are in the record, and missing ones were reported.
        const bool plain = name.find_first_not_of("a$bc{x\\_^-5~`'%&#") == std::string::npos;
        const std::string record = run_program_in(folder, "explain a.png").out;
        const bool recorded = record.find("\nfonts: ") != std::string::npos;
        const bool said = still.err.find("drawn as boxes") != std::string::npos;
        EXPECT_EQ(recorded || said, !plain) << name << still.err << record.substr(0, 600);
    }
    // A title in the scene is markup as usual.
    folder.write("own.toml", "title = \"a$b\"\n" + untitled);
    EXPECT_EQ(run_program_in(folder, "still own.toml -o c.png").code, 2);
}

// Some of these make Mesa crash or draw something else.
TEST(Environment, OfTheRendererChangesNoPicture) {
    const ScratchFolder folder;
    const std::string scene = "'" + (source_folder() / "scenes/generic.toml").string() + "'";
    const auto drawn = [&](const std::string& environment, const std::string& options) {
        const ProgramRun run = run_program_in(
            folder, "still " + scene + " --size 160x90 -q -o a.png" + options, environment);
        EXPECT_EQ(run.code, 0) << environment << options << ": " << run.err;
        return text_of(folder.path() / "a.png");
    };
    for (const std::string options : {"", " --portable"}) {
        const std::string reference = drawn("", options);
        for (const char* environment :
             {"LP_NATIVE_VECTOR_WIDTH=64", "LP_NATIVE_VECTOR_WIDTH=512", "LP_NATIVE_VECTOR_WIDTH=0",
              "LP_PERF=no_blend", "ST_DEBUG=wf", "DRAW_USE_LLVM=0", "GALLIUM_NOOP=1",
              "MESA_EXTENSION_OVERRIDE=-GL_ARB_texture_float", "MESA_GLSL_VERSION_OVERRIDE=110",
              "MESA_GL_VERSION_OVERRIDE=2.1", "LP_NUM_THREADS=many", "EGL_PLATFORM=x11",
              "LIBGL_ALWAYS_INDIRECT=1", "MESA_LOADER_DRIVER_OVERRIDE=none",
              "GALLIUM_DRIVER=llvmpipe", "GALLIUM_DRIVER="})
            EXPECT_TRUE(drawn(environment, options) == reference) << environment << options;
    }
}

TEST(Environment, WithAnotherDriverIsRefusedInASentence) {
    const ScratchFolder folder;
    const std::string scene = "'" + (source_folder() / "scenes/generic.toml").string() + "'";
    for (const std::string driver : {"bogus", "zink", "swr", "d3d12", "virpipe", "a b"})
        for (const std::string backend : {"auto", "egl"}) {
            const ProgramRun run = run_program_in(
                folder, "still " + scene + " --size 160x90 -q -o a.png --backend " + backend,
                "GALLIUM_DRIVER='" + driver + "'");
            EXPECT_EQ(run.code, 3) << driver << ": " << run.err;
            EXPECT_EQ(run.err.rfind("GALLIUM_DRIVER=" + driver + ": ", 0), 0u) << run.err;
            EXPECT_NE(run.err.find("unset GALLIUM_DRIVER"), std::string::npos) << run.err;
            EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        }
    EXPECT_EQ(folder.listing(), "");
    EXPECT_EQ(run_program_in(folder, "doctor", "GALLIUM_DRIVER=bogus").code, 1);
}

TEST_F(StillMessages, AStillIsWrittenToStandardOutput) {
    ASSERT_EQ(run("still scene.toml -o a.png").code, 0);
    const ProgramRun printed = run("still scene.toml -o -");
    ASSERT_EQ(printed.code, 0) << printed.err;
    EXPECT_EQ(printed.out, text_of(folder_.path() / "a.png"));
    ASSERT_EQ(run("still scene.toml --depth 16 -o b.png").code, 0);
    EXPECT_EQ(run("still scene.toml --depth 16 -o -").out, text_of(folder_.path() / "b.png"));
    refuses("still scene.toml scene.toml -o -", 2, {"2 scenes need as many output names"});
    const std::string full = "cd '" + folder_.path().string() + "' && '" + program_path() +
                             "' still scene.toml -q -o - >/dev/full 2>/dev/null";
    EXPECT_EQ(WEXITSTATUS(std::system(full.c_str())), 3);
}

// A camera key that no panel uses is reported.
TEST_F(StillMessages, ACameraKeyWithoutEffectIsNoted) {
    folder_.write("body.toml", scene + "[[panels]]\nkind = \"body\"\n");
    const ProgramRun idle = run("still body.toml --set camera.azimuth_deg=30 -o a.png");
    EXPECT_EQ(idle.code, 0);
    EXPECT_NE(idle.err.find("camera.azimuth_deg changes nothing"), std::string::npos) << idle.err;
    EXPECT_EQ(run("still body.toml -o b.png").err.find("changes nothing"), std::string::npos);
    EXPECT_EQ(run("still scene.toml --set camera.azimuth_deg=30 -o c.png").err.find("changes"),
              std::string::npos);
}

// After a billion seconds, the herpolhode is a ring within the bound, and a note says so; a chart
// is refused.
TEST_F(StillMessages, FarTimesAreRingsOrRefused) {
    for (const char* output : {"a.png", "a.svg", "a.pdf"}) {
        const ProgramRun still = run(std::string("still scene.toml --time 1e9 -o ") + output);
        EXPECT_EQ(still.code, 0) << still.err;
        EXPECT_NE(still.err.find("note: the herpolhode has so many turns"), std::string::npos);
        const ProgramRun told = run(std::string("explain ") + output);
        EXPECT_NE(told.out.find("0.1 px asked); the herpolhode has so many turns"),
                  std::string::npos)
            << told.out;
        EXPECT_NE(told.out.find("within 0.05 px"), std::string::npos) << told.out;
    }
    const ProgramRun film =
        run("render scene.toml --set film.duration_s=0.1 "
            "--set film.speed=1e10 --set film.fps=30 -q -o a.mp4");
    EXPECT_EQ(film.code, 0) << film.err;
    folder_.write("chart.toml", scene + "[[panels]]\nkind = \"plot\"\n");
    refuses("still chart.toml --time 1e9 -o b.png", 2,
            {"chart.toml:6:2: ", "cannot be drawn within accuracy_px = 0.1",
             "set film.start_s nearer to the last instant shown"});
    EXPECT_EQ(run("still chart.toml --time 1e9 --set film.start_s=999999990 -o b.png").code, 0);
}

TEST(PrintedStill, HasItsDensityAndLineWidthsOnPaper) {
    const ScratchFolder folder;
    for (const int dpi : {150, 300}) {
        const ProgramRun run =
            run_program_in(folder, "still '" + scene_path("generic") +
                                       "' --time 0.3 --theme transparent --width-mm 85 --dpi " +
                                       std::to_string(dpi) +
                                       " --set 'show=[\"momentum\"]' --set 'title=\"\"' -o l.png");
        ASSERT_EQ(run.code, 0) << run.err;
        PngInfo info;
        const Image image = read_png(folder.path() / "l.png", &info);
        EXPECT_EQ(image.width(), std::lround(85.0 / 25.4 * dpi));
        EXPECT_EQ(info.pixels_per_metre, std::lround(dpi / 0.0254));

        // L's shaft is 1.15 pt wide: the smallest coverage of the rows that it crosses, above its
        // head and its name.
        std::vector<double> widths;
        for (int y = 0; y < image.height(); ++y) {
            double width = 0.0;
            for (int x = 0; x < image.width(); ++x) width += image.at(x, y).a / 255.0;
            if (width > 0.0) widths.push_back(width);
        }
        ASSERT_GT(widths.size(), 40u);
        const auto row = [&widths](double share) {
            return widths.begin() + std::lround(share * static_cast<double>(widths.size()));
        };
        const double least = *std::min_element(row(0.1), row(0.5));
        // In perspective a cylinder has its nominal width at the camera's target, to a tenth.
        EXPECT_NEAR(least * 72.0 / dpi, 1.15, 0.12) << dpi;
    }
}

// Compares a still rendered with 8 bits with one of 16 bits rounded to 8: they differ by at most a
// level; where a letter or an outline lies on other translucent things, each of which is rounded to
// 8 bits, by two in a few pixels and by more in hardly one of a million.
void expect_same_to_a_level(const ScratchFolder& folder, const std::string& common) {
    ASSERT_EQ(run_program_in(folder, common + "-o shallow.png").code, 0);
    const ProgramRun run = run_program_in(folder, common + "--depth 16 -o deep.png");
    ASSERT_EQ(run.code, 0) << run.err;
    const Image shallow = read_png(folder.path() / "shallow.png");
    const Image deep = read_png(folder.path() / "deep.png");
    ASSERT_EQ(deep.width(), shallow.width());
    std::array<int, 256> n_off{};
    for (int y = 0; y < deep.height(); ++y)
        for (int x = 0; x < deep.width(); ++x)
            ++n_off[static_cast<std::size_t>(std::abs(deep.at(x, y).g - shallow.at(x, y).g))];
    const double n_pixels = 1.0 * deep.width() * deep.height();
    const auto n_from = [&](int level) {
        return std::accumulate(n_off.begin() + level, n_off.end(), 0);
    };
    EXPECT_LE(n_from(2), 1e-5 * n_pixels);  // measured 4e-7
    EXPECT_LE(n_from(3), 1e-6 * n_pixels);  // measured 5 of 11 million, one by 16
    EXPECT_EQ(n_from(32), 0);
}

TEST(PrintedStill, InBandsEqualsThePictureDrawnAtOnce) {
    // Pictures of 16 bits are rendered in bands, here two of them; rounded to 8 bits it equals the
    // other picture within the dither of less than a level (measured 0.91).
    const ScratchFolder folder;
    const std::string common =
        "still '" + scene_path("generic") + "' --time 3 --width-mm 60 --dpi 1200 --theme print ";
    expect_same_to_a_level(folder, common);
    // The bit depth in IHDR.
    EXPECT_EQ(text_of(folder.path() / "deep.png").at(24), 16);
}

TEST(PrintedStill, OfSixteenBitsIsAveragedLikeOneOfEight) {
    const ScratchFolder folder;
    const std::string common =
        "still '" + scene_path("generic") +
        "' --time 3 --width-mm 30 --dpi 300 --theme print --quality print -q ";
    expect_same_to_a_level(folder, common);
}

TEST(PrintedStill, FigureKeepsItsShapeWithLargeText) {
    // Title and caption take a larger part of a narrow page than of a screen: the page grows by the
    // difference.
    const ScratchFolder folder;
    const auto rows = [&](const std::string& more) {
        const ProgramRun run =
            run_program_in(folder, "still '" + scene_path("sphere") +
                                       "' --time 1 --width-mm 85 --dpi 150 -q -o a.png " + more);
        EXPECT_EQ(run.code, 0) << run.err;
        return read_png(folder.path() / "a.png").height();
    };
    const int bare = rows("--set 'title=\"\"' --set 'caption=\"\"'");
    EXPECT_NEAR(bare, 85.0 / 25.4 * 150.0 * 9.0 / 16.0, 30.0);  // the row of the clock remains
    // A title of 10 pt, and at 85 mm two lines of caption instead of one.
    const double pt_px = 150.0 / 72.0;
    const std::string two_lines =
        "--set 'caption=\"Three equal moments: every rotation about any of its axes is steady for "
        "ever.\"'";
    EXPECT_GT(rows(two_lines), bare + 10.0 * pt_px);
    EXPECT_LT(rows(two_lines), bare + 60.0 * pt_px);
    EXPECT_NEAR(rows("--height-mm 50"), 50.0 / 25.4 * 150.0, 1.0);
}

// The numbers that are separate texts in a figure: those of axes.
int numbers_in(const std::string& svg) {
    static const std::regex number(">-?[0-9]+(\\.[0-9]+)?</text>");
    return static_cast<int>(
        std::distance(std::sregex_iterator(svg.begin(), svg.end(), number), {}));
}

TEST(PrintedStill, ChartsInAColumnHaveNumbersAndNames) {
    // Every vertical axis has at least two numbers, every time or angle axis three: four charts and
    // two such axes in this top, two of each with Explorer 1, one in the others.
    const ScratchFolder folder;
    for (const auto& [name, n_heights, n_feet] :
         {std::tuple("heavy_top_cusp", 4, 2), std::tuple("heavy_top_conserved", 1, 1),
          std::tuple("four_views", 1, 1), std::tuple("explorer_1", 2, 2),
          std::tuple("momentum_sphere", 1, 1)}) {
        const ProgramRun run = run_program_in(
            folder, "still '" + scene_path(name) + "' --width-mm 85 --theme print -q -o a.svg");
        ASSERT_EQ(run.code, 0) << run.err;
        EXPECT_GE(numbers_in(text_of(folder.path() / "a.svg")), 2 * n_heights + 3 * n_feet) << name;
    }
    ASSERT_EQ(run_program_in(folder, "still '" + scene_path("heavy_top_cusp") +
                                         "' --width-mm 85 --theme print -q -o a.svg")
                  .code,
              0);
    EXPECT_NE(text_of(folder.path() / "a.svg").find(">\U0001d449</text>"), std::string::npos)
        << "no name of V";
    // A page with a given height keeps it.
    ASSERT_EQ(run_program_in(folder, "still '" + scene_path("four_views") +
                                         "' --width-mm 85 --height-mm 50 --dpi 150 -q -o a.png")
                  .code,
              0);
    EXPECT_EQ(read_png(folder.path() / "a.png").height(), std::lround(50.0 / 25.4 * 150.0));
}

TEST(PrintedStill, IsRerenderedFromItsRecord) {
    const ScratchFolder folder;
    const ProgramRun run = run_program_in(
        folder, "still '" + scene_path("generic") +
                    "' --time 1 --width-mm 60 --dpi 300 --type-pt 9 --theme dark -o a.png -q");
    ASSERT_EQ(run.code, 0) << run.err;
    const ProgramRun again = run_program_in(folder, "rerender a.png -o b.png");
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(text_of(folder.path() / "a.png"), text_of(folder.path() / "b.png"));
}

TEST(PrintedStill, ErrorsAreOneLineAndLeaveNoFile) {
    const ScratchFolder folder;
    const std::string still = "still '" + scene_path("generic") + "' -o a.png ";
    for (const char* wrong : {"--width-mm 85 --size 100x100", "--depth 12",
                              "--width-mm 90000 --dpi 1200", "--theme drak"}) {
        const ProgramRun run = run_program_in(folder, still + wrong);
        EXPECT_EQ(run.code, 2) << wrong << ": " << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        EXPECT_EQ(folder.listing(), "") << wrong;
    }
    // The nearest name, or all of them.
    EXPECT_EQ(run_program_in(folder, still + "--theme drak").err,
              "--theme drak: unknown theme \"drak\"; did you mean \"dark\"?\n");
    std::string names;
    std::istringstream listed(run_program_in(folder, "list themes").out);
    for (std::string line; std::getline(listed, line);)
        names += line.substr(0, line.find(' ')) + ", ";
    EXPECT_TRUE(names.starts_with("light, dark, print, ")) << names;
    EXPECT_EQ(run_program_in(folder, still + "--theme xyzzy").err,
              "--theme xyzzy: unknown theme \"xyzzy\"; choose from: " + names +
                  "or the path of a theme file, as in my.toml\n");
}

TEST(StillChapters, AreTheFramesAtWhichTheFilmStops) {
    const ScratchFolder folder;
    folder.write("a.toml", racket +
                               "[[stops]]\nat_s = 0.3\n[[stops]]\nat_s = 0.7\n[[captions]]\nat_s = "
                               "0.5\ntext = \"Later\"\n");
    ASSERT_EQ(run_program_in(folder, "still a.toml --chapters -o 's_##.png'").code, 0);
    ASSERT_EQ(run_program_in(folder, "render a.toml -o 'f_##.png'").code, 0);
    const auto pixels = [&](const std::string& name) {
        const Image image = read_png(folder.path() / name);
        return std::vector<std::uint8_t>(image.bytes().begin(), image.bytes().end());
    };
    EXPECT_EQ(pixels("s_01.png"), pixels("f_09.png"));
    EXPECT_EQ(pixels("s_02.png"), pixels("f_21.png"));
    EXPECT_NE(pixels("s_01.png"), pixels("s_02.png"));
    EXPECT_EQ(text_of(folder.path() / "s_03.png"), "");
    ASSERT_EQ(run_program_in(folder, "rerender s_02.png -o again.png").code, 0);
    EXPECT_EQ(text_of(folder.path() / "again.png"), text_of(folder.path() / "s_02.png"));
    const ProgramRun explained = run_program_in(folder, "explain s_02.png");
    EXPECT_NE(explained.out.find("\nframe: 21\nfilm-frames: 30\n"), std::string::npos);
    EXPECT_EQ(explained.err.find("another number"), std::string::npos) << explained.err;
    EXPECT_EQ(run_program_in(folder, "compare s_02.png f_21.png --ignore clock").code, 0);
}

// A halt shows one instant in many frames, with other captions.
TEST(StillChapters, DistinguishTheFramesOfAHalt) {
    const ScratchFolder folder;
    folder.write("a.toml",
                 "title = \"Halt\"\n[body]\nmoments_kg_m2 = [3.0, 2.0, 1.0]\n[start]\nomega_rad_s "
                 "= [0.01, 2.0, 0.01]\n[film]\nsize = [320, 180]\nlength_s = 1.0\n"
                 "[[keyframes]]\nat_s = 0.0\nspeed = 0.0\n"
                 "[[stops]]\nat_s = 0.3\n[[stops]]\nat_s = 0.7\n[[captions]]\nat_s = 0.5\n"
                 "text = \"Later\"\n");
    const ProgramRun run = run_program_in(folder, "still a.toml --chapters -o 's_#.png'");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(text_of(folder.path() / "s_1.png"), text_of(folder.path() / "s_2.png"));
    ASSERT_EQ(run_program_in(folder, "rerender s_2.png -o again.png").code, 0);
    EXPECT_EQ(text_of(folder.path() / "again.png"), text_of(folder.path() / "s_2.png"));
}

// For each kind of file and option, the same pictures in the same frame, numbered from 1.
TEST(StillChapters, TakeTheOptionsOfStills) {
    const ScratchFolder folder;
    folder.write("a.toml", racket +
                               "[[chapters]]\nat_s = 0.0\ntitle = \"A\"\n[[chapters]]\nat_s = "
                               "0.5\ntitle = \"B\"\n");
    for (const std::string name : {"f_#.pdf --width-mm 86", "f_#.svg --shading none",
                                   "f_#.png --depth 16", "g_#.png --width-mm 40 --theme print"}) {
        const ProgramRun run = run_program_in(folder, "still a.toml --chapters -o " + name);
        ASSERT_EQ(run.code, 0) << name << run.err;
        const std::string suffix = name.substr(3, 4);
        for (const std::string number : {"1", "2"}) {
            const std::string file = name.substr(0, 2) + number + suffix;
            EXPECT_NE(text_of(folder.path() / file), "") << file;
            ASSERT_EQ(run_program_in(folder, "rerender " + file + " -o again" + suffix).code, 0);
            EXPECT_EQ(text_of(folder.path() / ("again" + suffix)), text_of(folder.path() / file))
                << file;
        }
        EXPECT_EQ(text_of(folder.path() / (name.substr(0, 2) + "3" + suffix)), "");
    }
    ASSERT_EQ(run_program_in(folder, "still a.toml --chapters").code, 0);
    EXPECT_NE(text_of(folder.path() / "output/a_0002.png"), "");
}

TEST_F(StillMessages, ChaptersAreRefusedWithoutStopsANumberAndWithOneInstant) {
    refuses("still scene.toml --chapters -o a_#.png", 2,
            {"scene.toml:1:1", "no [[stops]] and no [[chapters]] for --chapters"});
    refuses("still scene.toml --chapters -o a.png", 2, {"a.png", "put #### into the name"});
    refuses("still scene.toml --chapters -o -", 2, {"put #### into the name"});
    refuses("still scene.toml --chapters --time 0 -o a_#.png", 2, {"--chapters", "--time"});
    refuses("still scene.toml --chapters --time auto -o a_#.png", 2, {"--chapters", "--time"});
    refuses("still scene.toml --chapters --sheet 1x1 -o a.png", 2, {"--chapters", "--sheet"});
}

}  // namespace
}  // namespace poinsot::testing
