// The table of formats: the format of a file name, and the plans that each format refuses.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <bit>

#include "output/films.h"
#include "output/frame_name.h"
#include "output/frame_sink.h"

namespace poinsot {
namespace {

TEST(Formats, FileNamesSelectTheirFormat) {
    EXPECT_EQ(format_for("a/b.mp4").name, "mp4");
    EXPECT_EQ(format_for("b.webm").name, "webm");
    EXPECT_EQ(format_for("b.gif").name, "gif");
    EXPECT_EQ(format_for("b.png").name, "png");
    EXPECT_EQ(format_for("b_####.png").name, "png-sequence");
    EXPECT_EQ(format_for("b.md5").name, "md5");
    EXPECT_EQ(format_for("null").name, "null");
    EXPECT_EQ(format_for("####/b.png").name, "png");
}

TEST(Formats, UnknownSuffixListsTheKnown) {
    EXPECT_EQ(input_error_of([] { format_for("b.mov"); }),
              "b.mov: there is no output format for the suffix \".mov\"; write .mp4, and convert "
              "it without loss: `ffmpeg -i film.mp4 -c copy film.mov`; the formats are .mp4, "
              ".webm, .gif, .png, .md5");
    EXPECT_NE(input_error_of([] { format_for("film"); }).find("a name without a suffix"),
              std::string::npos);
    EXPECT_NE(input_error_of([] { format_for("b_####.mp4"); }).find("####"), std::string::npos);
}

TEST(FrameName, NumbersHaveAtLeastTheGivenDigits) {
    EXPECT_EQ(frame_name("out/f_####.png", 7), "out/f_0007.png");
    EXPECT_EQ(frame_name("f##_#.png", 123), "f123_#.png");
    EXPECT_EQ(frame_name("#.png", 0), "0.png");
    EXPECT_TRUE(has_frame_number("a/#.png"));
    EXPECT_FALSE(has_frame_number("#/a.png"));
}

// Every row writes a complete output of two frames (a still: one) and leaves no other file.
TEST(Formats, EveryRowWritesItsOutput) {
    for (const OutputFormat& format : output_formats()) {
        const TemporaryFolder folder;
        const std::string stem = format.name == "png-sequence" ? "f_#" : "f";
        OutputPlan plan = small_plan(folder / (stem + std::string(format.suffix)));
        plan.n_frames = format.name == "png" ? 1 : 2;
        const auto sink = format.open(plan);
        for (std::int64_t k = 0; k < plan.n_frames; ++k) sink->write(frame_of(plan, k));
        sink->finish();
        const std::size_t n_files = format.name == "null"           ? 0
                                    : format.name == "png-sequence" ? 2
                                                                    : 1;
        EXPECT_EQ(folder.contents().size(), n_files) << format.name;
    }
}

TEST(Formats, UnfinishedSinksLeaveNoFile) {
    for (const OutputFormat& format : output_formats()) {
        const TemporaryFolder folder;
        const std::string stem = format.name == "png-sequence" ? "f_#" : "f";
        const OutputPlan plan = small_plan(folder / (stem + std::string(format.suffix)), 3);
        format.open(plan)->write(frame_of(plan, 0));
        for (const std::string& name : folder.contents()) {
            EXPECT_EQ(name, "f_0.png");
            EXPECT_TRUE(read_png(folder / name) == frame_of(plan, 0));
        }
    }
}

TEST(Formats, FilmsRefuseUnsupportedPlans) {
    const TemporaryFolder folder;
    for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
        OutputPlan plan = small_plan(folder / name);
        const auto open = [&] { format_for(plan.path).open(plan); };
        plan.rate = {0, 1};
        EXPECT_EQ(input_error_of(open), "a film needs a frame rate above 0; 0/1 is not one")
            << name;
        plan.rate = {30, 0};
        EXPECT_NE(input_error_of(open), "") << name;
        plan.rate = {std::int64_t{1} << 40, 1};
        EXPECT_NE(input_error_of(open), "") << name;
        plan = small_plan(folder / name);
        plan.height_px = 0;
        EXPECT_NE(input_error_of(open), "") << name;
        plan = small_plan(folder / name);
        EXPECT_NE(input_error_of([&] {
                      const auto sink = format_for(plan.path).open(plan);
                      sink->write(Image(10, 10));
                  }).find("a frame of 10×10 pixels"),
                  std::string::npos);
        EXPECT_NE(input_error_of([&] {
                      format_for(plan.path).open(plan)->finish();
                  }).find("was given no frame"),
                  std::string::npos);
    }
    EXPECT_TRUE(folder.contents().empty());
}

TEST(Formats, UnknownQualityListsTheKnown) {
    const TemporaryFolder folder;
    for (const char* name : {"a.mp4", "a.webm"}) {
        OutputPlan plan = small_plan(folder / name);
        plan.quality = "best";
        EXPECT_EQ(input_error_of([&] { format_for(plan.path).open(plan); }),
                  "unknown quality \"best\"; choose from: draft, lecture, print, reference");
    }
}

TEST(Formats, OddSizesAreRefusedForMp4WithASentence) {
    const TemporaryFolder folder;
    OutputPlan plan = small_plan(folder / "a.mp4");
    plan.width_px = 65;
    EXPECT_EQ(input_error_of([&] { format_for(plan.path).open(plan); }),
              "an MP4 film needs an even width and height, and 65×48 is not; take 66×48, or write "
              "PNG frames or WebM");
    EXPECT_TRUE(folder.contents().empty());
}

TEST(Formats, GifRefusesRatesThatPlayersSlowDown) {
    EXPECT_NE(input_error_of([&] {
                  check_rate(format_for("a.gif"), {60, 1});
              }).find("at most 50"),
              std::string::npos);
    check_rate(format_for("a.gif"), {50, 1});
    check_rate(format_for("a.mp4"), {240, 1});
}

TEST(Formats, EveryRowNamesAMissingFolder) {
    const TemporaryFolder folder;
    for (const OutputFormat& format : output_formats()) {
        if (format.name == "null") continue;
        const OutputPlan plan = small_plan(folder / "missing/f#" += format.suffix);
        EXPECT_EQ(environment_error_of([&] { format.open(plan); }),
                  "cannot write " + plan.path.string() + ": the folder " +
                      (folder / "missing").string() + " does not exist; make it first");
    }
}

TEST(Md5Sink, HashesTheBytesOfEveryFrame) {
    const TemporaryFolder folder;
    OutputPlan plan = small_plan(folder / "a.md5");
    plan.first_frame = 41;
    const auto sink = format_for(plan.path).open(plan);
    Image picture(1, 1);
    picture.set(0, 0, {'a', 'b', 'c', 'd'});
    sink->write(picture);
    sink->finish();
    // MD5 of "abcd", from md5sum.
    EXPECT_EQ(bytes_of(plan.path), "41 e2fc714c4727ee9395f324cd2e7f331f\n");
}

TEST(PngStill, RefusesASecondFrame) {
    const TemporaryFolder folder;
    const OutputPlan plan = small_plan(folder / "a.png");
    const auto sink = format_for(plan.path).open(plan);
    sink->write(frame_of(plan, 0));
    EXPECT_NE(input_error_of([&] { sink->write(frame_of(plan, 1)); }).find("holds one picture"),
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
    plan.tell = [](const std::string& metadata, const Contents& contents) {
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

TEST(FrameNames, AreFoundInAFolder) {
    const TemporaryFolder folder;
    for (const char* name : {"f_03.png", "f_12.png", "f_111.png", "f_7.png", "f_003.png",
                             "f_05.txt", "g_04.png", "f_.png", "f_0x.png", "f_-1.png"})
        std::ofstream(folder / name) << "x";
    EXPECT_EQ(frames_there(folder / "f_##.png"), (std::vector<std::int64_t>{3, 12, 111}));
    EXPECT_TRUE(frames_there(folder / "none/f_##.png").empty());
}

TEST(PngSequence, SecondRunIsRefused) {
    const TemporaryFolder folder;
    const OutputPlan plan = small_plan(folder / "f_#.png");
    const auto first = format_for(plan.path).open(plan);
    EXPECT_NE(environment_error_of([&] { format_for(plan.path).open(plan); }).find("another run"),
              std::string::npos);
}

}  // namespace
}  // namespace poinsot
