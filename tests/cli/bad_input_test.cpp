// Bad input: one clear line on stderr, the right exit code, nothing written.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>

#include "cli/program_run.h"

namespace poinsot::testing {
namespace {

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
    std::string says;  // part of the one line
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class BadInput : public ::testing::TestWithParam<Case> {};

TEST_P(BadInput, IsOneClearLineAndNothingWritten) {
    const Case& c = GetParam();
    const ScratchFolder folder;
    folder.write("scene.toml", c.scene);
    const std::string before = folder.listing();
    const ProgramRun run = run_program_in(folder, c.arguments);
    EXPECT_EQ(run.code, c.code) << run.err;
    EXPECT_NE(run.err.find(c.says), std::string::npos) << run.err;
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
               "the least that can be reached is 1e-14"),
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
        motion("beside_with_no_panel_for_it",
               "[beside]\nmethod = \"euler\"\n[[panels]]\nkind = \"plan\"\n",
               "no panel here shows a second motion"),
        motion("keyframe_where_no_camera_moves",
               "[[keyframes]]\nat_s = 1.0\nelevation_deg = 50.0\n[[panels]]\nkind = \"plan\"\n",
               "scene.toml:6:1: keyframes[0] moves the camera, but every panel here is seen from"),
        Case{"panels_too_small",
             good +
                 "[grid]\ncolumns = [1.0, 0.01]\n[[panels]]\nkind = \"space\"\n[[panels]]\nkind = "
                 "\"body\"\ncolumn = 1\n",
             "still scene.toml -o a.png --size 320x180", 2, "scene.toml:10:1: panels[1] gets 3x"}),
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

// A title, a key or a name may hold what a terminal would obey; no command gives it back raw.
TEST(TerminalEscapes, AreNotEchoed) {
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

TEST(FullDisk, StdoutIsReported) {
    const ScratchFolder folder;
    folder.write("scene.toml", good);
    const ProgramRun run =
        run_program_in(folder, "sample scene.toml --times 0 >/dev/full 2>err.txt; exit $?; true");
    EXPECT_EQ(run.code, 3);
}

}  // namespace
}  // namespace poinsot::testing
