// list: every list has rows, is grouped and can be filtered.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "cli/program_run.h"
#include "cli/small_scene.h"
#include "places.h"

namespace poinsot::testing {
namespace {

using ListMessages = Messages;

TEST(List, EveryListHasRows) {
    const ScratchFolder folder;
    const ProgramRun lists = run_program_in(folder, "list");
    ASSERT_EQ(lists.code, 0);
    std::stringstream names(lists.out);
    int n_lists = 0;
    for (std::string name; std::getline(names, name); ++n_lists) {
        const ProgramRun rows = run_program_in(folder, "list " + name);
        EXPECT_EQ(rows.code, 0) << rows.err;
        EXPECT_NE(rows.out, "") << name;
    }
    EXPECT_GE(n_lists, 5);
    EXPECT_NE(lists.out.find("quantities\n"), std::string::npos);
}

// The scenes are found next to the program, not in the source folder.
TEST(List, FindsTheScenesOfAnInstalledProgram) {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder.path() / "bin");
    std::filesystem::create_directories(folder.path() / "share/poinsot/scenes");
    std::filesystem::copy_file(program_path(), folder.path() / "bin/poinsot");
    folder.write("share/poinsot/scenes/one.toml", racket);
    const auto list = [&folder] {
        const int status = std::system(
            ("cd '" + folder.path().string() + "' && bin/poinsot list scenes >out 2>err").c_str());
        return WEXITSTATUS(status);
    };
    EXPECT_EQ(list(), 0);
    EXPECT_EQ(text_of(folder.path() / "out"), "one  Racket\n");
    std::filesystem::remove_all(folder.path() / "share");
    EXPECT_EQ(list(), 3);
    const std::string err = text_of(folder.path() / "err");
    EXPECT_EQ(err.find("/scenes"), std::string::npos) << err;
    // The program does not contain the path of its source folder.
    const std::string program = text_of(program_path());
    const std::string checkout = (source_folder() / "scenes").string();
    EXPECT_EQ(program.find(checkout), std::string::npos);
}

TEST_F(ListMessages, ListsAreGroupedFilteredAndFolded) {
    const std::string all = run("list keys").out;
    // Blank lines separate tables: one for each change of table.
    EXPECT_NE(all.find("\n\nbody."), std::string::npos);
    const ProgramRun camera = run("list keys CAMERA");
    ASSERT_EQ(camera.code, 0) << camera.err;
    EXPECT_NE(camera.out.find("camera.azimuth_deg"), std::string::npos);
    EXPECT_EQ(camera.out.find("motion.step_s"), std::string::npos);
    EXPECT_LT(camera.out.size(), all.size() / 2);
    refuses("list keys xyzzy", 2, {"no entry contains \"xyzzy\"", "poinsot list keys"});
    const std::string overlays = run("list overlays").out;
    for (const char* name : {"title", "caption", "clock"})
        EXPECT_NE(overlays.find(name), std::string::npos);

    // On a terminal of 60 columns no line is longer; script provides a terminal.
    if (std::system("command -v script >/dev/null") != 0) GTEST_SKIP() << "no script(1)";
    const std::string typescript = (folder_.path() / "typescript").string();
    const std::string command = "script -qec \"stty cols 60; '" + program_path() +
                                "' list keys\" '" + typescript + "' >/dev/null";
    ASSERT_EQ(std::system(command.c_str()), 0);
    std::ifstream lines(typescript);
    std::size_t n_lines = 0;
    for (std::string line; std::getline(lines, line); ++n_lines) {
        if (line.starts_with("Script ")) continue;
        const auto n = std::count_if(line.begin(), line.end(),
                                     [](char c) { return (c & '\xC0') != '\x80' && c != '\r'; });
        EXPECT_LE(n, 60) << line;
    }
    EXPECT_GT(n_lines, 100u);
}

TEST(Qualities, ListTheirCostAndResult) {
    const ScratchFolder folder;
    const ProgramRun run = run_program_in(folder, "list qualities");
    ASSERT_EQ(run.code, 0);
    std::stringstream lines(run.out);
    int n_lines = 0;
    for (std::string line; std::getline(lines, line); ++n_lines) {
        for (const char* unit :
             {"curves within ", "accuracy_px", "picture: relative time ", ", rms error ",
              " of 255 levels; film frame of 960×540: relative time ", " kB, SSIM 0.9"}) {
            EXPECT_NE(line.find(unit), std::string::npos) << line;
        }
    }
    EXPECT_EQ(n_lines, 4);
    // Without times of a machine and without dates: `tradeoff` measures this machine.
    for (const char* dated : {" ms", " ns", "2026", "EPYC"})
        EXPECT_EQ((run.out + run.err).find(dated), std::string::npos) << run.out << run.err;
}

}  // namespace
}  // namespace poinsot::testing
