// Conversion of sizes on paper to pixels.
#include "production/session/print_size.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "error/error.h"
#include "refusal.h"

namespace poinsot {
namespace {

PrintChoices on_paper(double width_mm, double dpi) {
    PrintChoices print;
    print.width_mm = width_mm;
    print.dpi = dpi;
    return print;
}

TEST(PrintSize, FollowsFromMillimetresAndDpi) {
    // 85 / 25.4 · 600 = 2007.87; 16:9; 600 / 0.0254 m = 23622.05.
    const auto size = print_size_of(on_paper(85.0, 600.0), 1920, 1080);
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width_px, 2008);
    EXPECT_EQ(size->height_px, 1129);
    EXPECT_NEAR(size->pixels_per_metre, 23622.05, 0.01);

    // A0 in portrait format: 841 mm × 1189 mm.
    PrintChoices poster = on_paper(841.0, 300.0);
    poster.height_mm = 1189.0;
    const auto a0 = print_size_of(poster, 1920, 1080);
    EXPECT_EQ(a0->width_px, 9933);
    EXPECT_EQ(a0->height_px, 14043);

    EXPECT_FALSE(print_size_of({}, 1920, 1080));
}

TEST(PrintSize, LinesHaveTheirPointsAtAnyDpi) {
    for (const double dpi : {72.0, 300.0, 600.0, 1200.0}) {
        const auto size = print_size_of(on_paper(85.0, dpi), 1920, 1080);
        // A polhode of 4 pixels at 1080 rows is 1 point wide, a label of 34 pixels is 8.5 points.
        EXPECT_NEAR(4.0 * size->line_scale / dpi * 72.0, 1.0, 1e-12);
        EXPECT_NEAR(34.0 * size->line_scale / dpi * 72.0, 8.5, 1e-12);
    }
    PrintChoices large = on_paper(841.0, 300.0);
    large.type_pt = 34.0;
    EXPECT_NEAR(print_size_of(large, 1920, 1080)->line_scale / 300.0 * 72.0, 1.0, 1e-12);
}

std::string refusal(const PrintChoices& print, int width_px = 1920, int height_px = 1080) {
    return refusal_message([&] { print_size_of(print, width_px, height_px); });
}

TEST(PrintSize, RejectsImpossibleSizesWithTheOptionsName) {
    EXPECT_EQ(refusal(on_paper(9000.0, 600.0)),
              "--width-mm 9000 at 600 dpi makes a side of 212598 pixels; a picture has 16 to 65536 "
              "per side: change --width-mm or --dpi");
    EXPECT_NE(refusal(on_paper(1.0, 72.0)).find("--width-mm 1 at 72 dpi makes a side of 3 pixels"),
              std::string::npos);
    EXPECT_NE(refusal(on_paper(-85.0, 600.0)).find("--width-mm -85: give"), std::string::npos);
    EXPECT_NE(refusal(on_paper(std::nan(""), 600.0)).find("--width-mm"), std::string::npos);
    EXPECT_NE(refusal(on_paper(85.0, 0.0)).find("--dpi 0: give"), std::string::npos);
    PrintChoices high;
    high.height_mm = 6000.0;
    EXPECT_NE(refusal(high).find("--height-mm 6000 at 300 dpi"), std::string::npos);
}

}  // namespace
}  // namespace poinsot
