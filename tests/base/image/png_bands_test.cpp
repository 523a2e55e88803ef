// Pictures written band by band equal those written whole.
#include "image/files/png_bands.h"

#include <gtest/gtest.h>

#include "error/error.h"
#include "image/files/png_files.h"
#include "image/synthetic.h"
#include "system/faults.h"

namespace poinsot {
namespace {

Image rows_of(const Image& image, int y, int n_rows) {
    Image band(image.width(), n_rows);
    for (int row = 0; row < n_rows; ++row)
        for (int x = 0; x < image.width(); ++x) band.set(x, row, image.at(x, y + row));
    return band;
}

TEST(PngBands, DecodeToTheWholePicture) {
    const TemporaryFolder folder;
    Image image = synthetic_frame(320, 180, 5);
    for (const bool opaque : {true, false}) {
        if (!opaque) image.bytes()[3] = 7;
        PngOptions options;
        options.texts["poinsot"] = "text";
        options.pixels_per_metre = 23622;
        PngBandWriter writer(folder / "a.png", 320, 180, opaque, options);
        int y = 0;
        for (const int n_rows : {1, 64, 100, 15}) {
            writer.write(rows_of(image, y, n_rows));
            y += n_rows;
        }
        EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
        writer.finish();
        PngInfo info;
        EXPECT_TRUE(read_png(folder / "a.png", &info) == image);
        EXPECT_EQ(info.texts, options.texts);
        EXPECT_EQ(info.pixels_per_metre, 23622);
        std::filesystem::remove(folder / "a.png");
    }
}

TEST(PngBands, OfWrongSizeAreRejected) {
    const TemporaryFolder folder;
    {
        PngBandWriter writer(folder / "a.png", 32, 18, true);
        EXPECT_THROW(writer.write(Image(31, 2)), InputError);
        EXPECT_THROW(writer.write(Image(32, 19)), InputError);
        writer.write(Image(32, 17));
        EXPECT_THROW(writer.finish(), InputError);
    }
    EXPECT_TRUE(folder.contents().empty());
    EXPECT_THROW(PngBandWriter(folder / "a.png", 0, 18, true), InputError);
    EXPECT_THROW(PngBandWriter(folder / "a.png", 32, largest_banded_png_side_px + 1, true),
                 InputError);
    EXPECT_TRUE(folder.contents().empty());
}

TEST(PngBands, FullDeviceIsReported) {
    EXPECT_THROW(PngBandWriter("/dev/full", 32, 18, true), EnvironmentError);
}

}  // namespace
}  // namespace poinsot
