// What has the name of unfinished work and is something else: each kind of output refuses it before
// it draws, and leaves it as it is.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cli/folder_state.h"
#include "cli/program_run.h"

namespace poinsot::testing {
namespace {

namespace fs = std::filesystem;

constexpr const char* small_talk = R"([body]
moments_kg_m2 = [1.0, 2.0, 2.9]
[start]
omega_rad_s = [1.5, 0.3, 0.75]
[film]
size = [64, 36]
fps = 10
length_s = 1.0
[[stops]]
at_s = 0.5
[[captions]]
at_s = 0.2
text = "It rolls."
[[chapters]]
at_s = 0.0
title = "One"
)";

const std::vector<std::string> kinds{
    "link to a folder", "link to a file", "link to nothing",      "pipe", "file",
    "empty file",       "folder",         "folder with our names"};

void plant(const std::string& kind, const fs::path& folder, const fs::path& path) {
    fs::create_directories(folder / "victim/deep");
    for (const char* name : {"victim/precious", "victim/deep/file", "victim/01.mp4"})
        std::ofstream(folder / name) << "mine";
    if (kind == "link to a folder") fs::create_symlink("victim", path);
    if (kind == "link to a file") fs::create_symlink("victim/precious", path);
    if (kind == "link to nothing") fs::create_symlink("nowhere", path);
    if (kind == "pipe") {
        ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    }
    if (kind == "file") std::ofstream(path) << "mine";
    if (kind == "empty file") std::ofstream{path};
    if (kind == "folder") fs::copy(folder / "victim", path, fs::copy_options::recursive);
    if (kind != "folder with our names") return;
    fs::create_directory(path);
    for (const char* name : {"01.mp4", "1-of-2.mp4", "held", "finished", "poster1.png"})
        std::ofstream(path / name) << "mine";
}

struct Place {
    std::string hidden, command;
    bool all = false;  // try all kinds, once for each way in which the program opens a place
};

class InTheWay : public ::testing::TestWithParam<Place> {};

TEST_P(InTheWay, OfAnOutputIsRefusedAndStays) {
    const auto& [hidden, command, all] = GetParam();
    const std::vector<std::string> some{"link to a folder", "file"};
    for (const std::string& kind : all ? kinds : some) {
        const ScratchFolder folder;
        folder.write("a.toml", small_talk);
        plant(kind, folder.path(), folder.path() / hidden);
        const std::string before = state_of(folder.path());
        const ProgramRun done = run_program_in(folder, command, "timeout 60");
        EXPECT_EQ(done.code, 3) << kind << ": " << done.err;
        // The last line: notes on the scene come before.
        const std::size_t at = done.err.rfind("cannot write o");
        ASSERT_NE(at, std::string::npos) << kind << ": " << done.err;
        const std::string message = done.err.substr(at);
        EXPECT_TRUE(is_one_line(message)) << message;
        EXPECT_TRUE(contains(message, hidden + " exists and is not unfinished work of poinsot; "
                                               "remove it, or name another output"))
            << kind << ": " << message;
        EXPECT_FALSE(contains(message, "victim") || contains(message, "nowhere")) << message;
        EXPECT_EQ(state_of(folder.path()), before) << kind;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Outputs, InTheWay,
    ::testing::Values(Place{".o.png.part", "still a.toml -o o.png", true},
                      Place{".o.pdf.part", "still a.toml -o o.pdf"},
                      Place{".o.svg.part", "still a.toml -o o.svg"},
                      Place{".o.csv.part", "sample a.toml --times 0 -o o.csv"},
                      Place{".o_2.png.part", "still a.toml a.toml --sheet 2x1 -o o_2.png"},
                      Place{".o_##.png.part", "render a.toml -q -o o_##.png", true},
                      Place{".o_##.png.part", "render a.toml -q --jobs 2 -o o_##.png"},
                      Place{".o_07.png.part", "render a.toml -q -o o_##.png"},
                      Place{".o_##.png.1-of-2.part", "render a.toml -q --part 1/2 -o o_##.png"},
                      Place{".o.mp4.part.frames", "render a.toml -q -o o.mp4", true},
                      Place{".o.mp4.part.frames", "render a.toml -q --jobs 2 -o o.mp4"},
                      Place{".o.mp4.part.frames", "render a.toml -q --part 1/1 -o o.mp4"},
                      Place{".o.mp4.part", "render a.toml -q -o o.mp4", true},
                      Place{".o.mp4.part", "render a.toml -q --jobs 2 -o o.mp4"},
                      Place{".o.vtt.part", "render a.toml -q -o o.mp4"},
                      Place{".o.chapters.json.part", "render a.toml -q --jobs 2 -o o.mp4"},
                      Place{".o.mp4.parts", "render a.toml -q -o o.mp4"},
                      Place{".o.mp4.parts", "render a.toml -q --jobs 2 -o o.mp4", true},
                      Place{".o.webm.part.frames", "render a.toml -q -o o.webm"},
                      Place{".o.mov.part.frames", "render a.toml -q -o o.mov"},
                      Place{".o.gif.part.frames", "render a.toml -q -o o.gif"},
                      Place{".o.gif.part", "render a.toml -q -o o.gif"},
                      Place{".o.part", "render a.toml -q --slides o", true},
                      Place{".o.held", "render a.toml -q --slides o", true},
                      Place{".o.pptx.part", "render a.toml -q -o o.pptx"},
                      Place{".o.pptx.held", "render a.toml -q -o o.pptx"},
                      Place{".o.pptx.slides", "render a.toml -q -o o.pptx", true}));

// Files beside a film, which the user does not name.
TEST(BesideAFilm, AFileOfSomebodyElseIsNotReplaced) {
    const ScratchFolder folder;
    folder.write("a.toml", small_talk);
    for (const std::string name : {"o.vtt", "o.chapters.json"})
        for (const std::string jobs : {"--jobs 1", "--jobs 2"}) {
            folder.write(name, "mine");
            const std::string before = state_of(folder.path());
            const ProgramRun done = run_program_in(folder, "render a.toml -q -o o.mp4 " + jobs);
            EXPECT_EQ(done.code, 2) << done.err;
            EXPECT_TRUE(contains(done.err, name + ": exists and is not as poinsot wrote it, and "
                                                  "the film's "))
                << done.err;
            EXPECT_EQ(state_of(folder.path()), before);
            fs::remove(folder.path() / name);
        }
    // Its own are replaced, also those of another film.
    ASSERT_EQ(run_program_in(folder, "render a.toml -q -o o.mp4").code, 0);
    fs::rename(folder.path() / "o.vtt", folder.path() / "p.vtt");
    fs::rename(folder.path() / "o.chapters.json", folder.path() / "p.chapters.json");
    EXPECT_EQ(run_program_in(folder, "render a.toml -q -o p.mp4").code, 0);
}

// Two runs at once: the second names the output, not a hidden file.
TEST(Slides, OfAnotherRunAreNamedInTheRefusal) {
    const ScratchFolder folder;
    folder.write("a.toml", small_talk);
    for (const std::string output : {"--slides o", "-o o.pptx"}) {
        const std::string name = output.substr(output.rfind(' ') + 1);
        folder.write("script", "\"$1\" render a.toml -q " + output +
                                   " --set film.size=[1280,720] --set film.fps=60 & first=$!\n"
                                   "while [ ! -e ." +
                                   name +
                                   ".held ] && kill -0 $first; do sleep "
                                   "0.01; done\nkill -STOP $first; \"$1\" render a.toml -q " +
                                   output +
                                   "; echo $? >code; kill -CONT $first; kill -INT $first; "
                                   "wait $first; rm -rf ." +
                                   name + ".*");
        const ProgramRun done = run_program_in(folder, "", "bash script");
        EXPECT_EQ(text_of(folder.path() / "code"), "3\n") << done.err;
        EXPECT_TRUE(contains(done.err, "cannot write " + name + ": another run is writing it"))
            << done.err;
        EXPECT_FALSE(contains(done.err, "held")) << done.err;
    }
}

// A pipe as output receives the bytes of the file.
TEST(OutputPipe, ReceivesAPresentation) {
    const ScratchFolder folder;
    folder.write("a.toml", small_talk);
    ASSERT_EQ(mkfifo((folder.path() / "o.pptx").c_str(), 0600), 0);
    folder.write(
        "script",
        "cat o.pptx >copy & \"$1\" render a.toml -q -o o.pptx; echo $? >code; wait; \"$1\" "
        "render a.toml -q -o p.pptx");
    const ProgramRun done = run_program_in(folder, "", "timeout 60 bash script");
    EXPECT_EQ(text_of(folder.path() / "code"), "0\n") << done.err;
    EXPECT_TRUE(text_of(folder.path() / "copy") == text_of(folder.path() / "p.pptx"));
    EXPECT_TRUE(fs::is_fifo(folder.path() / "o.pptx"));
}

// Names that are too long, for every kind of output: one line in our own words.
TEST(LongName, IsSaidInOneLine) {
    const ScratchFolder folder;
    folder.write("a.toml", small_talk);
    const std::string before = folder.listing();
    for (const std::size_t n : {250u, 260u, 5000u})
        for (const std::string& command :
             {"still a.toml -q -o " + std::string(n, 'L') + ".png",
              "still a.toml -q -o " + std::string(n, 'L') + "/a.png",
              "render a.toml -q -o " + std::string(n, 'L') + ".mp4",
              "render a.toml -q --jobs 2 -o " + std::string(n, 'L') + ".mp4",
              "render a.toml -q -o " + std::string(n, 'L') + "##.png",
              "render a.toml -q -o " + std::string(n, 'L') + ".pptx",
              "render a.toml -q --slides " + std::string(n + 8, 'L'),
              "sample a.toml --times 0 -o " + std::string(n + 8, 'L'),
              "join " + std::string(n, 'L') + ".mp4 -o b.mp4",
              "check " + std::string(n, 'L') + ".toml"}) {
            const ProgramRun done = run_program_in(folder, command);
            EXPECT_TRUE(done.code == 2 || done.code == 3) << done.code << " " << command;
            EXPECT_TRUE(is_one_line(done.err)) << done.err;
            EXPECT_FALSE(contains(done.err, "filesystem error")) << done.err;
        }
    EXPECT_EQ(folder.listing(), before);
    const ProgramRun done =
        run_program_in(folder, "render a.toml -q --slides " + std::string(256, 'L'));
    EXPECT_TRUE(contains(done.err, "the name is too long")) << done.err;
}

// A damaged part of an interrupted run is drawn again.
TEST(DamagedPart, OfAnInterruptedRunIsDrawnAgain) {
    const ScratchFolder folder;
    folder.write("a.toml", small_talk);
    const std::string film = "render a.toml -q --set film.fps=60 --set film.length_s=4.0 ";
    ASSERT_EQ(run_program_in(folder, film + "-o one.mp4 --jobs 1").code, 0);
    ASSERT_EQ(run_program_in(folder, film + "-o 2.mp4 --part 2/2").code, 0);
    const std::string part = text_of(folder.path() / "2.mp4");
    const fs::path aside = folder.path() / ".o.mp4.parts";
    std::string flipped = part;
    flipped[part.size() / 2] = static_cast<char>(flipped[part.size() / 2] ^ 1);
    std::string without_head = part;
    without_head[9] = 'x';
    for (const std::string& left :
         {part, std::string(), part.substr(0, part.size() / 2), flipped, without_head}) {
        fs::create_directory(aside);
        std::ofstream(aside / "unfinished") << "poinsot: unfinished parts of o.mp4\n";
        std::ofstream(aside / "2-of-2.mp4", std::ios::binary) << left;
        const ProgramRun done = run_program_in(folder, film + "-o o.mp4 --jobs 2");
        EXPECT_EQ(done.code, 0) << done.err;
        EXPECT_TRUE(text_of(folder.path() / "o.mp4") == text_of(folder.path() / "one.mp4"));
        EXPECT_FALSE(fs::exists(aside));
    }
}

}  // namespace
}  // namespace poinsot::testing
