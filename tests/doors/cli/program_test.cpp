// The command line: options, their values, help, and messages about mistyped words.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "cli/program_run.h"
#include "cli/small_scene.h"

namespace poinsot::testing {
namespace {

namespace fs = std::filesystem;

using CommandLine = Messages;

TEST(Program, PrintsVersionAndHelpOnStdout) {
    const ScratchFolder folder;
    const ProgramRun version = run_program_in(folder, "--version");
    EXPECT_EQ(version.code, 0);
    EXPECT_EQ(version.out.rfind("poinsot ", 0), 0u);
    const ProgramRun help = run_program_in(folder, "render --help");
    EXPECT_EQ(help.code, 0);
    EXPECT_NE(help.out.find("--frames"), std::string::npos);
}

TEST_F(CommandLine, AnUnknownOptionIsReportedWithTheNearest) {
    refuses("compare a b --max-difering 1", 2,
            {"unknown option \"--max-difering\"", "did you mean \"--max-differing\"?",
             "see poinsot compare --help"});
    refuses("compare a b --tolerance 1", 2, {"unknown option \"--tolerance\""});
    refuses("sample scene.toml --time 0", 2,
            {"unknown option \"--time\"", "did you mean \"--times\"?", "poinsot sample --help"});
    refuses("still scene.toml --colour", 2, {"unknown option \"--colour\""});
    refuses("still scene.toml --colour=red", 2, {"unknown option \"--colour\""});
    refuses("still scene.toml -x", 2, {"unknown option \"-x\""});
    refuses("check a.toml b.toml", 2, {"SCENE", "poinsot check --help"});
}

// The argument after an option with a value is its value, whatever it looks like.
TEST_F(CommandLine, AValueThatLooksLikeAnOptionIsAValue) {
    EXPECT_EQ(run("still scene.toml --time -0.1 -o a.png").code, 0);
    EXPECT_EQ(run("still scene.toml -ob.png").code, 0);
    EXPECT_EQ(run("still scene.toml --time=-0.1 -o ./-c.png").code, 0);
    EXPECT_EQ(run("sample scene.toml --times -1,2").code, 0);
    EXPECT_EQ(run("check -- scene.toml").code, 0);
    for (const char* name : {"a.png", "b.png", "-c.png"})
        EXPECT_TRUE(fs::exists(folder_.path() / name)) << name;
}

// The messages are sentences, not those of the library that parses the line.
TEST_F(CommandLine, AnInvalidCommandLineGetsAdvice) {
    for (const char* twice :
         {"still scene.toml -o a.png --output b.png", "still scene.toml --time 1 --time 2",
          "still scene.toml --theme light --theme=dark", "still scene.toml --dpi 9 --dpi 9",
          "still scene.toml --size 64x36 --size 64x36", "render scene.toml --fps 3 --fps 4",
          "render scene.toml --frames 0 --frames 1", "render scene.toml --jobs 1 --jobs 2",
          "submit scene.toml -o a.mp4 --parts 2 --parts 3", "sample scene.toml --times 1 --times 2",
          "check scene.toml --quality draft --quality print"})
        refuses(twice, 2, {"was given twice; give it once"});
    refuses("still scene.toml --size", 2, {"--size has no value; write --size WxH"});
    refuses("still scene.toml --frames", 2, {"unknown option"});
    refuses("render scene.toml --frames", 2, {"--frames has no value; write --frames A-B"});
    refuses("render scene.toml --fps --quiet", 2, {"--fps has no value; write --fps N[/D]"});
    refuses("still scene.toml -o", 2, {"--output has no value; write --output FILE"});
    refuses("still scene.toml --set", 2, {"--set has no value; write --set KEY=VALUE"});
    refuses("still", 2, {"poinsot still: SCENE is missing"});
    refuses("check scene.toml b.toml", 2, {"\"b.toml\" is one argument too many", "SCENE alone"});
    refuses("doctor please", 2, {"\"please\" is one argument too many; doctor takes none"});
    refuses("", 2, {"no command was given; choose from: render, still, check"});
    refuses("--size 3", 2, {"unknown option \"--size\""});
    // Options that may be repeated, and a switch that is given twice.
    EXPECT_EQ(run("check scene.toml --set film.fps=3 --set film.fps=4 -q -q").code, 0);
    EXPECT_EQ(run("check --help scene.toml b.toml").code, 0);
}

// A message begins with the typed option, not with the key that it sets.
TEST_F(CommandLine, AnOptionIsNamedAsItWasTyped) {
    for (const std::string typed : {"--size 5", "--fps x", "--quality drift", "--theme drak",
                                    "--set film.fps=x", "--sweep film.fps=x"}) {
        const ProgramRun done = run("render scene.toml -o a.mp4 " + typed);
        EXPECT_EQ(done.code, 2);
        EXPECT_EQ(done.err.rfind(typed + ": ", 0), 0u) << done.err;
        EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    }
}

// Such a value is refused where it is used, not where the file is read.
TEST_F(CommandLine, ErrorsOfSetNameSetNotTheFile) {
    for (const std::string given :
         {"panels=[{kind=\"foo\"}]", "panels=[{kind=\"space\"},{kind=\"foo\"}]",
          "panels=[{kind=\"plot\",quantity=\"foo\"}]", "show=[\"foo\"]",
          "fades=[{elements=[\"foo\"],at_s=0.1}]", "unlabelled=[\"foo\"]",
          "captions=[{text=\"$\",at_s=0}]"}) {
        const ProgramRun done = run("check scene.toml --set '" + given + "'");
        EXPECT_EQ(done.code, 2) << done.err;
        EXPECT_EQ(done.err.rfind("--set ", 0), 0u) << given << ": " << done.err;
        EXPECT_EQ(done.err.find("did you mean"), std::string::npos) << done.err;
    }
    folder_.write("panel.toml", scene + "[[panels]]\nkind = \"foo\"\n");
    refuses("check panel.toml", 2, {"panel.toml:10:1: unknown panel \"foo\"; choose from: "});
}

}  // namespace
}  // namespace poinsot::testing
