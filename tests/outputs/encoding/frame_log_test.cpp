// Interrupted films: killed, truncated; then recovered or resumed.
#include "encoding/frame_log.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <zlib.h>

#include <cstring>
#include <random>
#include <thread>

#include "encoding/films.h"

namespace poinsot::resume_tests {
namespace {

namespace fs = std::filesystem;

// Path of the log of an unfinished film.
fs::path log_of(const OutputPlan& plan) { return frame_log_path(plan.path); }

// Writes the film in a child process and kills it when the log has reached a size.
void write_and_kill(const OutputPlan& plan, std::uintmax_t n_bytes) {
    const pid_t child = fork();
    if (child == 0) {
        try {
            write_film(plan);
        } catch (...) {
            _exit(1);
        }
        _exit(0);
    }
    const fs::path part = log_of(plan);
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        std::error_code ignored;
        const std::uintmax_t size = fs::file_size(part, ignored);
        if (!ignored && size >= n_bytes) {
            kill(child, SIGKILL);
            waitpid(child, &status, 0);
            return;
        }
        std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
}

// Leaves the log of a film with this many frames.
void write_unfinished(const OutputPlan& plan, std::int64_t n_frames) {
    const auto sink = format_for(plan.path).open(plan);
    for (std::int64_t k = sink->n_frames_kept(); k < n_frames; ++k) sink->write(frame_of(plan, k));
}

struct Film {
    const char* name;
    std::int64_t n_chunk_frames;  // kept frames are a multiple of this
};
class InterruptedFilm : public ::testing::TestWithParam<Film> {
 protected:
    TemporaryFolder folder_;
    OutputPlan plan_ = film_plan(folder_ / GetParam().name);
};

TEST_P(InterruptedFilm, IsResumedByteIdentically) {
    write_film(plan_);
    const std::string whole = bytes_of(plan_.path);
    fs::remove(plan_.path);
    write_unfinished(plan_, 399);
    const std::uintmax_t n_part_bytes = fs::file_size(log_of(plan_));
    std::mt19937 random(7);
    int n_resumed = 0;
    for (int i = 0; i < 7; ++i) {
        write_and_kill(plan_,
                       std::uniform_int_distribution<std::uintmax_t>(0, n_part_bytes)(random));
        // Under the final name there is the complete film or no file.
        if (fs::exists(plan_.path)) {
            EXPECT_TRUE(bytes_of(plan_.path) == whole);
            fs::remove(plan_.path);
            continue;
        }
        {
            const auto sink = format_for(plan_.path).open(plan_);
            const std::int64_t n_kept = sink->n_frames_kept();
            n_resumed += n_kept > 0;
            EXPECT_TRUE(n_kept == plan_.n_frames || n_kept % GetParam().n_chunk_frames == 0);
            for (std::int64_t k = n_kept; k < plan_.n_frames; ++k) sink->write(frame_of(plan_, k));
            sink->finish();
        }
        EXPECT_TRUE(bytes_of(plan_.path) == whole) << "run " << i;
        EXPECT_EQ(folder_.contents(), std::vector<std::string>{GetParam().name});
        fs::remove(plan_.path);
        write_unfinished(plan_, std::uniform_int_distribution<std::int64_t>(0, 399)(random));
    }
    EXPECT_GT(n_resumed, 2);
}

// After a changed bit in the log, later frames are rendered again; the film contains no wrong
// frame.
TEST_P(InterruptedFilm, WithAChangedBitIsResumedByteIdentically) {
    write_film(plan_);
    const std::string whole = bytes_of(plan_.path);
    std::mt19937 random(13);
    for (int i = 0; i < 6; ++i) {
        fs::remove(plan_.path);
        write_unfinished(plan_, 300);
        std::string part = bytes_of(log_of(plan_));
        char& byte = part[std::uniform_int_distribution<std::size_t>(0, part.size() - 1)(random)];
        byte = static_cast<char>(byte ^ (1 << i));
        std::ofstream(log_of(plan_), std::ios::binary) << part;
        write_film(plan_);
        EXPECT_TRUE(bytes_of(plan_.path) == whole) << i;
    }
}

// Its packets depend on frames that it does not show, so these are rendered, too.
TEST_P(InterruptedFilm, RecoveredIsRerenderedByteIdentically) {
    for (const std::int64_t n_drawn : {100, 130, 290, 400}) {
        write_unfinished(plan_, n_drawn);
        OutputPlan again = plan_;
        again.n_shown = recover_film(plan_.path);
        const std::string recovered = bytes_of(plan_.path);
        fs::remove(plan_.path);
        const std::int64_t n_chunk = GetParam().n_chunk_frames;
        again.n_frames =
            std::min(plan_.n_frames, (again.n_shown + n_chunk - 1) / n_chunk * n_chunk);
        write_film(again);
        EXPECT_TRUE(bytes_of(plan_.path) == recovered) << again.n_shown << " of " << n_drawn;
        fs::remove(plan_.path);
    }
}

// The frames of a GIF depend on all frames shown; those of other formats are those of the whole
// film.
TEST_P(InterruptedFilm, IsRecoveredUpToTheInterruption) {
    write_film(plan_);
    const std::vector<Image> whole = frames_of(plan_.path);
    fs::remove(plan_.path);
    write_unfinished(plan_, 300);
    EXPECT_EQ(folder_.contents(), std::vector<std::string>{log_of(plan_).filename().string()});
    const std::string part = bytes_of(log_of(plan_));
    const bool is_gif = plan_.path.extension() == ".gif";
    std::mt19937 random(11);
    for (int i = 0; i < 20; ++i) {
        // Truncated anywhere, as after a kill or a crash of the machine.
        const std::size_t size =
            i == 0 ? part.size()
                   : std::uniform_int_distribution<std::size_t>(0, part.size())(random);
        std::ofstream(log_of(plan_), std::ios::binary) << part.substr(0, size);
        std::int64_t n_frames = 0;
        try {
            n_frames = recover_film(plan_.path);
        } catch (const InputError&) {
            EXPECT_LT(size, part.size() / 4) << "nothing was recovered of " << size << " bytes";
            EXPECT_FALSE(fs::exists(plan_.path));
            continue;
        }
        EXPECT_EQ(folder_.contents(), std::vector<std::string>{GetParam().name});
        const std::vector<Image> frames = frames_of(plan_.path);
        ASSERT_EQ(static_cast<std::int64_t>(frames.size()), n_frames);
        for (std::size_t k = 0; k < frames.size(); ++k)
            ASSERT_TRUE(is_gif ? mean_difference(frames[k], whole[k]) < 1 : frames[k] == whole[k])
                << "frame " << k << " of " << n_frames;
        fs::remove(plan_.path);
    }
}

// A GIF has none.
TEST_P(InterruptedFilm, RecoveredKeepsItsChapters) {
    write_unfinished(plan_, 200);
    const std::int64_t n_frames = recover_film(plan_.path);
    const VideoInfo info = VideoReader(plan_.path).info();
    const bool is_gif = plan_.path.extension() == ".gif";
    ASSERT_EQ(info.chapters.size(), is_gif ? 0u : 2u);
    if (is_gif) return;
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(info.chapters[i].title, plan_.chapters[i].title);
        EXPECT_EQ(info.chapters[i].first_frame, plan_.chapters[i].first_frame);
    }
    EXPECT_EQ(info.chapters[0].end_frame, 90);
    EXPECT_EQ(info.chapters[1].end_frame, n_frames);
}

// One second of film, at the rate of the cinema, minus the frames in the queue before the encoder
// and the frame being rendered.
TEST_P(InterruptedFilm, LosesLessThanItsLastSecond) {
    constexpr std::int64_t n_in_queue = 5;
    for (const char* quality : {"draft", "lecture", "print", "reference"}) {
        OutputPlan plan = plan_;
        plan.quality = quality;
        plan.rate = {24, 1};
        write_unfinished(plan, 190);
        const std::int64_t n_lost = 190 - recover_film(plan.path);
        // measured 4 and 17 (MP4), 15 (WebM), 0 (GIF)
        EXPECT_LE(n_lost, 24 - n_in_queue) << quality;
        fs::remove(plan.path);
    }
}

// The log remains after a second failure.
TEST_P(InterruptedFilm, KeepsTheLogIfItCannotBeAssembled) {
    write_unfinished(plan_, 300);
    const std::string outcome = outcome_in_child([&] {
        limit_file_size(1000);
        recover_film(plan_.path);
    });
    EXPECT_NE(outcome.find("File too large"), std::string::npos) << outcome;
    EXPECT_EQ(folder_.contents(), std::vector<std::string>{log_of(plan_).filename().string()});
    EXPECT_GT(recover_film(plan_.path), 270);
}

TEST_P(InterruptedFilm, WithAnotherPlanIsNotResumed) {
    const auto n_kept_by = [&](const OutputPlan& plan) {
        write_unfinished(plan_, 250);
        return format_for(plan.path).open(plan)->n_frames_kept();
    };
    const std::int64_t n_kept = 250 - 250 % GetParam().n_chunk_frames;
    EXPECT_EQ(n_kept_by(plan_), n_kept);
    OutputPlan plan = plan_;
    plan.metadata = "another scene";
    EXPECT_EQ(n_kept_by(plan), 0);
    plan = plan_;
    plan.quality = "lecture";
    // The encoders of GIF and MOV do not depend on the quality; a scene's record contains it.
    const auto suffix = plan.path.extension();
    EXPECT_EQ(n_kept_by(plan), suffix == ".gif" || suffix == ".mov" ? n_kept : 0);
    plan = plan_;
    plan.rate = {25, 1};
    EXPECT_EQ(n_kept_by(plan), 0);
    plan = plan_;
    plan.first_frame = 1;
    EXPECT_EQ(n_kept_by(plan), 0);
    plan = plan_;
    plan.resume = false;
    EXPECT_EQ(n_kept_by(plan), 0);
}

TEST_P(InterruptedFilm, WithACorruptLogStartsAgain) {
    write_unfinished(plan_, 130);
    std::ofstream(log_of(plan_)) << std::string(5000, 'x');
    EXPECT_EQ(refusal_message([&] { recover_film(plan_.path); }),
              "no frame of " + plan_.path.string() + " had been finished");
    write_film(plan_);
    EXPECT_EQ(frames_of(plan_.path).size(), 400u);
}

// Valid checksums, but no run of poinsot: entries of one byte, and pictures of another size.
TEST_P(InterruptedFilm, OfAnotherProgramIsRefused) {
    const std::string log = frame_log_path(plan_.path).string();
    std::vector<std::string> contents{"x"};
    {
        const auto png = encode_png(Image(200, 100), {});
        contents.emplace_back(png.begin(), png.end());
    }
    for (const std::string& content : contents) {
        write_unfinished(plan_, 130);
        // The head of the film, followed by this text as its only entry.
        const std::string whole = bytes_of(log);
        std::uint32_t n_head = 0;
        std::memcpy(&n_head, whole.data(), 4);
        const auto size = static_cast<std::uint32_t>(content.size());
        const auto sum = ~static_cast<std::uint32_t>(
            crc32(0, reinterpret_cast<const Bytef*>(content.data()), size));
        std::string forged = whole.substr(0, 8 + n_head);
        forged.append(reinterpret_cast<const char*>(&size), 4);
        forged.append(reinterpret_cast<const char*>(&sum), 4);
        std::ofstream(log, std::ios::binary) << forged + content;
        const std::string refused = refusal_message([&] { recover_film(plan_.path); });
        EXPECT_NE(refused, "");
        EXPECT_FALSE(fs::exists(plan_.path));
        fs::remove(log);
    }
}

// As some file systems leave a growing file when the machine crashes.
TEST_P(InterruptedFilm, WithALogOfZeroesStartsAgain) {
    write_unfinished(plan_, 130);
    for (const std::size_t size : {8u, 4096u}) {
        std::ofstream(log_of(plan_), std::ios::binary) << std::string(size, '\0');
        EXPECT_EQ(refusal_message([&] { recover_film(plan_.path); }),
                  "no frame of " + plan_.path.string() + " had been finished");
    }
}

// A copy of a log continues wherever it lies; any other file of this name stays.
TEST_P(InterruptedFilm, LeavesAFileThatIsNoLog) {
    std::ofstream(log_of(plan_)) << "mine";
    EXPECT_THROW(format_for(plan_.path).open(plan_), EnvironmentError);
    EXPECT_THROW(recover_film(plan_.path), EnvironmentError);
    EXPECT_EQ(bytes_of(log_of(plan_)), "mine");
    fs::remove(log_of(plan_));

    write_unfinished(plan_, 400);
    const std::string log = bytes_of(log_of(plan_));
    fs::remove(log_of(plan_));
    std::ofstream(log_of(plan_), std::ios::binary) << log;
    EXPECT_GT(format_for(plan_.path).open(plan_)->n_frames_kept(), 0);
}

TEST_P(InterruptedFilm, IsNotFoundWithoutALog) {
    EXPECT_EQ(refusal_message([&] { recover_film(plan_.path); }),
              "there is no unfinished film " + plan_.path.string());
    EXPECT_TRUE(folder_.contents().empty());
}

INSTANTIATE_TEST_SUITE_P(Formats, InterruptedFilm,
                         ::testing::Values(Film{"a.mp4", 120}, Film{"a.webm", 120},
                                           Film{"a.mov", 120}, Film{"a.gif", 1}),
                         [](const auto& tested) {
                             return fs::path(tested.param.name).extension().string().substr(1);
                         });

TEST(InterruptedWebm, IsResumedWithTransparency) {
    const TemporaryFolder folder;
    const OutputPlan plan = film_plan(folder / "a.webm");
    const auto frame = [&](std::int64_t k) {
        Image picture = frame_of(plan, k);
        for (std::size_t i = 3; i < picture.bytes().size(); i += 16) picture.bytes()[i] = 90;
        return picture;
    };
    const auto write = [&](std::int64_t n_frames) {
        const auto sink = format_for(plan.path).open(plan);
        for (std::int64_t k = sink->n_frames_kept(); k < n_frames; ++k) sink->write(frame(k));
        if (n_frames == plan.n_frames) sink->finish();
        return sink->n_frames_kept();
    };
    EXPECT_EQ(write(400), 0);
    const std::string whole = bytes_of(plan.path);
    fs::remove(plan.path);
    write(130);
    EXPECT_EQ(write(400), 120);
    EXPECT_TRUE(bytes_of(plan.path) == whole);
}

TEST(InterruptedMp4, WithoutACompletePacketLeavesNothing) {
    const TemporaryFolder folder;
    const OutputPlan plan = film_plan(folder / "a.mp4");
    format_for(plan.path).open(plan)->write(frame_of(plan, 0));
    EXPECT_TRUE(folder.contents().empty());
}

// After a changed byte of the log, the frames from there on are dropped; the others are kept.
TEST(FrameLog, KeepsEntriesBeforeAChangedByte) {
    const TemporaryFolder folder;
    const OutputPlan plan = film_plan(folder / "a.gif");
    write_unfinished(plan, 40);
    const std::string log = bytes_of(frame_log_path(plan.path));
    std::mt19937 random(3);
    for (int i = 0; i < 30; ++i) {
        std::string changed = log;
        const std::size_t at =
            std::uniform_int_distribution<std::size_t>(0, log.size() - 1)(random);
        changed[at] = static_cast<char>(changed[at] ^ (1 << i % 8));
        std::ofstream(frame_log_path(plan.path), std::ios::binary) << changed;
        const auto n_kept = format_for(plan.path).open(plan)->n_frames_kept();
        EXPECT_LT(n_kept, 40);
        // Entries are of nearly one size: those before the byte are kept.
        EXPECT_GE(n_kept, static_cast<std::int64_t>(40 * at / log.size()) - 3) << at;
    }
}

}  // namespace
}  // namespace poinsot::resume_tests
