// Films are read from any frame.
#include <gtest/gtest.h>

#include "encoding/films.h"

namespace poinsot {
namespace {

TEST(VideoReader, FindsAnyFrame) {
    const TemporaryFolder folder;
    for (const char* name : {"a.mp4", "a.webm", "a.mov", "a.gif"}) {
        const OutputPlan plan = small_plan(folder / name, 130);
        write_film(plan);
        const std::vector<Image> frames = frames_of(plan.path);
        VideoReader reader(plan.path);
        for (const std::int64_t k : {129, 0, 64, 121, 119, 120, 3})
            EXPECT_TRUE(reader.frame(k) == frames[static_cast<std::size_t>(k)]) << name << " " << k;
        Image next;
        ASSERT_TRUE(reader.read(next));
        EXPECT_TRUE(next == frames[4]);
        EXPECT_NE(refusal_message([&] { reader.frame(130); }).find("has no frame 130; it has 130"),
                  std::string::npos);
        EXPECT_NE(refusal_message([&] { reader.frame(-1); }), "");
    }
}

TEST(VideoReader, RefusesOtherFiles) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.mp4") << "not a film";
    std::ofstream(folder / "empty.mp4") << "";
    for (const char* name : {"a.mp4", "empty.mp4", "missing.mp4", "."})
        EXPECT_NE(refusal_message([&] { VideoReader(folder / name); }).find("cannot be read"),
                  std::string::npos)
            << name;
}

}  // namespace
}  // namespace poinsot
