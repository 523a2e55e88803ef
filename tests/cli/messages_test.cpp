// Messages for mistyped words, missing files and wrong names.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "cli/program_run.h"
#include "image/files/png_files.h"

namespace poinsot::testing::messages_tests {
namespace {

namespace fs = std::filesystem;

const std::string scene = R"(title = "Told"
[body]
moments_kg_m2 = [1.0, 2.0, 2.5]
[start]
omega_rad_s = [0.3, 1.0, 0.2]
[film]
size = [64, 48]
duration_s = 0.2
)";

class Messages : public ::testing::Test {
 protected:
    Messages() { folder_.write("scene.toml", scene); }

    ProgramRun run(const std::string& arguments) const {
        return run_program_in(folder_, arguments);
    }

    // One line on stderr with every part, the exit code, and no file.
    void refuses(const std::string& arguments, int code, const std::vector<std::string>& parts) {
        const std::string before = folder_.listing();
        const ProgramRun answer = run(arguments);
        EXPECT_EQ(answer.code, code) << arguments;
        EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
        for (const std::string& part : parts)
            EXPECT_NE(answer.err.find(part), std::string::npos) << arguments << ": " << answer.err;
        EXPECT_EQ(folder_.listing(), before) << arguments;
    }

    ScratchFolder folder_;
};

TEST_F(Messages, AnUnknownOptionIsReportedWithTheNearest) {
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
TEST_F(Messages, AValueThatLooksLikeAnOptionIsAValue) {
    EXPECT_EQ(run("still scene.toml --time -0.1 -o a.png").code, 0);
    EXPECT_EQ(run("still scene.toml -ob.png").code, 0);
    EXPECT_EQ(run("still scene.toml --time=-0.1 -o ./-c.png").code, 0);
    EXPECT_EQ(run("sample scene.toml --times -1,2").code, 0);
    EXPECT_EQ(run("check -- scene.toml").code, 0);
    for (const char* name : {"a.png", "b.png", "-c.png"})
        EXPECT_TRUE(fs::exists(folder_.path() / name)) << name;
}

TEST_F(Messages, ADifferentBaselineIsNotReplacedWithoutAReason) {
    fs::create_directory(folder_.path() / "new");
    fs::create_directory(folder_.path() / "ref");
    ASSERT_EQ(run("still scene.toml --portable -o new/a.png").code, 0);
    ASSERT_EQ(run("still scene.toml --portable --time 0 -o ref/a.png").code, 0);
    const std::string before = text_of(folder_.path() / "ref/a.png");
    // The manifest has no line for it.
    for (const char* what : {"a", "--all"}) {
        const ProgramRun refused =
            run(std::string("approve ") + what + " --results new --baselines ref");
        EXPECT_EQ(refused.code, 2);
        EXPECT_NE(refused.err.find("--why"), std::string::npos) << refused.err;
        EXPECT_EQ(text_of(folder_.path() / "ref/a.png"), before);
    }
    EXPECT_EQ(run("approve a --results new --baselines ref --why 'the other end'").code, 0);
    EXPECT_EQ(text_of(folder_.path() / "ref/a.png"), text_of(folder_.path() / "new/a.png"));
    // An equal picture or a new one needs no reason.
    fs::copy(folder_.path() / "new/a.png", folder_.path() / "new/b.png");
    EXPECT_EQ(run("approve --all --results new --baselines ref").code, 0);
}

TEST_F(Messages, LostTransparencyIsReported) {
    const auto said = [this](const std::string& theme, const std::string& output) {
        const ProgramRun made =
            run("render scene.toml --frames 0-0 --theme " + theme + " -o " + output);
        EXPECT_EQ(made.code, 0) << made.err;
        return made.err;
    };
    for (const char* theme : {"transparent", "transparent-dark"}) {
        EXPECT_NE(said(theme, "a.mp4").find(".mp4 has no transparency"), std::string::npos);
        EXPECT_NE(said(theme, "a.mp4").find(".webm and a .png sequence keep transparency"),
                  std::string::npos);
        EXPECT_NE(said(theme, "a.gif").find("a pixel of a GIF is either transparent or opaque"),
                  std::string::npos);
        EXPECT_EQ(said(theme, "a.webm").find("note"), std::string::npos);
        EXPECT_EQ(said(theme, "'a_####.png'").find("transparency"), std::string::npos);
    }
    EXPECT_EQ(said("light", "a.mp4").find("transparen"), std::string::npos);
}

TEST_F(Messages, AFolderWithoutWritePermissionIsReported) {
    for (const char* command :
         {"still scene.toml -o /proc/a.png", "render scene.toml --frames 0-0 -o /proc/a.webm",
          "sample scene.toml --times 0 -o /proc/a.csv"})
        refuses(command, 3, {"the folder /proc cannot be written", "name another"});
    if (geteuid() == 0) return;  // root may write everywhere
    fs::create_directory(folder_.path() / "kept");
    fs::permissions(folder_.path() / "kept", fs::perms::owner_read | fs::perms::owner_exec);
    refuses("still scene.toml -o kept/a.png", 3, {"the folder kept cannot be written"});
}

TEST_F(Messages, SuffixesAreCaseInsensitive) {
    ASSERT_EQ(run("render scene.toml --frames 0-1 -o a.mp4").code, 0);
    ASSERT_EQ(run("render scene.toml --frames 0-1 -o B.MP4").code, 0);
    EXPECT_EQ(text_of(folder_.path() / "a.mp4"), text_of(folder_.path() / "B.MP4"));
    ASSERT_EQ(run("still scene.toml -o A.PNG").code, 0);
    ASSERT_EQ(run("rerender A.PNG -o B.Png").code, 0);
    EXPECT_EQ(text_of(folder_.path() / "A.PNG"), text_of(folder_.path() / "B.Png"));
    EXPECT_EQ(run("explain B.MP4").code, 0);
    ASSERT_EQ(run("render scene.toml -q --frames 0-2 -o 'f_#.PNG'").code, 0);
    const ProgramRun joined = run("join 'f_#.PNG' -q -o 'g_#.PNG'");
    EXPECT_EQ(joined.code, 0) << joined.err;
    EXPECT_EQ(text_of(folder_.path() / "f_2.PNG"), text_of(folder_.path() / "g_2.PNG"));
}

TEST_F(Messages, AnUnsupportedRateIsReported) {
    refuses("render scene.toml --fps 60 -o a.gif", 2, {"--fps 60: ", "at most 50 frames a second"});
}

// A pipe has no random access: the file is complete without it.
TEST_F(Messages, AGifCanBeWrittenToAPipe) {
    const ProgramRun done =
        run_program_in(folder_, "render scene.toml -q -o p.gif && wait && cat got.gif | head -c 6",
                       "mkfifo p.gif && (cat p.gif >got.gif &) &&");
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(done.out, "GIF89a");
}

TEST_F(Messages, AnUnsupportedSuffixGetsTheNearestAlternative) {
    refuses("render scene.toml --size 20000x100 -o a.mp4", 2,
            {"film.size is 20000x100", "at most 16384 pixels per side"});
    refuses("render scene.toml -o a.mov", 2, {"\".mov\"", "write .mp4", "ffmpeg -i film.mp4"});
    refuses("render scene.toml -o a.mpg4", 2, {"did you mean \".mp4\"?"});
    refuses("render scene.toml -o a.avi", 2, {"write .mp4"});
    refuses("render scene.toml -o a.jpg", 2, {"write .png"});
    refuses("render scene.toml -o a.xyzzy", 2, {"the formats are .mp4, .webm, .gif"});
}

// A bare name means a supplied scene, or nearly one.
TEST_F(Messages, AMistypedSceneGetsTheNearestName) {
    refuses("check genric", 2, {"genric: no such file, and no scene", "did you mean \"generic\"?"});
    refuses("check scene", 2, {"did you mean \"scene.toml\"?"});
    refuses("check qqqqqqqqq", 2, {"qqqqqqqqq: no such file", "poinsot list scenes"});
    folder_.write("generic.toml", "not read");
    EXPECT_EQ(run("check generic").code, 0);
}

TEST_F(Messages, ErrorsOfSizesAndQuantitiesHaveAPlace) {
    folder_.write("odd.toml",
                  "film.size = [1, 2]\n[body]\nmoments_kg_m2 = [1.0, 2.0, 2.5]\n"
                  "[start]\nomega_rad_s = [0.3, 1.0, 0.2]\n");
    refuses("render odd.toml -o a.mp4", 2, {"odd.toml:1:6: an MP4 film needs an even width"});
    folder_.write("plot.toml", scene +
                                   "[[panels]]\nkind = \"space\"\n[[panels]]\nkind = "
                                   "\"plot\"\ncolumn = 1\n  quantity = \"omeg\"\n"
                                   "[grid]\ncolumns = [1, 1]\n");
    refuses("still plot.toml -o a.png", 2,
            {"plot.toml:14:3: unknown quantity \"omeg\"; did you mean \"omega\"?"});
}

TEST_F(Messages, AStillIsWrittenToStandardOutput) {
    ASSERT_EQ(run("still scene.toml -o a.png").code, 0);
    const ProgramRun printed = run("still scene.toml -o -");
    ASSERT_EQ(printed.code, 0) << printed.err;
    EXPECT_EQ(printed.out, text_of(folder_.path() / "a.png"));
    ASSERT_EQ(run("still scene.toml --depth 16 -o b.png").code, 0);
    EXPECT_EQ(run("still scene.toml --depth 16 -o -").out, text_of(folder_.path() / "b.png"));
    refuses("still scene.toml scene.toml -o -", 2, {"2 scenes need as many output names"});
    const std::string full = "cd '" + folder_.path().string() + "' && '" + program_path() +
                             "' still scene.toml -q -o - >/dev/full 2>/dev/null";
    EXPECT_EQ(WEXITSTATUS(std::system(full.c_str())), 3);
}

TEST_F(Messages, ListsAreGroupedFilteredAndFolded) {
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

// A camera key that no panel uses is reported.
TEST_F(Messages, ACameraKeyWithoutEffectIsNoted) {
    folder_.write("body.toml", scene + "[[panels]]\nkind = \"body\"\n");
    const ProgramRun idle = run("still body.toml --set camera.azimuth_deg=30 -o a.png");
    EXPECT_EQ(idle.code, 0);
    EXPECT_NE(idle.err.find("camera.azimuth_deg changes nothing"), std::string::npos) << idle.err;
    EXPECT_EQ(run("still body.toml -o b.png").err.find("changes nothing"), std::string::npos);
    EXPECT_EQ(run("still scene.toml --set camera.azimuth_deg=30 -o c.png").err.find("changes"),
              std::string::npos);
}

// The messages are sentences, not those of the library that parses the line.
TEST_F(Messages, AnInvalidCommandLineGetsAdvice) {
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
TEST_F(Messages, AnOptionIsNamedAsItWasTyped) {
    for (const std::string typed : {"--size 5", "--fps x", "--quality drift", "--theme drak",
                                    "--set film.fps=x", "--sweep film.fps=x"}) {
        const ProgramRun done = run("render scene.toml -o a.mp4 " + typed);
        EXPECT_EQ(done.code, 2);
        EXPECT_EQ(done.err.rfind(typed + ": ", 0), 0u) << done.err;
        EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    }
}

// Such a value is refused where it is used, not where the file is read.
TEST_F(Messages, ErrorsOfSetNameSetNotTheFile) {
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

TEST_F(Messages, CompareSaysWhatItNeeds) {
    refuses("compare a.png", 2,
            {"needs two pictures or two folders; one is given", "see poinsot compare --help"});
    refuses("compare", 2, {"needs two pictures or two folders; none is given"});
    refuses("compare a b c", 2, {"needs two pictures or two folders; 3 are given"});
}

// A picture of another program is no baseline, whatever renderer drew it.
TEST_F(Messages, APictureWithoutARecordIsNamedSo) {
    fs::create_directories(folder_.path() / "results");
    write_png(folder_.path() / "results/other.png", Image(4, 4));
    refuses("approve other --any-renderer --results results --baselines base", 2,
            {"results/other.png: has no record of how it was made", "draw it with poinsot"});
    refuses("explain results/other.png", 2, {"has no record of how it was made"});
}

// A billion seconds on, the herpolhode is a ring, said so and within the bound; a chart is refused.
TEST_F(Messages, FarTimesAreRingsOrRefused) {
    for (const char* output : {"a.png", "a.svg", "a.pdf"}) {
        const ProgramRun still = run(std::string("still scene.toml --time 1e9 -o ") + output);
        EXPECT_EQ(still.code, 0) << still.err;
        EXPECT_NE(still.err.find("note: the herpolhode has so many turns"), std::string::npos);
        const ProgramRun told = run(std::string("explain ") + output);
        EXPECT_NE(told.out.find("0.1 px asked); the herpolhode has so many turns"),
                  std::string::npos)
            << told.out;
        EXPECT_NE(told.out.find("within 0.05 px"), std::string::npos) << told.out;
    }
    const ProgramRun film =
        run("render scene.toml --set film.duration_s=0.1 "
            "--set film.speed=1e10 --set film.fps=30 -q -o a.mp4");
    EXPECT_EQ(film.code, 0) << film.err;
    folder_.write("chart.toml", scene + "[[panels]]\nkind = \"plot\"\n");
    refuses("still chart.toml --time 1e9 -o b.png", 2,
            {"chart.toml:6:2: ", "cannot be drawn within accuracy_px = 0.1",
             "set film.start_s nearer to the last instant shown"});
    EXPECT_EQ(run("still chart.toml --time 1e9 --set film.start_s=999999990 -o b.png").code, 0);
}

TEST_F(Messages, HelpHasExamples) {
    for (const char* command : {"render", "still", "check", "sample", "compare", "approve",
                                "explain", "rerender", "recover", "tradeoff", "list", "doctor"}) {
        const ProgramRun help = run(std::string(command) + " --help");
        EXPECT_EQ(help.code, 0);
        EXPECT_NE(help.out.find(std::string("poinsot ") + command + " "), std::string::npos)
            << help.out;
    }
}

}  // namespace
}  // namespace poinsot::testing::messages_tests
