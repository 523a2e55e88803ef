// Single pictures and sequences of them.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <bit>

#include "encoding/films.h"
#include "encoding/frame_name.h"
#include "encoding/frame_sink.h"

namespace poinsot {
namespace {

TEST(PngStill, RefusesASecondFrame) {
    const TemporaryFolder folder;
    const OutputPlan plan = small_plan(folder / "a.png");
    const auto sink = format_for(plan.path).open(plan);
    sink->write(frame_of(plan, 0));
    EXPECT_NE(refusal_message([&] { sink->write(frame_of(plan, 1)); }).find("holds one picture"),
              std::string::npos);
}

TEST(PngSequence, CarriesPixelsNumbersAndText) {
    const TemporaryFolder folder;
    OutputPlan plan = small_plan(folder / "f_##.png", 12);
    plan.first_frame = 95;
    write_film(plan);
    ASSERT_EQ(folder.contents().size(), 12u);
    for (std::int64_t k = 0; k < 12; ++k) {
        PngInfo info;
        EXPECT_TRUE(read_png(frame_name(plan.path, 95 + k), &info) == frame_of(plan, k));
        EXPECT_EQ(info.texts["poinsot"], plan.metadata);
    }
}

TEST(PngSequence, ContinuesAfterCompleteFramesOfTheSamePlan) {
    const TemporaryFolder folder;
    OutputPlan plan = small_plan(folder / "f_#.png", 6);
    write_film(plan);
    const auto n_kept = [&] { return format_for(plan.path).open(plan)->n_frames_kept(); };
    EXPECT_EQ(n_kept(), 0);
    plan.resume = true;
    EXPECT_EQ(n_kept(), 6);
    std::filesystem::resize_file(folder / "f_3.png", 200);
    EXPECT_EQ(n_kept(), 3);
    plan.metadata = "another scene";
    EXPECT_EQ(n_kept(), 0);
    plan = small_plan(folder / "f_#.png", 6);
    plan.resume = true;
    write_film(plan);
    EXPECT_TRUE(read_png(folder / "f_3.png") == frame_of(plan, 3));
}

// A frame's text contains its number and the hash of its pixels.
TEST(PngSequence, RendersFramesAgainThatDoNotMatchTheirText) {
    const TemporaryFolder folder;
    OutputPlan plan = small_plan(folder / "f_#.png", 6);
    plan.resume = true;
    plan.seal = [](const std::string& metadata, const EncodedMetadata& contents) {
        return fmt::format("{} {} {}", metadata, contents.frame.value(), contents.pixels);
    };
    write_film(plan);
    const auto n_kept = [&] { return format_for(plan.path).open(plan)->n_frames_kept(); };
    EXPECT_EQ(n_kept(), 6);

    const StoredPicture frame = read_stored_png(folder / "f_4.png");
    PngOptions options;
    options.texts = frame.info.texts;
    write_png(folder / "f_4.png", Image(plan.width_px, plan.height_px), options);
    EXPECT_EQ(n_kept(), 4);
    std::filesystem::copy_file(folder / "f_1.png", folder / "f_2.png",
                               std::filesystem::copy_options::overwrite_existing);
    EXPECT_EQ(n_kept(), 2);
    // The frames between and after are correct and are kept.
    const auto inode_of = [&](std::int64_t k) {
        struct stat status {};
        EXPECT_EQ(stat(frame_name(plan.path, k).c_str(), &status), 0);
        return status.st_ino;
    };
    std::vector<ino_t> before;
    before.reserve(6);
    for (int k = 0; k < 6; ++k) before.push_back(inode_of(k));
    write_film(plan);
    EXPECT_EQ(n_kept(), 6);
    for (int k = 0; k < 6; ++k)
        EXPECT_EQ(inode_of(k) != before[static_cast<std::size_t>(k)], k == 2 || k == 4) << k;
    for (int k = 0; k < 6; ++k)
        EXPECT_TRUE(read_png(frame_name(plan.path, k)) == frame_of(plan, k)) << k;
}

// Any frame of a run may be missing or changed: these are rendered again, wherever they are.
TEST(PngSequence, RendersOnlyMissingFrames) {
    const TemporaryFolder folder;
    for (unsigned missing = 1; missing < 128; missing += 5) {
        OutputPlan plan = small_plan(folder / "f_#.png", 7);
        plan.first_frame = 3;
        plan.resume = true;
        write_film(plan);
        for (int k = 0; k < 7; ++k)
            if (missing >> k & 1U) std::filesystem::remove(frame_name(plan.path, 3 + k));
        int n_written = 0;
        const auto sink = format_for(plan.path).open(plan);
        for (int k = 0; k < 7; ++k) {
            EXPECT_EQ(sink->has_frame(k), (missing >> k & 1U) == 0U) << missing << " " << k;
            if (sink->has_frame(k)) continue;
            sink->write(frame_of(plan, k));
            ++n_written;
        }
        sink->finish();
        EXPECT_EQ(n_written, std::popcount(missing));
        for (int k = 0; k < 7; ++k)
            EXPECT_TRUE(read_png(frame_name(plan.path, 3 + k)) == frame_of(plan, k)) << k;
    }
}

TEST(PngSequence, SecondRunIsRefused) {
    const TemporaryFolder folder;
    const OutputPlan plan = small_plan(folder / "f_#.png");
    const auto first = format_for(plan.path).open(plan);
    EXPECT_NE(refusal_message<EnvironmentError>([&] {
                  format_for(plan.path).open(plan);
              }).find("another run"),
              std::string::npos);
}

}  // namespace
}  // namespace poinsot
