// Every format: names, refused plans, reproducible films, and faults of the disk.
#include <gtest/gtest.h>

#include <cstring>

#include "compare/compare.h"
#include "encoding/films.h"
#include "encoding/frame_sink.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

TEST(Formats, FileNamesSelectTheirFormat) {
    EXPECT_EQ(format_for("a/b.mp4").name, "mp4");
    EXPECT_EQ(format_for("b.webm").name, "webm");
    EXPECT_EQ(format_for("b.mov").name, "mov");
    EXPECT_EQ(format_for("b.gif").name, "gif");
    EXPECT_EQ(format_for("b.png").name, "png");
    EXPECT_EQ(format_for("b_####.png").name, "png-sequence");
    EXPECT_EQ(format_for("b.md5").name, "md5");
    EXPECT_EQ(format_for("null").name, "null");
    EXPECT_EQ(format_for("b.html").name, "html");
    EXPECT_EQ(format_for("b.pptx").name, "pptx");
    EXPECT_EQ(format_for("####/b.png").name, "png");
}

// So that a new film is read, named in messages and redrawn without another list.
TEST(Formats, FilmsAreNamedByTheTable) {
    const std::string words = film_suffixes();
    std::string last;
    for (const OutputFormat& format : output_formats()) {
        EXPECT_EQ(words.find(format.suffix) != std::string::npos && !format.suffix.empty(),
                  format.film)
            << format.name << ": " << words;
        EXPECT_EQ(is_written_film_name("a" + std::string(format.suffix)), format.film);
        if (format.film) last = format.suffix;
    }
    EXPECT_TRUE(words.ends_with(" or " + last)) << words;
}

TEST(Formats, UnknownSuffixListsTheKnown) {
    EXPECT_EQ(refusal_message([] { format_for("b.mkv"); }),
              "b.mkv: there is no output format for the suffix \".mkv\"; write .mp4, and convert "
              "it without loss: `ffmpeg -i film.mp4 -c copy film.mkv`; the formats are .mp4, "
              ".webm, .mov, .gif, .png, .html, .pptx, .md5");
    EXPECT_NE(refusal_message([] { format_for("film"); }).find("a name without a suffix"),
              std::string::npos);
    EXPECT_NE(refusal_message([] { format_for("b_####.mp4"); }).find("####"), std::string::npos);
}

// Every row writes a complete output of two frames (a still: one) and leaves no other file.
TEST(Formats, EveryRowWritesItsOutput) {
    for (const OutputFormat& format : output_formats()) {
        if (format.open == nullptr) continue;
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
        if (format.open == nullptr) continue;
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
    for (const char* name : {"a.mp4", "a.webm", "a.mov", "a.gif"}) {
        OutputPlan plan = small_plan(folder / name);
        const auto open = [&] { format_for(plan.path).open(plan); };
        plan.rate = {0, 1};
        EXPECT_EQ(refusal_message(open), "a film needs a frame rate above 0; 0/1 is not one")
            << name;
        plan.rate = {30, 0};
        EXPECT_NE(refusal_message(open), "") << name;
        plan.rate = {std::int64_t{1} << 40, 1};
        EXPECT_NE(refusal_message(open), "") << name;
        plan = small_plan(folder / name);
        plan.height_px = 0;
        EXPECT_NE(refusal_message(open), "") << name;
        plan = small_plan(folder / name);
        EXPECT_NE(refusal_message([&] {
                      const auto sink = format_for(plan.path).open(plan);
                      sink->write(Image(10, 10));
                  }).find("a frame of 10×10 pixels"),
                  std::string::npos);
        EXPECT_NE(refusal_message([&] {
                      format_for(plan.path).open(plan)->finish();
                  }).find("was given no frame"),
                  std::string::npos);
    }
    EXPECT_TRUE(folder.contents().empty());
}

TEST(Formats, UnknownQualityListsTheKnown) {
    const TemporaryFolder folder;
    for (const char* name : {"a.mp4", "a.webm", "a.mov"}) {
        OutputPlan plan = small_plan(folder / name);
        plan.quality = "best";
        EXPECT_EQ(refusal_message([&] { format_for(plan.path).open(plan); }),
                  "unknown quality \"best\"; choose from: draft, lecture, print, reference");
    }
}

TEST(Formats, OddSizesAreRefusedForMp4WithASentence) {
    const TemporaryFolder folder;
    OutputPlan plan = small_plan(folder / "a.mp4");
    plan.width_px = 65;
    EXPECT_EQ(refusal_message([&] { format_for(plan.path).open(plan); }),
              "an MP4 film needs an even width and height, and 65×48 is not; take 66×48, or write "
              "PNG frames or WebM");
    EXPECT_TRUE(folder.contents().empty());
}

TEST(Formats, GifRefusesRatesThatPlayersSlowDown) {
    EXPECT_NE(refusal_message([&] {
                  check_rate(format_for("a.gif"), {60, 1});
              }).find("at most 50"),
              std::string::npos);
    check_rate(format_for("a.gif"), {50, 1});
    check_rate(format_for("a.mp4"), {240, 1});
}

TEST(Formats, EveryRowNamesAMissingFolder) {
    const TemporaryFolder folder;
    for (const OutputFormat& format : output_formats()) {
        if (format.open == nullptr) continue;
        if (format.name == "null") continue;
        const OutputPlan plan = small_plan(folder / "missing/f#" += format.suffix);
        EXPECT_EQ(refusal_message<EnvironmentError>([&] { format.open(plan); }),
                  "cannot write " + plan.path.string() + ": the folder " +
                      (folder / "missing").string() + " does not exist; make it first");
    }
}

// Eight cells that show the frame's number in binary, in black and white.
Image spelled(int number) {
    Image image(64, 48);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            const int bit = x / 16 + 4 * (y / 24);
            const std::uint8_t level = number >> bit & 1 ? 255 : 0;
            image.set(x, y, {level, level, level, 255});
        }
    return image;
}
int read_number(const Image& image) {
    int number = 0;
    for (int bit = 0; bit < 8; ++bit)
        number |= (image.at(16 * (bit % 4) + 8, 24 * (bit / 4) + 12).g > 127 ? 1 : 0) << bit;
    return number;
}

TEST(Films, EveryFrameShowsItsOwnPicture) {
    for (const char* name : {"a.mp4", "a.webm", "a.mov", "a.gif"}) {
        const TemporaryFolder folder;
        const OutputPlan plan = small_plan(folder / name, 256);
        const auto sink = format_for(plan.path).open(plan);
        for (int k = 0; k < 256; ++k) sink->write(spelled(k));
        sink->finish();
        const std::vector<Image> frames = frames_of(plan.path);
        ASSERT_EQ(frames.size(), 256u) << name;
        for (int k = 0; k < 256; ++k)
            EXPECT_EQ(read_number(frames[static_cast<std::size_t>(k)]), k) << name;
    }
}

// The first frame as decoded compared with the rendered picture, at the quality of a lecture.
TEST(Films, FirstFrameIsCloseToItsPicture) {
    for (const char* name : {"a.mp4", "a.webm", "a.mov"}) {
        const TemporaryFolder folder;
        OutputPlan plan = small_plan(folder / name, 3);
        plan.width_px = 320;
        plan.height_px = 180;
        plan.quality = "lecture";
        write_film(plan);
        const Image shown = frames_of(plan.path)[0], drawn = frame_of(plan, 0);
        EXPECT_LT(mean_difference(shown, drawn), 2);           // measured 1.27 levels (H.264)
        EXPECT_GT(structural_similarity(shown, drawn), 0.99);  // measured 0.9930
    }
}

TEST(Films, AreReproducible) {
    std::vector<Image> pictures;
    for (int k = 0; k < 20; ++k) pictures.push_back(synthetic_frame(320, 180, k));
    for (const char* name : {"a.mp4", "a.webm", "a.mov", "a.gif"}) {
        for (const char* quality : {"draft", "lecture"}) {
            const TemporaryFolder folder;
            OutputPlan plan = small_plan(folder / name, 20);
            plan.width_px = 320;
            plan.height_px = 180;
            plan.quality = quality;
            std::string first;
            for (int run = 0; run < 3; ++run) {
                const auto sink = format_for(plan.path).open(plan);
                for (const Image& picture : pictures) sink->write(picture);
                sink->finish();
                if (run == 0) first = bytes_of(plan.path);
                EXPECT_TRUE(bytes_of(plan.path) == first) << name << " " << quality;
            }
        }
    }
}

TEST(Films, DoNotContainTheirPath) {
    for (const char* name : {"a.mp4", "a.webm", "a.mov", "a.gif"}) {
        const TemporaryFolder folder;
        const OutputPlan plan = small_plan(folder / name);
        write_film(plan);
        EXPECT_EQ(bytes_of(plan.path).find("poinsot_test"), std::string::npos) << name;
    }
}

TEST(Recover, AcceptsOnlyFilms) {
    const TemporaryFolder folder;
    EXPECT_NE(refusal_message([&] { recover_film(folder / "a_#.png"); }).find("is not a film"),
              std::string::npos);
}

TEST(Films, SecondRunOnTheSameOutputIsRefused) {
    const TemporaryFolder folder;
    for (const char* name : {"a.mp4", "a.webm", "a.mov", "a.gif"}) {
        const OutputPlan plan = small_plan(folder / name);
        const auto first = format_for(plan.path).open(plan);
        EXPECT_EQ(refusal_message<EnvironmentError>([&] { format_for(plan.path).open(plan); }),
                  "cannot write " + plan.path.string() +
                      ": another run is writing it; wait for it or name another output");
    }
}

struct Fault {
    const char* name;
    std::function<void(const fs::path& folder)> make;
    const char* reason;
};

// Every format with every fault: one line with the path and the reason, and no file left.
TEST(Films, FaultsAreReportedAndLeaveNothing) {
    const std::vector<Fault> faults = {
        {"limited file size", [](const fs::path&) { limit_file_size(2000); }, "File too large"},
        {"full disk",
         [](const fs::path& folder) {
             if (!mount_small(folder, "4k"))
                 throw std::runtime_error("this machine does not let us mount");
         },
         "No space left on device"},
        {"folder without permission",
         [](const fs::path& folder) {
             fs::permissions(folder, fs::perms(0555));
             drop_privileges();
         },
         "Permission denied"},
    };
    for (const Fault& fault : faults) {
        for (const char* name : {"a.mp4", "a.webm", "a.mov", "a.gif", "a_#.png", "a.png"}) {
            const TemporaryFolder folder;
            OutputPlan plan = small_plan(folder / name, std::string(name) == "a.png" ? 1 : 130);
            plan.width_px = 160;
            plan.height_px = 120;
            plan.quality = "reference";
            const std::string outcome = outcome_in_child([&] {
                fault.make(folder.path());
                try {
                    write_film(plan);
                } catch (const EnvironmentError&) {
                    for (const std::string& left : TemporaryFolder::contents_of(folder.path()))
                        if (left.find("a_") != 0) throw std::runtime_error("left " + left);
                    throw;
                }
                throw std::runtime_error("nothing was noticed");
            });
            if (outcome == no_mount) continue;
            EXPECT_EQ(outcome.find("cannot write " + folder.path().string()), 0u)
                << fault.name << " " << name << ": " << outcome;
            EXPECT_NE(outcome.find(fault.reason), std::string::npos)
                << fault.name << " " << name << ": " << outcome;
            EXPECT_EQ(outcome.find('\n'), std::string::npos);
        }
    }
}

TEST(Films, VanishedFolderIsReported) {
    for (const char* name : {"a.mp4", "a.webm", "a.mov", "a.gif", "a_#.png", "a.png", "a.md5"}) {
        const TemporaryFolder folder;
        fs::create_directory(folder / "sub");
        const OutputPlan plan = small_plan(folder / "sub" / name, 1);
        const auto sink = format_for(plan.path).open(plan);
        fs::remove_all(folder / "sub");
        const std::string message = refusal_message<EnvironmentError>([&] {
            sink->write(frame_of(plan, 0));
            sink->finish();
        });
        EXPECT_EQ(message.find("cannot write "), 0u) << name << ": " << message;
    }
}

// No disk has half of the space that the first chunk predicts for the film.
TEST(Films, LackOfDiskSpaceIsReportedAfterTheFirstFrames) {
    const TemporaryFolder folder;
    for (const char* name : {"a.mp4", "a.webm", "a.mov", "a.gif", "a_#.png"}) {
        OutputPlan plan = small_plan(folder / name, 130);
        plan.n_frames = std::int64_t{1} << 50;
        const auto sink = format_for(plan.path).open(plan);
        const std::string message = refusal_message<EnvironmentError>([&] {
            for (std::int64_t k = 0; k < 130; ++k) sink->write(frame_of(plan, k));
        });
        EXPECT_NE(message.find("remaining frames need about"), std::string::npos) << name;
    }
}

}  // namespace
}  // namespace poinsot
