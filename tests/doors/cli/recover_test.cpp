// recover: the finished frames of an interrupted film, and their chapters.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/program_run.h"
#include "cli/small_scene.h"
#include "encoding/video_reader.h"
#include "image/png.h"

namespace poinsot::testing {
namespace {

// The finished frames of an interrupted film are the beginning of the complete one, and repeating
// the command gives a byte-identical film.
TEST(Recover, GivesTheFinishedFramesAndRenderContinues) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const std::string film = " --size 96x54 --set film.duration_s=60 --frames 0-899 -q";
    ASSERT_EQ(run_program_in(folder, "recover a.mp4").code, 2);
    ASSERT_EQ(run_program_in(folder, "render scene.toml -o whole.mp4" + film).code, 0);
    // Killed when the log has more than a chunk of 120 frames; the complete film has three times as
    // many.
    const auto n_bytes = std::filesystem::file_size(folder.path() / "whole.mp4") / 3;
    const std::string script = "cd '" + folder.path().string() + "' || exit 1\n'" + program_path() +
                               "' render scene.toml -o a.mp4" + film +
                               " &\nwhile kill -0 $! 2>/dev/null && [ \"$(stat -c " +
                               "%s .a.mp4.part.frames 2>/dev/null || echo 0)\" -lt " +
                               std::to_string(n_bytes) +
                               " ]; do sleep 0.01; done\nkill -9 $!\nwait $! 2>/dev/null\n" +
                               "cp .a.mp4.part.frames .b.mp4.part.frames\n";
    ASSERT_EQ(std::system(script.c_str()), 0);
    ASSERT_FALSE(std::filesystem::exists(folder.path() / "a.mp4"));
    ASSERT_EQ(run_program_in(folder, "recover b.mp4").code, 0);
    VideoReader whole(folder.path() / "whole.mp4"), recovered(folder.path() / "b.mp4");
    const std::int64_t n_frames = recovered.info().n_frames;
    ASSERT_GT(n_frames, 100);
    ASSERT_LT(n_frames, 900);
    Image expected, found;
    for (std::int64_t k = 0; k < n_frames; ++k) {
        ASSERT_TRUE(whole.read(expected) && recovered.read(found)) << k;
        ASSERT_TRUE(expected == found) << k;
    }
    const ProgramRun says = run_program_in(folder, "explain b.mp4");
    EXPECT_NE(says.out.find("frames: 0-" + std::to_string(n_frames - 1) + "\nrun: 0-899\n"),
              std::string::npos)
        << says.out;
    // A recovered film can be rendered again, like every output.
    ASSERT_EQ(run_program_in(folder, "rerender -q b.mp4 -o again.mp4").code, 0);
    EXPECT_TRUE(text_of(folder.path() / "again.mp4") == text_of(folder.path() / "b.mp4"));
    const ProgramRun gone_on = run_program_in(folder, "render scene.toml -o a.mp4" + film);
    ASSERT_EQ(gone_on.code, 0) << gone_on.err;
    EXPECT_EQ(text_of(folder.path() / "a.mp4"), text_of(folder.path() / "whole.mp4"));
}

// Renders a film of a minute in one process and interrupts it when the log has some 40 kB.
void interrupt_render(const ScratchFolder& folder, const std::string& scene,
                      const std::string& film) {
    const std::string script =
        "cd '" + folder.path().string() + "' && '" + program_path() + "' render " + scene + " -o " +
        film +
        " --jobs 1 --size 96x54 --set film.duration_s=60 -q & pid=$!\nwhile [ \"$(stat -c %s '" +
        (folder.path() / ("." + film + ".part.frames")).string() +
        "' 2>/dev/null || echo 0)\" -lt 40000 ]; do sleep 0.01; done\nkill -INT $pid; wait $pid";
    ASSERT_NE(std::system(script.c_str()), 0);
}

// The chapters come from the scene in the film's record, which is read again: here a scene with
// symbols and with keys without a table, whose rows come later.
TEST(Recover, WritesTheFinishedChapters) {
    const ScratchFolder folder;
    folder.write("scene.toml", "labels = false\nunlabelled = [\"omega\"]\n" + racket +
                                   "[symbols]\nomega = \"w\"\n"
                                   "[[chapters]]\nat_s = 0\ntitle = \"One\"\n"
                                   "[[chapters]]\nat_s = 3\ntitle = \"Two\"\n"
                                   "[[chapters]]\nat_s = 50\ntitle = \"Three\"\n");
    // Interrupted when the log has some 250 frames: the second chapter has begun with frame 90.
    interrupt_render(folder, "scene.toml", "a.webm");
    ASSERT_EQ(run_program_in(folder, "recover a.webm").code, 0);
    const VideoInfo info = VideoReader(folder.path() / "a.webm").info();
    ASSERT_EQ(info.chapters.size(), 2u);
    EXPECT_EQ(info.chapters[1].title, "Two");
    EXPECT_EQ(info.chapters[1].end_frame, info.n_frames);
    const std::string beside = text_of(folder.path() / "a.webm.chapters.json");
    EXPECT_NE(beside.find("\"last_frame\": " + std::to_string(info.n_frames - 1)),
              std::string::npos)
        << beside;
    EXPECT_EQ(beside.find("Three"), std::string::npos);
}

// Recovering a film without chapters removes the chapters file of the film that it replaces.
TEST(Recover, RemovesTheChaptersOfAReplacedFilm) {
    const ScratchFolder folder;
    folder.write("told.toml", racket + "[[chapters]]\nat_s = 0.0\ntitle = \"Start\"\n");
    folder.write("plain.toml", racket);
    ASSERT_EQ(run_program_in(folder, "render told.toml -q --size 96x54 -o a.mp4").code, 0);
    ASSERT_TRUE(std::filesystem::exists(folder.path() / "a.chapters.json"));
    interrupt_render(folder, "plain.toml", "a.mp4");
    ASSERT_EQ(run_program_in(folder, "recover a.mp4").code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.chapters.json"));
}

}  // namespace
}  // namespace poinsot::testing
