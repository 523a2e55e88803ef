// What lies in each place that a command writes, and is somebody else's: the file that the user
// named is replaced, and what poinsot can prove to be its own; everything else is refused by name
// and stays.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/folder_state.h"
#include "cli/program_run.h"
#include "sanitized.h"

namespace poinsot::testing {
namespace {

namespace fs = std::filesystem;

// A film of 30 frames with all that lies beside one.
constexpr const char* a_talk = R"([body]
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

// What the tests need, made once: parts, a deck, a presentation, pictures, a measured table.
class OthersFiles : public ::testing::Test {
 protected:
    static void SetUpTestSuite() {
        made_ = std::make_unique<ScratchFolder>();
        made_->write("a.toml", a_talk);
        const auto run = [](const std::string& arguments) {
            const ProgramRun one = run_program_in(*made_, arguments);
            EXPECT_EQ(one.code, 0) << arguments << one.err;
        };
        const std::string wide = " --set film.size=[80,44]";
        run("render a.toml -q --part 1/1 -o part.mp4");
        run("render a.toml -q --slides deck" + wide);
        run("render a.toml -q -o a.pptx");
        run("still a.toml -q -o face.png");
        run("sample a.toml --times 0:20:0.05 --columns time,omega_body -o gyro.csv");
        fs::create_directories(made_->path() / "ref");
        fs::create_directories(made_->path() / "new");
        run("still a.toml -q -o ref/b.png");
        run("still a.toml -q --time 0.5 -o new/b.png");
        made_->write("measured.toml", std::string(a_talk) + "[measured]\nfile = \"gyro.csv\"\n");
        made_->write("times.csv", "0\n0.5\n");
    }
    static void TearDownTestSuite() { made_.reset(); }

    static void fill(const ScratchFolder& folder) {
        fs::copy(made_->path(), folder.path(), fs::copy_options::recursive);
    }

 private:
    static std::unique_ptr<ScratchFolder> made_;
};
std::unique_ptr<ScratchFolder> OthersFiles::made_;

// Under sanitizers every command takes five times as long; there each place is tried with two.
const std::vector<std::string> kinds =
    sanitized
        ? std::vector<std::string>{"file", "pipe"}
        : std::vector<std::string>{
              "file", "folder", "link to a file", "link to a folder", "link to nothing", "pipe"};

void plant(const std::string& kind, const fs::path& folder, const fs::path& path) {
    fs::create_directories(folder / "victim");
    std::ofstream(folder / "victim/precious") << "mine";
    fs::create_directories(path.parent_path());
    fs::remove_all(path);
    if (kind == "file") std::ofstream(path) << "mine";
    if (kind == "folder") fs::copy(folder / "victim", path);
    if (kind == "link to a file") fs::create_symlink(folder / "victim/precious", path);
    if (kind == "link to a folder") fs::create_symlink(folder / "victim", path);
    if (kind == "link to nothing") fs::create_symlink(folder / "victim/new", path);
    if (kind == "pipe") {
        ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    }
}

struct Written {
    std::string place, command;
    std::string but{};  // a kind that is not tried: it is no obstacle there
};

const std::string film = "render a.toml -q -o o.mp4",
                  deck = "render a.toml -q --slides deck --set film.size=[80,44]",
                  submission = "submit a.toml -q --dry-run --parts 2 -o o.mp4",
                  report = "compare ref new --report r.html";

// Places that the user did not name.
const std::vector<Written> unnamed_places{
    Written{"o.vtt", film}, Written{"o.vtt", film + " --jobs 2"}, Written{"o.chapters.json", film},
    Written{"o.webm.vtt", "render a.toml -q -o o.webm"},
    Written{"o.png.chapters.json", "render a.toml -q -o o_##.png"},
    Written{"o.vtt", "join part.mp4 -q -o o.mp4"},
    Written{"o.chapters.json", "join part.mp4 -q -o o.mp4"},
    Written{"o.tex", "still a.toml -q --text latex -o o.pdf"},
    // Of a deck: its own names, names that look like them, others, and its list.
    Written{"deck/01.mp4", deck}, Written{"deck/02.pdf", deck}, Written{"deck/2024.pdf", deck},
    Written{"deck/99.vtt", deck}, Written{"deck/12345-loop.mp4", deck},
    Written{"deck/20261129.png", deck}, Written{"deck/index.html", deck},
    Written{"deck/slides.json", deck}, Written{"deck/notes.txt", deck},
    Written{"o/index.html", "render a.toml -q --slides o"},
    // Default names.
    Written{"output/a.png", "still a.toml -q"}, Written{"output/a.mp4", "render a.toml -q"},
    Written{"output/a.mp4", "render a.toml -q --jobs 2"},
    Written{"output/a_0001.png", "still a.toml -q --chapters"},
    Written{"output/a.1-of-1.mp4", "render a.toml -q --part 1/1"},
    Written{"output/a-tradeoff.csv", "tradeoff a.toml -q"},
    Written{"o.csv", "tradeoff a.toml -q -o o"}, Written{"o.json", "tradeoff a.toml -q -o o"},
    Written{"o-motion.png", "tradeoff a.toml -q -o o"},
    Written{"o-picture.png", "tradeoff a.toml -q -o o"},
    Written{"o-film.png", "tradeoff a.toml -q -o o"},
    // A folder that is there may hold other files.
    Written{"r_pictures", report, "folder"}, Written{"r_pictures/b-actual.png", report},
    Written{"r_pictures/poinsot-files", report}, Written{"o.mp4.job", submission, "folder"},
    Written{"o.mp4.job/task.sh", submission}, Written{"o.mp4.job/films", submission},
    Written{"o.mp4.job/joins", submission}, Written{"o.mp4.job/tasks", submission},
    Written{"o.mp4.job/poinsot-files", submission}};

TEST_F(OthersFiles, StayInPlacesThatNobodyNamed) {
    for (const auto& [place, command, but] : unnamed_places)
        for (const std::string& kind : kinds) {
            if (kind == but) continue;
            const ScratchFolder folder;
            fill(folder);
            plant(kind, folder.path(), folder.path() / place);
            const std::string before = state_of(folder.path());
            const ProgramRun done = run_program_in(folder, command, "timeout 60");
            EXPECT_TRUE(done.code == 2 || done.code == 3)
                << place << ", " << command << ", " << kind << done.code << done.err;
            const std::string message =
                done.err.substr(done.err.find_last_of('\n', done.err.size() - 2) + 1);
            const fs::path path = place;
            EXPECT_TRUE(contains(message, path.filename().string())) << kind << ": " << done.err;
            EXPECT_TRUE(state_of(folder.path()) == before) << place << ", " << kind;
        }
}

// Files that poinsot wrote, edited since.
TEST_F(OthersFiles, AreFilesOfPoinsotThatWereEdited) {
    struct Row {
        std::string place, command;
    };
    const std::string flat = "render a.toml -q --slides o --set film.size=[80,44]";
    for (const auto& [place, command] :
         {Row{"o.vtt", film}, Row{"o.chapters.json", film},
          Row{"o.tex", "still a.toml -q --text latex -o o.pdf"}, Row{"o/01.png", flat},
          Row{"o/slides.json", flat}, Row{"o/index.html", flat},
          Row{"o.pptx", "render a.toml -q -o o.pptx"}, Row{"output/a.mp4", "render a.toml -q"},
          Row{"output/a.png", "still a.toml -q"}, Row{"r_pictures/b-actual.png", report},
          Row{"o.mp4.job/task.sh", submission}, Row{"o.mp4.job/tasks", submission}}) {
        const ScratchFolder folder;
        fill(folder);
        const int code = run_program_in(folder, command).code;
        ASSERT_TRUE(code == 0 || (code == 1 && command == report)) << command;
        // Its own are replaced.
        EXPECT_EQ(run_program_in(folder, command).code, code) << command;
        std::string text = text_of(folder.path() / place);
        ASSERT_FALSE(text.empty()) << place;
        text[text.size() / 2] = static_cast<char>(text[text.size() / 2] ^ 1);
        folder.write(place, text);
        const std::string before = state_of(folder.path());
        const ProgramRun done = run_program_in(folder, command);
        EXPECT_EQ(done.code, 2) << command << done.err;
        EXPECT_TRUE(contains(done.err, fs::path(place).filename().string())) << done.err;
        EXPECT_TRUE(state_of(folder.path()) == before) << place;
    }
}

TEST(Presentation, OfAnotherIsNotReplaced) {
    for (const std::string kind : {"file", "folder", "link to a file", "link to a folder"}) {
        const ScratchFolder folder;
        folder.write("a.toml", a_talk);
        plant(kind, folder.path(), folder.path() / "o.pptx");
        const std::string before = state_of(folder.path());
        const ProgramRun done = run_program_in(folder, "render a.toml -q -o o.pptx");
        EXPECT_TRUE(done.code == 2 || done.code == 3) << kind << done.err;
        EXPECT_TRUE(state_of(folder.path()) == before) << kind;
    }
}

// The rows beside a fitted scene.
TEST(Rows, OfAnotherAreNotReplacedByAFittedScene) {
    const fs::path recording =
        source_folder() / "tests/motion/measured/racket/round3_093502_11.csv";
    const std::string fit = "fit '" + recording.string() + "' --drag linear -o z.toml";
    for (const std::string& kind : kinds) {
        const ScratchFolder folder;
        plant(kind, folder.path(), folder.path() / "z.csv");
        const std::string before = state_of(folder.path());
        const ProgramRun done = run_program_in(folder, fit, "timeout 60");
        EXPECT_EQ(done.code, 2) << kind << done.err;
        EXPECT_TRUE(contains(done.err, "z.csv: exists and is not as poinsot wrote it")) << done.err;
        EXPECT_TRUE(state_of(folder.path()) == before) << kind;
    }
    const ScratchFolder folder;
    ASSERT_EQ(run_program_in(folder, fit).code, 0);
    ASSERT_TRUE(fs::exists(folder.path() / "z.csv"));
    const std::string other_fit = "fit '" + recording.string() + "' --drag quadratic -o z.toml";
    // Another fit of the same name replaces them, also if the scene was edited; edited rows stay.
    folder.write("z.toml", text_of(folder.path() / "z.toml") + "# mine\n");
    EXPECT_EQ(run_program_in(folder, other_fit).code, 0);
    folder.write("z.csv", text_of(folder.path() / "z.csv") + "9,1,1,1\n");
    EXPECT_EQ(run_program_in(folder, fit).code, 2);
}

const std::vector<Written> named_places{
    Written{"o.png", "still a.toml -q -o o.png"},
    Written{"o.pdf", "still a.toml -q -o o.pdf"},
    Written{"o.svg", "still a.toml -q -o o.svg"},
    Written{"o_1.png", "still a.toml -q --chapters -o 'o_#.png'"},
    Written{"o.png", "still a.toml a.toml -q --sheet 2x1 -o o.png"},
    Written{"o.mp4", film},
    Written{"o.mp4", film + " --jobs 2"},
    Written{"o.webm", "render a.toml -q -o o.webm"},
    Written{"o.gif", "render a.toml -q -o o.gif"},
    Written{"o.mp4", "join part.mp4 -q -o o.mp4"},
    Written{"o.png", "rerender face.png -q -o o.png"},
    Written{"o.csv", "sample a.toml --times 0,1 -o o.csv"},
    Written{"o.npy", "sample a.toml --times 0,1 -o o.npy"},
    Written{"o.toml", "fit gyro.csv -o o.toml"},
    Written{"o.svg", "fit gyro.csv --chart o.svg"},
    Written{"r.html", report},
    Written{"o.xml", "compare ref new --junit o.xml"},
    Written{"o.png", "compare ref/b.png new/b.png --diff o.png"}};

// What the user named: a file is replaced, a link followed, also to a file that is not there yet,
// and a folder refused.
TEST_F(OthersFiles, AreReplacedWhereTheUserNamedThem) {
    for (const auto& [place, command, but] : named_places)
        for (const std::string kind : {"file", "folder", "link to a file", "link to nothing"}) {
            const ScratchFolder folder;
            fill(folder);
            const fs::path path = folder.path() / place;
            plant(kind, folder.path(), path);
            const bool is_link = fs::is_symlink(path), is_folder = kind == "folder";
            const ProgramRun done = run_program_in(folder, command, "timeout 120");
            if (is_folder) {
                EXPECT_TRUE(done.code == 2 || done.code == 3) << command << done.code << done.err;
                EXPECT_EQ(text_of(path / "precious"), "mine");
                continue;
            }
            EXPECT_TRUE(done.code == 0 || (done.code == 1 && contains(command, "compare")))
                << done.err;
            EXPECT_EQ(fs::is_symlink(path), is_link) << kind;
            EXPECT_TRUE(fs::exists(path)) << kind;
            EXPECT_NE(text_of(path), "mine") << kind;
            EXPECT_EQ(text_of(folder.path() / "victim/precious") == "mine",
                      kind != "link to a file");
        }
}

// A pipe whose name has a number of a sequence would never be read.
TEST_F(OthersFiles, ArePipesAmongTheFramesOfASequence) {
    const ScratchFolder folder;
    fill(folder);
    plant("pipe", folder.path(), folder.path() / "f_03.png");
    const ProgramRun done = run_program_in(folder, "render a.toml -q -o f_##.png", "timeout 60");
    EXPECT_EQ(done.code, 2) << done.err;
    EXPECT_TRUE(contains(done.err, "f_03.png: a pipe or a device")) << done.err;
}

// No output replaces a file that the same command reads.
TEST_F(OthersFiles, AreTheInputsOfTheSameCommand) {
    const ScratchFolder folder;
    fill(folder);
    folder.write("box.toml",
                 "[body]\nshape = \"box\"\nsize_m = [0.3, 0.2, 0.1]\nmass_kg = 1.0\n"
                 "[start]\nomega_rad_s = [1.5, 0.3, 0.75]\n[film]\nsize = [64, 36]\nlength_s = "
                 "0.2\n[[stops]]\nat_s = 0.1\n"
                 "[[object.pictures]]\nface = \"+e1\"\nfile = \"face_1.png\"\n");
    fs::copy(folder.path() / "face.png", folder.path() / "face_1.png");
    fs::copy(folder.path() / "gyro.csv", folder.path() / "gyro.toml");
    const std::string before = state_of(folder.path());
    for (const std::string& command :
         {std::string("sample measured.toml --times 0,1 -o gyro.csv"),
          std::string("sample measured.toml --times 0,1 -o ./ref/../gyro.csv"),
          std::string("sample a.toml --times-file times.csv -o times.csv"),
          std::string("tradeoff measured.toml -q -o gyro"),
          std::string("fit gyro.toml -o gyro.toml"), std::string("still box.toml -q -o face_1.png"),
          std::string("render box.toml -q -o face_#.png"),
          std::string("still box.toml -q --chapters -o face_#.png"),
          std::string("still box.toml box.toml -q --sheet 2x1 -o face_1.png"),
          std::string("join part.mp4 -q -o part.mp4"),
          std::string("rerender face.png -q -o face.png"),
          std::string("compare ref/b.png new/b.png --diff new/b.png")}) {
        const ProgramRun done = run_program_in(folder, command);
        EXPECT_EQ(done.code, 2) << command << ": " << done.err;
        EXPECT_TRUE(state_of(folder.path()) == before) << command;
    }
}

// Slides and presentations are those of a scene file, not of its name.
TEST(Talks, OfScenesOfOneNameAreTwo) {
    const ScratchFolder folder;
    for (const std::string name : {"A", "B"}) {
        fs::create_directory(folder.path() / name);
        folder.write(name + "/intro.toml", "title = \"" + name + "\"\n" + a_talk);
    }
    for (const std::string output : {"--slides talk", "-o talk.pptx"}) {
        const std::string size = " --set film.size=[80,44]";
        const auto render = [&](const std::string& scene) {
            return run_program_in(folder, "render " + scene + " -q " + output + size);
        };
        ASSERT_EQ(render("A/intro.toml").code, 0);
        const std::string before = state_of(folder.path());
        const ProgramRun other = render("B/intro.toml");
        EXPECT_EQ(other.code, 2);
        EXPECT_TRUE(contains(other.err, "holds the slides of another scene")) << other.err;
        EXPECT_TRUE(state_of(folder.path()) == before);
        // Its own are replaced after any change, and where both were moved.
        folder.write("A/intro.toml",
                     "title = \"New\"\n" + std::string(a_talk) + "[[stops]]\nat_s = 0.8\n");
        EXPECT_EQ(render("A/intro.toml").code, 0);
        EXPECT_EQ(run_program_in(folder, "render ./B/../A/intro.toml -q " + output + size).code, 0);
        // A copy of the scene elsewhere is the same talk until it is edited.
        fs::create_directory(folder.path() / "C");
        fs::copy(folder.path() / "A/intro.toml", folder.path() / "C/intro.toml");
        EXPECT_EQ(render("C/intro.toml").code, 0);
        EXPECT_EQ(render("A/intro.toml").code, 0);
        folder.write("C/intro.toml", "title = \"Other\"\n" + std::string(a_talk));
        EXPECT_EQ(render("C/intro.toml").code, 2);
        fs::remove_all(folder.path() / "C");
        folder.write("A/intro.toml", "title = \"A\"\n" + std::string(a_talk));
    }
}

// Names with control characters go into no script, list or document.
TEST(Names, WithControlCharactersAreNotRun) {
    const ScratchFolder folder;
    const std::string name = "y\nx\ttouch PWNED; #.toml";
    folder.write(name, a_talk);
    const auto quoted = [](const std::string& text) { return "'" + text + "'"; };
    const std::string before = folder.listing();
    for (const std::string& command :
         {"submit " + quoted(name) + " --parts 2 --dry-run -o nl.mp4",
          "submit " + quoted(name) + " --parts 2 --dry-run -o " + quoted("{scene}.mp4"),
          "still " + quoted(name) + " --text latex -o " + quoted("a\nb.pdf")}) {
        const ProgramRun done = run_program_in(folder, command);
        EXPECT_EQ(done.code, 2) << done.err;
        EXPECT_TRUE(is_one_line(done.err)) << done.err;
        EXPECT_EQ(folder.listing(), before);
    }
}

// The narrowest film of slides is named by its size, not by an option that nobody gave.
TEST(Slides, OfATinyFilmAreRefusedByItsSize) {
    const ScratchFolder folder;
    folder.write("a.toml", a_talk);
    const ProgramRun done = run_program_in(folder, "render a.toml -q --slides w --size 60x34");
    EXPECT_EQ(done.code, 2);
    EXPECT_TRUE(
        contains(done.err, "film.size: a film of slides is at least 63 pixels wide, this one 60"))
        << done.err;
    EXPECT_FALSE(contains(done.err, "--dpi")) << done.err;
}

}  // namespace
}  // namespace poinsot::testing
