// Films that were interrupted: killed, cut, out of room; then recovered or gone on with.
#include <gtest/gtest.h>
#include <signal.h>

#include <random>
#include <thread>

#include "output/film_part.h"
#include "output/films.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

OutputPlan film_plan(const fs::path& path) {
    OutputPlan plan = small_plan(path, 400);
    plan.resume = true;
    return plan;
}

// Writes the film in a child process and kills it when the part aside has grown to a size.
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
    const fs::path part = film_part_path(plan.path);
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        std::error_code ignored;
        const std::uintmax_t size = fs::file_size(part, ignored);
        if (!ignored && size >= n_bytes) {
            kill(child, SIGKILL);
            waitpid(child, &status, 0);
            return;
        }
        std::this_thread::yield();
    }
}

TEST(InterruptedFilm, GoesOnToTheSameBytes) {
    const TemporaryFolder folder;
    const OutputPlan plan = film_plan(folder / "a.mp4");
    write_film(plan);
    const std::string whole = bytes_of(plan.path);
    fs::remove(plan.path);
    std::mt19937 random(7);
    int n_resumed = 0;
    for (int i = 0; i < 20; ++i) {
        write_and_kill(plan,
                       std::uniform_int_distribution<std::uintmax_t>(0, whole.size())(random));
        // Under the final name there is the whole film or nothing.
        if (fs::exists(plan.path)) {
            EXPECT_TRUE(bytes_of(plan.path) == whole);
            fs::remove(plan.path);
            continue;
        }
        {
            const auto sink = format_for(plan.path).open(plan);
            const std::int64_t n_kept = sink->n_frames_kept();
            n_resumed += n_kept > 0;
            EXPECT_EQ(n_kept % 120, 0);
            for (std::int64_t k = n_kept; k < plan.n_frames; ++k) sink->write(frame_of(plan, k));
            sink->finish();
        }
        EXPECT_TRUE(bytes_of(plan.path) == whole) << "run " << i;
        EXPECT_EQ(folder.contents(), std::vector<std::string>{"a.mp4"});
        fs::remove(plan.path);
    }
    EXPECT_GT(n_resumed, 5);
}

TEST(InterruptedFilm, IsRecoveredAsFarAsItGoes) {
    const TemporaryFolder folder;
    const OutputPlan plan = film_plan(folder / "a.mp4");
    write_film(plan);
    const std::vector<Image> whole = frames_of(plan.path);
    fs::remove(plan.path);
    {
        const auto sink = format_for(plan.path).open(plan);
        for (std::int64_t k = 0; k < 300; ++k) sink->write(frame_of(plan, k));
    }
    EXPECT_EQ(folder.contents(), std::vector<std::string>{".a.mp4.part.mp4"});
    const std::string part = bytes_of(film_part_path(plan.path));
    std::mt19937 random(11);
    std::int64_t most = 0;
    for (int i = 0; i < 40; ++i) {
        // Cut anywhere, as a kill or a crash of the machine may.
        const std::size_t size =
            i == 0 ? part.size()
                   : std::uniform_int_distribution<std::size_t>(0, part.size())(random);
        std::ofstream(film_part_path(plan.path), std::ios::binary) << part.substr(0, size);
        std::int64_t n_frames = 0;
        try {
            n_frames = recover_film(plan.path);
        } catch (const InputError&) {
            EXPECT_LT(size, part.size() / 4) << "nothing was recovered of " << size << " bytes";
            EXPECT_FALSE(fs::exists(plan.path));
            continue;
        }
        const std::vector<Image> frames = frames_of(plan.path);
        ASSERT_EQ(static_cast<std::int64_t>(frames.size()), n_frames);
        for (std::size_t k = 0; k < frames.size(); ++k)
            ASSERT_TRUE(frames[k] == whole[k]) << "frame " << k << " of " << n_frames;
        most = std::max(most, n_frames);
        fs::remove(plan.path);
    }
    // A fragment of a quarter of a second and the encoder's delay are what a kill takes.
    EXPECT_GE(most, 300 - 30);
}

TEST(InterruptedFilm, OfAnotherPlanIsNotGoneOnWith) {
    const TemporaryFolder folder;
    const auto n_kept_by = [&](const OutputPlan& plan) {
        OutputPlan first = film_plan(folder / "a.mp4");
        {
            const auto sink = format_for(first.path).open(first);
            for (std::int64_t k = 0; k < 250; ++k) sink->write(frame_of(first, k));
        }
        const auto sink = format_for(plan.path).open(plan);
        return sink->n_frames_kept();
    };
    OutputPlan plan = film_plan(folder / "a.mp4");
    EXPECT_EQ(n_kept_by(plan), 240);
    plan.metadata = "another scene";
    EXPECT_EQ(n_kept_by(plan), 0);
    plan = film_plan(folder / "a.mp4");
    plan.quality = "lecture";
    EXPECT_EQ(n_kept_by(plan), 0);
    plan = film_plan(folder / "a.mp4");
    plan.rate = {25, 1};
    EXPECT_EQ(n_kept_by(plan), 0);
    plan = film_plan(folder / "a.mp4");
    plan.first_frame = 1;
    EXPECT_EQ(n_kept_by(plan), 0);
    plan = film_plan(folder / "a.mp4");
    plan.resume = false;
    EXPECT_EQ(n_kept_by(plan), 0);
}

TEST(InterruptedFilm, OfGarbageStartsAgain) {
    const TemporaryFolder folder;
    const OutputPlan plan = film_plan(folder / "a.mp4");
    std::ofstream(film_part_path(plan.path)) << std::string(5000, 'x');
    EXPECT_EQ(input_error_of([&] { recover_film(plan.path); }),
              "no frame of " + plan.path.string() + " had been finished");
    std::ofstream(film_part_path(plan.path)) << std::string(5000, 'x');
    write_film(plan);
    EXPECT_EQ(frames_of(plan.path).size(), 400u);
}

TEST(InterruptedFilm, WithoutAWholeFragmentLeavesNothing) {
    const TemporaryFolder folder;
    const OutputPlan plan = film_plan(folder / "a.mp4");
    std::ofstream(folder / ".a.mp4.renewed.mp4") << "of a run killed while it renewed its part";
    format_for(plan.path).open(plan)->write(frame_of(plan, 0));
    EXPECT_TRUE(folder.contents().empty());
}

TEST(InterruptedFilm, IsNotThereWithoutOne) {
    const TemporaryFolder folder;
    EXPECT_EQ(input_error_of([&] { recover_film(folder / "a.mp4"); }),
              "there is no unfinished film of " + (folder / "a.mp4").string());
}

TEST(Films, SecondRunOnTheSameOutputIsRefused) {
    const TemporaryFolder folder;
    for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
        const OutputPlan plan = small_plan(folder / name);
        const auto first = format_for(plan.path).open(plan);
        EXPECT_EQ(environment_error_of([&] { format_for(plan.path).open(plan); }),
                  "cannot write " + plan.path.string() +
                      ": another run is writing it; wait for it or name another output");
    }
}

struct Fault {
    const char* name;
    std::function<void(const fs::path& folder)> make;
    const char* reason;
};

// Every format under every fault: one line naming the path and the reason, and nothing left.
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
        for (const char* name : {"a.mp4", "a.webm", "a.gif", "a_#.png", "a.png"}) {
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
            if (outcome == kNoMount) continue;
            EXPECT_EQ(outcome.find("cannot write " + folder.path().string()), 0u)
                << fault.name << " " << name << ": " << outcome;
            EXPECT_NE(outcome.find(fault.reason), std::string::npos)
                << fault.name << " " << name << ": " << outcome;
            EXPECT_EQ(outcome.find('\n'), std::string::npos);
        }
    }
}

TEST(Films, VanishedFolderIsReported) {
    for (const char* name : {"a.mp4", "a.webm", "a.gif", "a_#.png", "a.png", "a.md5"}) {
        const TemporaryFolder folder;
        fs::create_directory(folder / "sub");
        const OutputPlan plan = small_plan(folder / "sub" / name, 1);
        const auto sink = format_for(plan.path).open(plan);
        fs::remove_all(folder / "sub");
        const std::string message = environment_error_of([&] {
            sink->write(frame_of(plan, 0));
            sink->finish();
        });
        EXPECT_EQ(message.find("cannot write "), 0u) << name << ": " << message;
    }
}

// Half of what is needed by the first chunk's measure would be free on no disk.
TEST(Films, WantOfRoomIsReportedAfterTheFirstFrames) {
    const TemporaryFolder folder;
    for (const char* name : {"a.mp4", "a_#.png"}) {
        OutputPlan plan = small_plan(folder / name, 130);
        plan.n_frames = std::int64_t{1} << 50;
        const auto sink = format_for(plan.path).open(plan);
        const std::string message = environment_error_of([&] {
            for (std::int64_t k = 0; k < 130; ++k) sink->write(frame_of(plan, k));
        });
        EXPECT_NE(message.find("frames to come need about"), std::string::npos) << name;
    }
}

}  // namespace
}  // namespace poinsot
