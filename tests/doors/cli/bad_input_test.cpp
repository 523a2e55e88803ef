// Bad input of every command: one clear line on stderr, the correct exit code, no output file, and
// no harm to the terminal. This is a property of all commands, not of one source file.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <regex>
#include <string>
#include <vector>

#include "cli/program_run.h"
#include "cli/recorded_pictures.h"
#include "cli/small_scene.h"
#include "text/utf8.h"

namespace poinsot::testing {
namespace {

namespace fs = std::filesystem;

using BadInputMessages = Messages;
using RefusedPictures = Pictures;

TEST_F(RefusedPictures, LeaveNoEmptyFolder) {
    for (const std::string options : {"--size 65x49", "--frames 0-99999"}) {
        EXPECT_EQ(run("render scene.toml " + options).code, 2) << options;
        EXPECT_FALSE(fs::exists(folder_.path() / "output")) << options;
    }
    EXPECT_EQ(run("still scene.toml --depth 9").code, 2);
    EXPECT_FALSE(fs::exists(folder_.path() / "output"));
    // An existing folder is kept.
    fs::create_directory(folder_.path() / "output");
    EXPECT_EQ(run("render scene.toml --size 65x49").code, 2);
    EXPECT_TRUE(fs::exists(folder_.path() / "output"));
    EXPECT_EQ(run("render scene.toml -q").code, 0);
    EXPECT_TRUE(fs::exists(folder_.path() / "output/scene.mp4"));
}

TEST_F(BadInputMessages, AFolderWithoutWritePermissionIsReported) {
    for (const char* command :
         {"still scene.toml -o /proc/a.png", "render scene.toml --frames 0-0 -o /proc/a.webm",
          "sample scene.toml --times 0 -o /proc/a.csv"})
        refuses(command, 3, {"the folder /proc cannot be written", "name another"});
    if (geteuid() == 0) return;  // root may write everywhere
    fs::create_directory(folder_.path() / "kept");
    fs::permissions(folder_.path() / "kept", fs::perms::owner_read | fs::perms::owner_exec);
    refuses("still scene.toml -o kept/a.png", 3, {"the folder kept cannot be written"});
}

TEST_F(BadInputMessages, ErrorsOfSizesAndQuantitiesHaveAPlace) {
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

const std::string good = R"(
[body]
moments_kg_m2 = [1.0, 2.0, 2.5]
[start]
omega_rad_s = [0.3, 1.0, 0.2]
)";

struct Case {
    std::string name;
    std::string scene;      // text of scene.toml; empty text is an empty file
    std::string arguments;  // of the command line, in the scratch folder
    int code;
    std::string says;  // part of the message
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class BadInput : public ::testing::TestWithParam<Case> {};

// Whether a message says what to do: in the imperative after the fault, or by the name that was
// meant. What the user typed, which messages quote, does not count.
bool advises(const std::string& message) {
    static const std::regex what_to_do(
        R"re((; |: |, or |, so |\()(add|choose|close|draw|end|enter|give|install|leave|make|name|put|remove|run|see|set|start|take|try|use|write)\b|did you mean "|the formats are|needs at least|" belongs in|poinsot( [a-z]+)? --help)re");
    return std::regex_search(std::regex_replace(message, std::regex(R"re(^[^:]*: )re"), ""),
                             what_to_do);
}

TEST_P(BadInput, GivesOneClearLineAndNoOutput) {
    const Case& c = GetParam();
    const ScratchFolder folder;
    folder.write("scene.toml", c.scene);
    const std::string before = folder.listing();
    const ProgramRun run = run_program_in(folder, c.arguments);
    EXPECT_EQ(run.code, c.code) << run.err;
    EXPECT_NE(run.err.find(c.says), std::string::npos) << run.err;
    EXPECT_TRUE(advises(run.err)) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(folder.listing(), before);
}

Case moments(const std::string& name, const std::string& value, const std::string& says) {
    return {name, "[body]\nmoments_kg_m2 = " + value + "\n[start]\nomega_rad_s = [0.3, 1.0, 0.2]\n",
            "still scene.toml -o a.png", 2, says};
}

Case body(const std::string& name, const std::string& lines, const std::string& says) {
    return {name, "[start]\nomega_rad_s = [0.3, 1.0, 0.2]\n[body]\n" + lines,
            "still scene.toml -o a.png", 2, says};
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, BadInput,
    ::testing::Values(
        Case{"missing_file", good, "still nowhere.toml -o a.png", 2, "nowhere.toml"},
        Case{"empty_file", "", "still scene.toml -o a.png", 2, "scene.toml"},
        Case{"directory", good, "still . -o a.png", 2, "folder"},
        Case{"binary",
             std::string("\x7f"
                         "ELF\x02\x01\0\0\0",
                         9),
             "still scene.toml -o a.png", 2, "scene.toml:1:1"},
        moments("zero_moment", "[0.0, 1.0, 1.0]", "scene.toml:2:"),
        moments("negative_moment", "[-1.0, 1.0, 1.0]", "scene.toml:2:"),
        moments("nan_moment", "[nan, 1.0, 1.0]", "scene.toml:2:"),
        moments("infinite_moment", "[inf, 1.0, 1.0]", "scene.toml:2:"),
        moments("broken_triangle", "[1.0, 2.0, 3.5]", "scene.toml:2:"),
        body("asymmetric_tensor",
             "tensor_kg_m2 = [[2.0, 0.1, 0.0], [0.2, 2.0, 0.0], [0.0, 0.0, 2.0]]\n",
             "scene.toml:4:"),
        body("one_mass", "[[body.masses]]\nmass_kg = 1.0\nat_m = [1.0, 0.0, 0.0]\n", "scene.toml:"),
        body("collinear_masses",
             "[[body.masses]]\nmass_kg = 1.0\nat_m = [1.0, 0.0, 0.0]\n"
             "[[body.masses]]\nmass_kg = 2.0\nat_m = [-1.0, 0.0, 0.0]\n",
             "scene.toml:"),
        Case{"zero_omega",
             "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.5]\n[start]\nomega_rad_s = [0.0, 0.0, 0.0]\n",
             "still scene.toml -o a.png", 2, "invariable plane"},
        Case{"unknown_key", good + "colour = 1\n", "still scene.toml -o a.png", 2,
             "scene.toml:6:1: unknown key"}),
    [](const auto& tested) { return tested.param.name; });

Case motion(const std::string& name, const std::string& lines, const std::string& says) {
    return {name, good + lines, "still scene.toml -o a.png", 2, says};
}

INSTANTIATE_TEST_SUITE_P(
    Methods, BadInput,
    ::testing::Values(
        motion("step_zero", "[motion]\nmethod = \"rk4\"\nstep_s = 0.0\n",
               "scene.toml:8:10: motion.step_s is 0; give a number greater than 0"),
        motion("step_negative", "[motion]\nmethod = \"rk4\"\nstep_s = -0.5\n", "scene.toml:8:10"),
        motion("step_longer_than_the_film", "[motion]\nmethod = \"rk4\"\nstep_s = 10.5\n",
               "scene.toml:8:1: step_s is 10.5 s, longer than the 10 s"),
        motion("tolerance_below_doubles", "[motion]\nmethod = \"dopri5\"\ntolerance = 1e-17\n",
               "give 1e-14 or more"),
        motion("exact_takes_no_step", "[motion]\nstep_s = 0.1\n",
               "method \"exact\" takes no step_s"),
        motion("exact_with_a_general_torque",
               "[torque]\nkind = \"constant_body\"\ntorque_body_N_m = [0.1, 0.0, 0.0]\n",
               "has no exact solution; set motion.method to one of euler, rk4, dopri5, rkmk4"),
        motion("asymmetric_top", "[torque]\nkind = \"gravity\"\nmgl_N_m = 1.0\n",
               "set motion.method to one of euler, rk4, dopri5, splitting, rkmk4"),
        motion("unknown_method", "[motion]\nmethod = \"rk5\"\n", "did you mean \"rk4\"?"),
        motion("beside_without_method", "[beside]\nstep_s = 0.1\n", "beside.method is missing"),
        motion("beside_unknown", "[beside]\nmethod = \"eler\"\n", "did you mean \"euler\"?"),
        motion("beside_step_too_long", "[beside]\nmethod = \"euler\"\nstep_s = 11.0\n",
               "longer than the 10 s"),
        motion("beside_that_cannot",
               "[motion]\nmethod = \"rk4\"\n[torque]\nkind = \"gravity\"\nmgl_N_m = 1.0\n"
               "[beside]\nmethod = \"dmv\"\n",
               "set beside.method to one of"),
        motion("keyframe_where_no_camera_moves",
               "[[keyframes]]\nat_s = 1.0\nelevation_deg = 50.0\n[[panels]]\nkind = \"plan\"\n",
               "scene.toml:6:1: keyframes[0] moves [camera], but no panel here uses [camera]"),
        Case{"beside_with_no_panel_for_it",
             "show = [\"plane\"]\n" + good +
                 "[beside]\nmethod = \"euler\"\n[[panels]]\nkind = \"space\"\n",
             "still scene.toml -o a.png", 2, "no panel here shows the comparison method"},
        Case{"panels_too_small",
             good +
                 "[grid]\ncolumns = [1.0, 0.01]\n[[panels]]\nkind = \"space\"\n[[panels]]\nkind = "
                 "\"body\"\ncolumn = 1\n",
             "still scene.toml -o a.png --size 320x180", 2, "scene.toml:10:1: panels[1] has 3x"}),
    [](const auto& tested) { return tested.param.name; });

INSTANTIATE_TEST_SUITE_P(
    CommandLines, BadInput,
    ::testing::Values(
        Case{"unwritable_output", good, "still scene.toml -o /proc/nowhere/a.png", 3,
             "/proc/nowhere"},
        Case{"missing_folder", good, "render scene.toml -o missing/a.mp4", 3, "missing"},
        Case{"unknown_extension", good, "render scene.toml -o a.xyz", 2, ".mp4"},
        Case{"fps_zero", good, "render scene.toml -o a.mp4 --fps 0", 2, "fps"},
        Case{"size_zero", good, "still scene.toml -o a.png --size 0x0", 2, "size"},
        Case{"size_huge", good, "still scene.toml -o a.png --size 100000x100000", 2, "size"},
        Case{"odd_film", good, "render scene.toml -o a.mp4 --size 321x240", 2, "321"},
        Case{"set_unknown_key", good, "still scene.toml -o a.png --set body.colour=1", 2, "colour"},
        Case{"set_without_value", good, "still scene.toml -o a.png --set body", 2, "body"},
        Case{"unknown_command", good, "rendr scene.toml", 2, "did you mean \"render\"?"},
        Case{"no_command", good, "", 2, "--help"},
        Case{"unknown_option", good, "still scene.toml --colour", 2, "--colour"},
        Case{"missing_scene", good, "still", 2, "SCENE"},
        Case{"frames_backwards", good, "render scene.toml -o a.mp4 --frames 9-3", 2,
             "--frames 9-3"},
        Case{"frames_beyond", good, "render scene.toml -o a.mp4 --frames 0-100000", 2, "--frames"},
        Case{"time_nan", good, "still scene.toml -o a.png --time nan", 2, "--time"},
        Case{"times_garbled", good, "sample scene.toml --times 0,x", 2, "--times"},
        Case{"unknown_list", good, "list theme", 2, "did you mean \"themes\"?"},
        Case{"unknown_backend", good, "still scene.toml -o a.png --backend x", 2, "--backend"},
        Case{"unknown_theme", good, "still scene.toml -o a.png --set theme=x", 2, "theme"},
        Case{"unknown_element", good, "still scene.toml -o a.png --set 'show=[\"plan\"]'", 2,
             "plan"},
        Case{"still_not_png", good, "still scene.toml -o a.jpg", 2, ".png"}),
    [](const auto& tested) { return tested.param.name; });

Case value(const std::string& name, const std::string& arguments, const std::string& says) {
    return {name, good, arguments, 2, says};
}

// Invalid values with a valid beginning, and empty values, which are usually unset variables.
INSTANTIATE_TEST_SUITE_P(
    Values, BadInput,
    ::testing::Values(
        value("frames_open", "render scene.toml -o a.md5 --frames 0-", "--frames 0-"),
        value("frames_letter", "render scene.toml -o a.md5 --frames 0-x", "--frames 0-x"),
        value("frames_comma", "render scene.toml -o a.md5 --frames 0,5", "--frames 0,5"),
        value("frames_point", "render scene.toml -o a.md5 --frames 1.5", "--frames 1.5"),
        value("frames_tail", "render scene.toml -o a.md5 --frames 3abc", "--frames 3abc"),
        value("frames_space", "render scene.toml -o a.md5 --frames ' 0-1'", "--frames  0-1"),
        value("frames_empty", "render scene.toml -o a.md5 --frames ''", "--frames"),
        value("frames_huge", "render scene.toml -o a.md5 --frames 0-99999999999999999999",
              "--frames"),
        value("time_empty", "still scene.toml -o a.png --time ''", "--time"),
        value("time_tail", "still scene.toml -o a.png --time 1s", "--time: \"1s\""),
        value("time_comma", "still scene.toml -o a.png --time 1,5", "--time: \"1,5\""),
        value("time_hexadecimal", "still scene.toml -o a.png --time 0x1p3", "--time: \"0x1p3\""),
        value("time_infinite", "still scene.toml -o a.png --time 1e999", "--time: \"1e999\""),
        value("dpi_empty", "still scene.toml -o a.png --dpi ''", "--dpi"),
        value("dpi_tail", "still scene.toml -o a.png --dpi 300dpi", "--dpi: \"300dpi\""),
        value("width_unit", "still scene.toml -o a.png --width-mm 86mm", "--width-mm: \"86mm\""),
        value("depth_empty", "still scene.toml -o a.png --depth ''", "--depth"),
        value("depth_tail", "still scene.toml -o a.png --depth 8bit", "--depth: \"8bit\""),
        value("depth_point", "still scene.toml -o a.png --depth 8.0", "--depth: \"8.0\""),
        value("depth_octal", "still scene.toml -o a.png --depth 020", "--depth 20"),
        value("output_empty", "still scene.toml -o ''", "--output"),
        value("size_empty", "still scene.toml -o a.png --size ''", "--size"),
        value("size_tail", "still scene.toml -o a.png --size 64x36px", "film.size"),
        value("size_three", "still scene.toml -o a.png --size 64x36x2", "film.size"),
        value("fps_empty", "render scene.toml -o a.md5 --fps ''", "--fps"),
        value("fps_tail", "render scene.toml -o a.md5 --fps 30fps", "film.fps"),
        value("fps_open", "render scene.toml -o a.md5 --fps 30/", "film.fps"),
        value("quality_empty", "still scene.toml -o a.png --quality ''", "--quality"),
        value("backend_empty", "still scene.toml -o a.png --backend ''", "--backend"),
        value("times_space", "sample scene.toml --times '0, 1'", "--times: \" 1\""),
        value("times_open", "sample scene.toml --times 0,", "--times: \"\""),
        value("times_hexadecimal", "sample scene.toml --times 0x10", "--times: \"0x10\""),
        value("levels_tail", "compare scene.toml scene.toml --over-levels 2.5",
              "--over-levels: \"2.5\""),
        value("share_tail", "compare scene.toml scene.toml --max-over 1%%", "--max-over 1%%"),
        value("share_empty", "compare scene.toml scene.toml --max-over ''", "--max-over"),
        value("diff_empty", "compare scene.toml scene.toml --diff ''", "--diff"),
        value("report_empty", "compare scene.toml scene.toml --report ''", "--report"),
        value("results_empty", "approve --all --results '' --baselines b", "--results"),
        value("set_empty", "still scene.toml -o a.png --set ''", "--set"),
        value("scene_empty", "still '' -o a.png", "no such file")),
    [](const auto& tested) { return tested.param.name; });

// Titles, keys and names may contain control characters for a terminal; no command prints them raw.
TEST(TerminalEscapes, AreNotPrinted) {
    const ScratchFolder folder;
    folder.write("title.toml", "title = \"a\\u001b]0;owned\\u0007\\u009b31m\"\n" + good);
    folder.write("key.toml", good + "\"\\u001b[31m\" = 1\n");
    folder.write("raw.toml", "title = \"\x1b[31m\"\n" + good);
    const std::string name = "\x1b[31mscene.toml";
    folder.write(name, good + "x = 1\n");
    for (const std::string arguments :
         {"check title.toml", "check title.toml --json", "check title.toml --plan",
          "still title.toml --size 96x54 -o a.png", "explain a.png", "check key.toml",
          "check raw.toml", "check '\x1b[31mscene.toml'", "still title.toml -o '\x1b[31m/a.png'",
          "still title.toml --set 'theme=\x1b[31m'", "recover '\x1b[31m.mp4'",
          "check '\u009b31m.toml'", "compare '\x1b[31m' a.png",
          "render title.toml -o '\x1b[31m.xyz'", "list '\x1b[31m'", "'\x1b[31m'",
          "still title.toml '--\x1b[31m'"}) {
        const ProgramRun run = run_program_in(folder, arguments);
        for (const std::string& text : {run.out, run.err}) {
            EXPECT_EQ(text.find('\x1b'), std::string::npos) << arguments;
            EXPECT_EQ(text.find('\x07'), std::string::npos) << arguments;
            EXPECT_EQ(text.find("\xc2\x9b"), std::string::npos) << arguments;  // CSI in UTF-8
        }
    }
}

// A motion that cannot be computed is refused at the key that causes it.
TEST(Extremes, AreRefusedWithFileLineAndKey) {
    const ScratchFolder folder;
    const std::string scene = "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.5]\n[start]\nomega_rad_s = ";
    folder.write("huge.toml", scene + "[1e308, 1e308, 1e308]\n");
    folder.write("late.toml", scene + "[1e3, 1.0, 0.2]\n[film]\nstill_s = 1e308\n");
    folder.write("start.toml", scene + "[1e300, 1.0, 0.2]\n[film]\nstart_s = 1e308\n");
    for (const char* command : {"check", "still -o a.png", "sample --times 0", "render -o a.md5"}) {
        const ProgramRun run = run_program_in(folder, std::string(command) + " huge.toml");
        EXPECT_EQ(run.code, 2) << command;
        EXPECT_EQ(run.err.find("huge.toml:4:1: omega_rad_s: "), 0u) << command << ": " << run.err;
    }
    const ProgramRun late = run_program_in(folder, "still late.toml -o a.png");
    EXPECT_EQ(late.code, 2);
    EXPECT_EQ(late.err.find("late.toml:6:1: time_s: "), 0u) << late.err;
    for (const char* command : {"check", "render -o a.md5"}) {
        const ProgramRun start = run_program_in(folder, std::string(command) + " start.toml");
        EXPECT_EQ(start.code, 2) << command;
        EXPECT_EQ(start.err.find("start.toml:5:"), 0u) << command << ": " << start.err;
    }
    folder.write("scene.toml", good);
    const ProgramRun time = run_program_in(folder, "still scene.toml -o a.png --time 1e308");
    EXPECT_EQ(time.code, 2);
    EXPECT_EQ(time.err.find("--time 1e+308: "), 0u) << time.err;
    const ProgramRun times = run_program_in(folder, "sample scene.toml --times 0,1e308");
    EXPECT_EQ(times.code, 2);
    EXPECT_EQ(times.err.find("--times 1e+308: "), 0u) << times.err;
    // The smallest doubles are accepted.
    folder.write("least.toml", scene + "[5e-324, 0.0, 5e-324]\n[film]\nsize = [64, 36]\n");
    for (const char* command :
         {"check", "still -o a.png", "sample --times 0", "render -o a.md5 --frames 0"})
        EXPECT_EQ(run_program_in(folder, std::string(command) + " -q least.toml").code, 0)
            << command;
}

TEST(Extremes, OfTheCameraAreRefused) {
    const ScratchFolder folder;
    folder.write("scene.toml", good + "[camera]\ntarget = [1e308, 0.0, 0.0]\n");
    folder.write("told.toml", good + "[[keyframes]]\nat_s = 1.0\ntarget = [0.0, -1e9, 0.0]\n");
    for (const char* name :
         {"scene.toml:7:11: camera.target[0]", "told.toml:8:16: keyframes[0].target[1]"}) {
        const std::string file = std::string(name).substr(0, std::string(name).find(':'));
        const ProgramRun run = run_program_in(folder, "still " + file + " -o a.png");
        EXPECT_EQ(run.code, 2);
        EXPECT_EQ(run.err.find(name), 0u) << run.err;
    }
}

// Without a check, a pipe without a writer would block, and a device has no end.
TEST(BadFile, IsRefusedAtOnceInEveryOption) {
    const ScratchFolder folder;
    folder.write("scene.toml", good);
    for (const char* name : {"pipe.toml", "pipe.png", "pipe.mp4", "pipe.obj"})
        ASSERT_EQ(mkfifo((folder.path() / name).c_str(), 0600), 0);
    for (const char* name : {"folder.toml", "folder.png", "folder.mp4", "folder.obj"})
        std::filesystem::create_directory(folder.path() / name);
    for (const char* name : {"circle.toml", "circle.png", "circle.mp4", "circle.obj"})
        std::filesystem::create_symlink(name, folder.path() / name);
    for (const char* name : {"device.toml", "device.png", "device.mp4", "device.obj"})
        std::filesystem::create_symlink("/dev/zero", folder.path() / name);
    ASSERT_EQ(run_program_in(folder, "still scene.toml --size 64x36 -q -o good.png").code, 0);

    for (const std::string kind : {"pipe", "folder", "circle", "device"}) {
        for (const std::string& command :
             {"check " + kind + ".toml", "still " + kind + ".toml -o a.png",
              "render " + kind + ".toml -o a.md5", "sample " + kind + ".toml --times 0",
              "explain " + kind + ".png", "explain " + kind + ".mp4",
              "rerender " + kind + ".png -o a.png", "rerender " + kind + ".mp4 -o a.mp4",
              "compare " + kind + ".png good.png", "compare good.png " + kind + ".png",
              "check scene.toml --set object.mesh=" + kind + ".obj"}) {
            const ProgramRun run = run_program_in(folder, command, "timeout 20");
            EXPECT_EQ(run.code, 2) << command << ": " << run.err;
            EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
            EXPECT_NE(run.err.find(kind), std::string::npos) << run.err;
            EXPECT_EQ(run.err.find("did you mean"), std::string::npos) << run.err;
        }
    }
}

// The same for files that a command finds next to its input.
TEST(BadFile, DoesNotBlockWhenACommandFindsItItself) {
    const ScratchFolder folder;
    folder.write("scene.toml", good);
    const auto pipe = [&folder](const std::string& name) {
        std::filesystem::create_directories((folder.path() / name).parent_path());
        ASSERT_EQ(mkfifo((folder.path() / name).c_str(), 0600), 0);
    };
    const std::string film = "render scene.toml --size 64x36 --frames 0-3 -q -o ";
    ASSERT_EQ(run_program_in(folder, film + "1.mp4 --part 1/1").code, 0);
    ASSERT_EQ(run_program_in(folder, "still scene.toml --size 64x36 -q -o good.png").code, 0);
    std::filesystem::create_directory(folder.path() / "new");
    std::filesystem::copy(folder.path() / "good.png", folder.path() / "new/good.png");
    for (const char* name :
         {"pipe.mp4", "pipe.png", "pipe.toml", "pipe.tex", "pipe.svg", "list.job/films",
          "log.job/logs/a.1.log", "site/poinsot/slurm.options", "baselines/manifest.toml",
          ".taken.mp4.part.frames", ".taken.mp4.part", ".taken.png.part", ".taken.csv.part"})
        pipe(name);
    folder.write("log.job/films", "a\t1\ta.mp4\thash\n");
    std::filesystem::create_directory(folder.path() / "log.job/state");
    folder.write("log.job/state/a.1.failed", "");

    struct Refusal {
        std::string command, says;
        int code = 2;
    };
    const std::string no_file = "a pipe or a device, not a regular file";
    const std::string in_the_way = "exists and is not unfinished work of poinsot";
    for (const Refusal& refusal : {
             Refusal{"join pipe.mp4 -o f.mp4", "pipe.mp4: " + no_file},
             {"join 1.mp4 pipe.mp4 -o f.mp4", "pipe.mp4: " + no_file},
             {"join pipe.png -o 'f_####.png'", "pipe.png: " + no_file},
             {"status list.job", "films: " + no_file},
             {"status log.job", "a.1.log: " + no_file},
             {"explain pipe.svg", "pipe.svg: " + no_file},
             {"compare pipe.svg pipe.svg", "pipe.svg"},
             {"still scene.toml -o a.png --theme pipe.toml", no_file},
             {"check scene.toml --set 'object.pictures=[{face=\"+e1\", file=\"pipe.png\"}]'",
              no_file},
             {"still scene.toml -o pipe.pdf --text latex", "exists and is not as poinsot wrote it"},
             {"compare baselines new", "manifest.toml: " + no_file},
             {"approve good --results new --baselines baselines", "manifest.toml: " + no_file},
             {film + "taken.mp4", in_the_way, 3},
             {"recover taken.mp4", "", 3},
             {"still scene.toml --size 64x36 -q -o taken.png", in_the_way, 3},
             {"sample scene.toml --times 0 -o taken.csv", in_the_way, 3},
         }) {
        const ProgramRun run =
            run_program_in(folder, refusal.command, "XDG_CONFIG_HOME=$PWD/site timeout 20");
        EXPECT_EQ(run.code, refusal.code) << refusal.command << ": " << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        EXPECT_NE(run.err.find(refusal.says), std::string::npos)
            << refusal.command << ": " << run.err;
    }
    // A file that is only tested for existence is left unchanged.
    pipe("f.chapters.json");
    pipe("f.vtt");
    const ProgramRun made = run_program_in(folder, film + "f.mp4", "timeout 60");
    EXPECT_EQ(made.code, 0) << made.err;
    EXPECT_TRUE(std::filesystem::is_fifo(folder.path() / "f.vtt"));
}

// A signal ends the wait for a reader. After another minute `timeout` would kill the program, with
// exit code 137.
TEST(OutputPipe, WithoutAReaderEndsWhenInterrupted) {
    const ScratchFolder folder;
    folder.write("scene.toml", good);
    ASSERT_EQ(mkfifo((folder.path() / "a.png").c_str(), 0600), 0);
    const ProgramRun run =
        run_program_in(folder, "still scene.toml --size 64x36 -q -o a.png", "timeout -k 60 3");
    EXPECT_EQ(run.code, 124) << run.err;
}

// A pipe of instants is valid input: the output of a program can be passed on to this one.
TEST(TimesFile, MayBeAPipe) {
    const ScratchFolder folder;
    folder.write("scene.toml", good);
    const std::string runner = "mkfifo times && (echo 1 >times &) && timeout 60";
    const ProgramRun run = run_program_in(folder, "sample scene.toml --times-file times", runner);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("\n1,"), std::string::npos) << run.out;
}

TEST(BadFile, InAFolderIsUnreadableAndOtherPicturesAreCompared) {
    const ScratchFolder folder;
    folder.write("scene.toml", good);
    for (const char* name : {"old", "new"}) {
        std::filesystem::create_directory(folder.path() / name);
        ASSERT_EQ(run_program_in(folder, std::string("still scene.toml --size 64x36 -q -o ") +
                                             name + "/good.png")
                      .code,
                  0);
        ASSERT_EQ(mkfifo((folder.path() / name / "pipe.png").c_str(), 0600), 0);
        std::filesystem::create_symlink("circle.png", folder.path() / name / "circle.png");
    }
    const ProgramRun run = run_program_in(folder, "compare old new -q", "timeout 20");
    EXPECT_EQ(run.code, 1) << run.err;
    EXPECT_NE(run.out.find("unreadable: pipe"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("unreadable: circle"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("3 compared, 2 failed, 1 the same"), std::string::npos) << run.out;
}

// Names that are not UTF-8, change the direction of writing or hide a character, and long names.
TEST(TerminalEscapes, AndOtherUnsafeNamesAreNotPrinted) {
    const ScratchFolder folder;
    folder.write("scene.toml", good);
    const std::string hostile = "a\xff\u202egpj\u200b\u2066";
    folder.write(hostile + ".toml", good);
    folder.write("title.toml", "title = \"x\u202ey\u200bz\"\n" + good);
    ASSERT_EQ(run_program_in(folder, "still scene.toml --size 64x36 -q -o good.png").code, 0);
    for (const char* name : {"old", "new"}) {
        std::filesystem::create_directory(folder.path() / name);
        std::filesystem::copy_file(folder.path() / "good.png",
                                   folder.path() / name / (hostile + ".png"));
    }
    const std::string quoted = "'" + hostile + "'", file = "'" + hostile + ".toml'";
    const std::string long_name = std::string(100'000, 'x');
    const std::vector<std::string> commands{
        "check " + file,
        "check " + file + " --json",
        "check title.toml",
        std::string("check title.toml --json"),
        "still " + file + " -o " + quoted,
        "still " + file + " --size 64x36 -o '" + hostile + ".png'",
        "explain '" + hostile + ".png'",
        "explain '" + hostile + ".png' --json",
        "compare " + quoted + " good.png",
        std::string("compare old new --json"),
        "compare good.png '" + hostile + ".png'",
        "render " + file + " --frames 0 -o a.md5",
        "list " + quoted,
        quoted,
        "still scene.toml --backend " + quoted,
        "still scene.toml --set " + quoted + "=1",
        "still scene.toml --set title=" + quoted,
        "check scene.toml --set theme=" + quoted,
        "still scene.toml --" + quoted,
        "sample scene.toml --times " + quoted,
        "still scene.toml --dpi " + quoted,
        "check " + long_name,
        "still scene.toml --time " + long_name,
        "check scene.toml --set " + long_name + "=1",
        "list " + long_name,
        long_name,
        "still scene.toml -o " + long_name};
    for (const std::string& arguments : commands) {
        const ProgramRun run = run_program_in(folder, arguments);
        EXPECT_LE(run.err.size(), 20'000u) << arguments.substr(0, 100);
        for (const std::string& text : {run.out, run.err})
            for (std::string_view rest = text; !rest.empty();) {
                const Utf8Character character = first_character(rest);
                ASSERT_TRUE(character.valid) << arguments.substr(0, 100) << ": " << text;
                ASSERT_TRUE(character.code == '\n' || !is_hidden(character.code))
                    << arguments.substr(0, 100) << ": " << text;
                rest.remove_prefix(character.size);
            }
    }
}

// The film exists: the command has succeeded.
TEST(FullDisk, ForMessagesDoesNotAffectTheFilm) {
    const ScratchFolder folder;
    folder.write("scene.toml", good);
    for (const std::string end : {"2>/dev/full", "2>&-"})
        for (const char* command :
             {"render scene.toml --size 64x36 --frames 0-2 -o a.mp4",
              "still scene.toml --size 64x36 -o a.png",
              "still scene.toml scene.toml --size 64x36 -o '##.png'", "rerender a.png -o b.png"}) {
            const ProgramRun run =
                run_program_in(folder, std::string(command) + " " + end + "; exit $?; true");
            EXPECT_EQ(run.code, 0) << command << end;
        }
    for (const char* name : {"a.mp4", "a.png", "01.png", "b.png"})
        EXPECT_TRUE(std::filesystem::exists(folder.path() / name)) << name;
}

// Like `yes | head -1`.
TEST(ClosedPipe, EndsTheProgramSilently) {
    const ScratchFolder folder;
    folder.write("scene.toml", good);
    std::string times = "0";
    for (int k = 1; k < 4000; ++k) times += "," + std::to_string(k % 10);
    for (const std::string& command :
         {"sample scene.toml --times " + times, std::string("list keys"),
          std::string("check scene.toml --json")}) {
        folder.write("run.sh", "'" + program_path() + "' " + command + " 2>said; echo $? >code\n");
        ASSERT_EQ(
            std::system(
                ("cd '" + folder.path().string() + "' && (sleep 0.2; sh run.sh) | true").c_str()),
            0);
        for (int k = 0; k < 100 && text_of(folder.path() / "code").empty(); ++k) usleep(50'000);
        EXPECT_EQ(text_of(folder.path() / "said"), "") << command;
        EXPECT_EQ(text_of(folder.path() / "code"), "141\n") << command;  // 128 + SIGPIPE
        std::filesystem::remove(folder.path() / "code");
    }
}

TEST(FullDisk, ForStdoutIsReported) {
    const ScratchFolder folder;
    folder.write("scene.toml", good);
    const ProgramRun run =
        run_program_in(folder, "sample scene.toml --times 0 >/dev/full 2>err.txt; exit $?; true");
    EXPECT_EQ(run.code, 3);
}

}  // namespace
}  // namespace poinsot::testing
