// Names of numbered pictures.
#include "encoding/frame_name.h"

#include <gtest/gtest.h>

#include "encoding/films.h"
#include "encoding/frame_sink.h"

namespace poinsot {
namespace {

TEST(FrameName, NumbersHaveAtLeastTheGivenDigits) {
    EXPECT_EQ(frame_name("out/f_####.png", 7), "out/f_0007.png");
    EXPECT_EQ(frame_name("f##_#.png", 123), "f123_#.png");
    EXPECT_EQ(frame_name("#.png", 0), "0.png");
    EXPECT_TRUE(has_frame_number("a/#.png"));
    EXPECT_FALSE(has_frame_number("#/a.png"));
}

TEST(FrameNames, AreFoundInAFolder) {
    const TemporaryFolder folder;
    for (const char* name : {"f_03.png", "f_12.png", "f_111.png", "f_7.png", "f_003.png",
                             "f_05.txt", "g_04.png", "f_.png", "f_0x.png", "f_-1.png"})
        std::ofstream(folder / name) << "x";
    EXPECT_EQ(frames_there(folder / "f_##.png"), (std::vector<std::int64_t>{3, 12, 111}));
    EXPECT_TRUE(frames_there(folder / "none/f_##.png").empty());
}

}  // namespace
}  // namespace poinsot
