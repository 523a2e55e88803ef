// Stills for paper: their size, density, line widths, depth and bands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "cli/program_run.h"
#include "image/files/png_files.h"
#include "places.h"

namespace poinsot::testing::print_tests {
namespace {

std::string scene(const std::string& name) {
    return (source_folder() / "scenes" / (name + ".toml")).string();
}

TEST(PrintedStill, HasItsDensityAndLineWidthsOnPaper) {
    const ScratchFolder folder;
    for (const int dpi : {150, 300}) {
        const ProgramRun run = run_program_in(
            folder,
            "still '" + scene("generic") + "' --time 0.3 --theme transparent --width-mm 85 --dpi " +
                std::to_string(dpi) + " --set 'show=[\"momentum\"]' --set 'title=\"\"' -o l.png");
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
// level.
void expect_same_to_a_level(const ScratchFolder& folder, const std::string& common) {
    ASSERT_EQ(run_program_in(folder, common + "-o shallow.png").code, 0);
    const ProgramRun run = run_program_in(folder, common + "--depth 16 -o deep.png");
    ASSERT_EQ(run.code, 0) << run.err;
    const Image shallow = read_png(folder.path() / "shallow.png");
    const Image deep = read_png(folder.path() / "deep.png");
    ASSERT_EQ(deep.width(), shallow.width());
    int largest = 0;
    for (int y = 0; y < deep.height(); ++y)
        for (int x = 0; x < deep.width(); ++x)
            largest = std::max(largest, std::abs(deep.at(x, y).g - shallow.at(x, y).g));
    EXPECT_LE(largest, 1);
}

TEST(PrintedStill, InBandsEqualsThePictureDrawnAtOnce) {
    // Pictures of 16 bits are rendered in bands, here two of them; rounded to 8 bits it equals the
    // other picture within the dither of less than a level (measured 0.91).
    const ScratchFolder folder;
    const std::string common =
        "still '" + scene("generic") + "' --time 3 --width-mm 60 --dpi 1200 --theme print ";
    expect_same_to_a_level(folder, common);
    // The bit depth in IHDR.
    EXPECT_EQ(text_of(folder.path() / "deep.png").at(24), 16);
}

TEST(PrintedStill, OfSixteenBitsIsAveragedLikeOneOfEight) {
    const ScratchFolder folder;
    const std::string common =
        "still '" + scene("generic") +
        "' --time 3 --width-mm 30 --dpi 300 --theme print --quality print -q ";
    expect_same_to_a_level(folder, common);
}

TEST(PrintedStill, FigureKeepsItsShapeWithLargeText) {
    // Title and caption take a larger part of a narrow page than of a screen: the page grows by the
    // difference.
    const ScratchFolder folder;
    const auto rows = [&](const std::string& more) {
        const ProgramRun run =
            run_program_in(folder, "still '" + scene("loop_generic") +
                                       "' --time 1 --width-mm 85 --dpi 150 -q -o a.png " + more);
        EXPECT_EQ(run.code, 0) << run.err;
        return read_png(folder.path() / "a.png").height();
    };
    const int bare = rows("--set 'title=\"\"' --set 'caption=\"\"'");
    EXPECT_NEAR(bare, 85.0 / 25.4 * 150.0 * 9.0 / 16.0, 30.0);  // the row of the clock remains
    // A title of 10 pt, and at 85 mm two lines of caption instead of one.
    const double pt_px = 150.0 / 72.0;
    EXPECT_GT(rows(""), bare + 10.0 * pt_px);
    EXPECT_LT(rows(""), bare + 60.0 * pt_px);
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
    // two such axes in the tops, two of each with Explorer 1, one in the others.
    const ScratchFolder folder;
    for (const auto& [name, n_heights, n_feet] :
         {std::tuple("heavy_top_cusp", 4, 2), std::tuple("heavy_top_conserved", 4, 2),
          std::tuple("four_views", 1, 1), std::tuple("explorer_1", 2, 2),
          std::tuple("momentum_sphere", 1, 1)}) {
        const ProgramRun run = run_program_in(
            folder, "still '" + scene(name) + "' --width-mm 85 --theme print -q -o a.svg");
        ASSERT_EQ(run.code, 0) << run.err;
        EXPECT_GE(numbers_in(text_of(folder.path() / "a.svg")), 2 * n_heights + 3 * n_feet) << name;
    }
    ASSERT_EQ(run_program_in(folder, "still '" + scene("heavy_top_cusp") +
                                         "' --width-mm 85 --theme print -q -o a.svg")
                  .code,
              0);
    EXPECT_NE(text_of(folder.path() / "a.svg").find(">\U0001d449</text>"), std::string::npos)
        << "no name of V";
    // A page with a given height keeps it.
    ASSERT_EQ(run_program_in(folder, "still '" + scene("four_views") +
                                         "' --width-mm 85 --height-mm 50 --dpi 150 -q -o a.png")
                  .code,
              0);
    EXPECT_EQ(read_png(folder.path() / "a.png").height(), std::lround(50.0 / 25.4 * 150.0));
}

TEST(PrintedStill, IsRerenderedFromItsRecord) {
    const ScratchFolder folder;
    const ProgramRun run = run_program_in(
        folder, "still '" + scene("generic") +
                    "' --time 1 --width-mm 60 --dpi 300 --type-pt 9 --theme dark -o a.png -q");
    ASSERT_EQ(run.code, 0) << run.err;
    const ProgramRun again = run_program_in(folder, "rerender a.png -o b.png");
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(text_of(folder.path() / "a.png"), text_of(folder.path() / "b.png"));
}

TEST(PrintedStill, ErrorsAreOneLineAndLeaveNoFile) {
    const ScratchFolder folder;
    const std::string still = "still '" + scene("generic") + "' -o a.png ";
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

}  // namespace
}  // namespace poinsot::testing::print_tests
