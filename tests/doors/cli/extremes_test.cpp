// The extremes on the command line: every row of the list is a named case with its expected result.
// The accuracy of each motion is tested in mechanics/extremes_test.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program_run.h"
#include "image/files/png_files.h"

namespace poinsot::testing::extremes_tests {
namespace {

std::string body(const std::string& moments, const std::string& omega,
                 const std::string& more = "") {
    return "[body]\nmoments_kg_m2 = " + moments + "\n" + more + "[start]\nomega_rad_s = " + omega +
           "\n[film]\nduration_s = 0.1\nsize = [64, 36]\n";
}

std::string tensor(const std::string& rows) {
    return "[body]\ntensor_kg_m2 = " + rows +
           "\n[start]\nomega_rad_s = [0.3, 1.0, 0.2]\n[film]\nduration_s = 0.1\nsize = [64, 36]\n";
}

std::string masses(const std::vector<std::string>& places, const std::string& mass = "1.0") {
    std::string text =
        "[start]\nomega_rad_s = [0.3, 1.0, 0.2]\n[film]\nduration_s = 0.1\n"
        "size = [64, 36]\n";
    for (const std::string& place : places) {
        text += "[[body.masses]]\nmass_kg = " + mass + "\nat_m = " + place + "\n";
    }
    return text;
}

std::string attitude(const std::string& line) {
    return "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.5]\n[start]\nomega_rad_s = [0.3, 1.0, 0.2]\n" +
           line + "\n[film]\nduration_s = 0.1\nsize = [64, 36]\n";
}

std::string top(const std::string& start, const std::string& mgl = "1.0",
                const std::string& moments = "[1.0, 1.0, 0.5]") {
    return "[body]\nmoments_kg_m2 = " + moments +
           "\n[torque]\nkind = \"gravity\"\nmgl_N_m = " + mgl + "\n[start]\n" + start +
           "\n[film]\nduration_s = 0.1\nsize = [64, 36]\n";
}

struct Extreme {
    std::string name;
    std::string scene;
    std::string command;  // "check", or "sample" with its times
    int code;
    std::string says;  // part of the output, on either stream
};

void PrintTo(const Extreme& extreme, std::ostream* out) { *out << extreme.name; }

class ExtremeInput : public ::testing::TestWithParam<Extreme> {};

TEST_P(ExtremeInput, IsCorrectOrRefusedByName) {
    const Extreme& extreme = GetParam();
    const ScratchFolder folder;
    folder.write("scene.toml", extreme.scene);
    std::string command = extreme.command;
    command.insert(std::min(command.find(' '), command.size()), " scene.toml");
    const ProgramRun run = run_program_in(folder, command);
    EXPECT_EQ(run.code, extreme.code) << run.out << run.err;
    EXPECT_NE((run.out + run.err).find(extreme.says), std::string::npos) << run.out << run.err;
    EXPECT_EQ(run.out.find("nan"), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find("-inf"), std::string::npos) << run.out;
    if (extreme.code == 2) {
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
    }
}

const std::string generic = body("[1.0, 2.0, 2.5]", "[0.3, 1.0, 0.2]");
const std::string ulp_above_2 = "2.0000000000000004";

INSTANTIATE_TEST_SUITE_P(
    Motions, ExtremeInput,
    ::testing::Values(
        Extreme{"unsorted_axes_keep_their_order", body("[2.5, 1.0, 2.0]", "[0.2, 0.3, 1.0]"),
                "check", 0, "moments I₁, I₂, I₃: 2.5, 1, 2"},
        Extreme{"before_the_start", generic, "sample --times -7.5", 0, "-7.5,"},
        Extreme{"a_billion_periods", generic, "sample --times 24191973600", 0, "24191973600,"},
        Extreme{"1e15_seconds", generic, "sample --times 1e15", 0, "\n1000000000000000,"},
        Extreme{"middle_axis_within_1e_8", body("[1.0, 2.0, 3.0]", "[1e-8, 1.0, -1e-8]"), "check",
                0, "polhode about e"},
        Extreme{"middle_axis_within_1e_150", body("[1.0, 2.0, 3.0]", "[1e-150, 1.0, 1e-150]"),
                "check", 0, "polhode about e"},
        Extreme{"separatrix", body("[1.0, 2.0, 2.25]", "[0.75, 0.5, 1.0]"), "check", 0,
                "period of the polhode: infinite"},
        Extreme{"ulp_above_the_separatrix",
                body("[1.0, 2.0, 2.25]", "[0.7500000000000001, 0.5, 1.0]"), "check", 0,
                "about e1, the axis of the smallest moment"},
        Extreme{"ulp_below_the_separatrix",
                body("[1.0, 2.0, 2.25]", "[0.7499999999999999, 0.5, 1.0]"), "check", 0,
                "about e3, the axis of the largest moment"},
        Extreme{"separatrix_mirrored", body("[1.0, 2.0, 2.25]", "[-0.75, 0.5, 1.0]"), "check", 0,
                "separatrix"},
        Extreme{"oblate", body("[2.0, 2.0, 3.0]", "[0.5, 0.3, 1.0]"), "check", 0, "symmetric body"},
        Extreme{"prolate", body("[3.0, 3.0, 1.0]", "[0.5, 0.3, 1.0]"), "check", 0,
                "symmetric body"},
        Extreme{"an_ulp_from_oblate", body("[2.0, " + ulp_above_2 + ", 3.0]", "[0.5, 0.3, 1.0]"),
                "check", 0, "polhode about e3"},
        Extreme{"sphere", body("[2.0, 2.0, 2.0]", "[0.5, 0.3, 1.0]"), "check", 0,
                "permanent rotation"},
        Extreme{"ulps_from_a_sphere",
                body("[1.0, 1.0000000000000002, 1.0000000000000004]", "[0.5, 0.3, 1.0]"), "check",
                0, "every claim holds"},
        Extreme{"along_the_largest_axis", body("[1.0, 2.0, 2.5]", "[0.0, 0.0, 1.5]"), "check", 0,
                "herpolhode's radii: 0 … 0"},
        Extreme{"along_the_middle_axis", body("[1.0, 2.0, 2.5]", "[0.0, 1.5, 0.0]"), "check", 0,
                "unstable"},
        Extreme{"in_the_equator_of_a_symmetric_body", body("[2.0, 2.0, 3.0]", "[0.6, 0.8, 0.0]"),
                "check", 0, "herpolhode's radii: 0 … 0"},
        Extreme{"wobble_1e_8", body("[1.0, 2.0, 2.5]", "[1e-8, 2e-8, 1.0]"), "check", 0, "e-09"},
        Extreme{"wobble_1e_150", body("[1.0, 2.0, 2.5]", "[1e-150, 2e-150, 1.0]"), "check", 0,
                "e-151"},
        Extreme{"wobble_1e_300", body("[1.0, 2.0, 2.5]", "[1e-300, 2e-300, 1.0]"), "check", 0,
                "e-301"},
        Extreme{"subnormal_component", body("[1.0, 2.0, 2.5]", "[5e-324, 1.0, 5e-324]"),
                "sample --times 0,1e3", 0, "1000,"},
        Extreme{"needle", body("[1e-12, 1.0, 1.0]", "[0.3, 0.5, -0.2]"), "check", 0,
                "every claim holds"},
        Extreme{"needle_nearly_round", body("[1e-12, 1.0, 1.0000000000005]", "[0.3, 0.5, -0.2]"),
                "check", 0, "every claim holds"},
        Extreme{"lamina", body("[1.25, 2.75, 4.0]", "[0.7, 0.9, -0.35]"), "check", 0, "planar"},
        Extreme{"lamina_short_by_4_ulp",
                body("[1.25, 2.75, 3.9999999999999982]", "[0.7, 0.9, -0.35]"), "check", 0,
                "planar"},
        Extreme{"unphysical_kept",
                body("[1.0, 2.0, 3.5]", "[0.3, 0.5, -0.2]", "allow_unphysical = true\n"), "check",
                0, "every claim holds"},
        Extreme{"at_rest_bare_motion", body("[1.0, 2.0, 2.5]", "[0.0, 0.0, 0.0]"),
                "sample --times 5", 0, "5,0,0,0,1,0,0,0,0,0,0"},
        Extreme{"I_times_1e300", body("[1e300, 2e300, 2.5e300]", "[3e-301, 1e-300, 2e-301]"),
                "sample --times 0,1e300", 0, "\n1e+300,"},
        Extreme{"omega_times_1e150", body("[1.0, 2.0, 2.5]", "[3e149, 1e150, 2e149]"),
                "sample --times 0,1e-150", 0, "1e-150,"},
        Extreme{"I_times_1e_200", body("[1e-200, 2e-200, 2.5e-200]", "[0.3, 1.0, 0.2]"), "check", 0,
                "every claim holds"}),
    [](const auto& tested) { return tested.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Refusals, ExtremeInput,
    ::testing::Values(Extreme{"broken_triangle", body("[1.0, 2.0, 3.5]", "[0.3, 1.0, 0.2]"),
                              "check", 2, "moments_kg_m2"},
                      Extreme{"broken_triangle_by_1e24",
                              body("[1e-12, 1.0, 1e12]", "[0.3, 1.0, 0.2]"), "check", 2,
                              "moments_kg_m2"},
                      Extreme{"zero_moment", body("[0.0, 1.0, 1.0]", "[0.3, 1.0, 0.2]"), "check", 2,
                              "scene.toml:2:"},
                      Extreme{"negative_moment", body("[-1.0, 1.0, 1.0]", "[0.3, 1.0, 0.2]"),
                              "check", 2, "scene.toml:2:"},
                      Extreme{"nan_moment", body("[nan, 1.0, 1.0]", "[0.3, 1.0, 0.2]"), "check", 2,
                              "scene.toml:2:"},
                      Extreme{"infinite_moment", body("[inf, 1.0, 1.0]", "[0.3, 1.0, 0.2]"),
                              "check", 2, "scene.toml:2:"},
                      Extreme{"omega_nan", body("[1.0, 2.0, 2.5]", "[nan, 1.0, 0.2]"), "check", 2,
                              "scene.toml:4:"},
                      Extreme{"omega_infinite", body("[1.0, 2.0, 2.5]", "[0.3, inf, 0.2]"), "check",
                              2, "scene.toml:4:"},
                      Extreme{"at_rest_has_no_plane", body("[1.0, 2.0, 2.5]", "[0.0, 0.0, 0.0]"),
                              "check", 2, "no invariable plane"},
                      Extreme{"L_overflows", body("[1e300, 2e300, 2.5e300]", "[1e150, 0.0, 1e150]"),
                              "sample --times 0", 2, "overflows"},
                      Extreme{"turning_overflows", body("[1.0, 2.0, 2.5]", "[3e149, 1e150, 2e149]"),
                              "sample --times 1e200 --quiet", 2, "overflows"},
                      Extreme{"attitude_zero", attitude("attitude = [0.0, 0.0, 0.0, 0.0]"), "check",
                              2, "scene.toml:5:"},
                      Extreme{"attitude_improper",
                              attitude("attitude_matrix = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]"),
                              "check", 2, "scene.toml:5:"}),
    [](const auto& tested) { return tested.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Bodies, ExtremeInput,
    ::testing::Values(
        Extreme{"tensor_asymmetric_by_rounding",
                tensor("[[2.0, 0.1, 0.0], [0.10000000000000003, 2.0, 0.0], [0.0, 0.0, 2.0]]"),
                "check", 0, "note: "},
        Extreme{"tensor_asymmetric", tensor("[[2.0, 0.1, 0.0], [0.2, 2.0, 0.0], [0.0, 0.0, 2.0]]"),
                "check", 2, "tensor_kg_m2"},
        Extreme{"tensor_indefinite", tensor("[[1.0, 2.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]]"),
                "check", 2, "-1"},
        Extreme{"tensor_of_equal_moments",
                tensor("[[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]"), "check", 0,
                "I₃: 2, 2, 2"},
        Extreme{"tensor_diagonal", tensor("[[1.1, 0.0, 0.0], [0.0, 2.3, 0.0], [0.0, 0.0, 1.7]]"),
                "check", 0, "I₃: 1.1, 2.3, 1.7"},
        Extreme{"one_mass", masses({"[1.0, 0.0, 0.0]"}), "check", 2, "scene.toml:"},
        Extreme{"collinear_masses", masses({"[1, 0, 0]", "[-1, 0, 0]", "[2, 0, 0]"}), "check", 2,
                "scene.toml:"},
        Extreme{"coplanar_masses", masses({"[0, 0, 0]", "[1, 0, 0]", "[0, 2, 0]"}), "check", 0,
                "planar"},
        Extreme{"massless_mass", masses({"[0, 0, 0]", "[1, 0, 0]", "[0, 2, 0]"}, "0.0"), "check", 2,
                "mass_kg"},
        Extreme{"masses_far_away",
                masses({"[100000000, 0, 0]", "[100000001, 0, 0]", "[100000000, 2, 0]"}), "check", 0,
                "planar"},
        Extreme{"attitude_of_length_2", attitude("attitude = [2.0, 0.0, 0.0, 0.0]"), "check", 0,
                "note: "}),
    [](const auto& tested) { return tested.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Tops, ExtremeInput,
    ::testing::Values(Extreme{"upright", top("theta_rad = 0.0\nomega3_rad_s = 8.0"),
                              "sample --times 0,3", 0, "\n3,"},
                      Extreme{"upright_within_1e_100",
                              top("theta_rad = 1e-100\nomega3_rad_s = 8.0"), "sample --times 0,3",
                              0, "\n3,"},
                      // (Cω₃)² = 4A·Mgl
                      Extreme{"critical_spin", top("theta_rad = 0.0\nomega3_rad_s = 4.0"),
                              "sample --times 0,30", 0, "\n30,"},
                      Extreme{"cusp", top("theta_rad = 0.7\nomega3_rad_s = 8.0"),
                              "sample --times 0,3", 0, "\n3,"},
                      Extreme{"looping",
                              top("theta_rad = 0.7\nphi_dot_rad_s = -0.5\nomega3_rad_s = 8.0"),
                              "sample --times 0,3", 0, "\n3,"},
                      Extreme{"no_spin", top("theta_rad = 0.7\nomega3_rad_s = 0.0"),
                              "sample --times 0,3", 0, "\n3,"},
                      Extreme{"through_the_vertical", top("theta_rad = 0.0\ntheta_dot_rad_s = 1.0"),
                              "sample --times 0,3", 0, "\n3,"},
                      Extreme{"hanging_weight", top("theta_rad = 0.7\nomega3_rad_s = 8.0", "-1.0"),
                              "sample --times 0,3", 0, "\n3,"},
                      Extreme{"weightless", top("theta_rad = 0.7\nomega3_rad_s = 8.0", "0.0"),
                              "sample --times 0,3", 0, "\n3,"},
                      Extreme{"asymmetric_top",
                              top("theta_rad = 0.7\nomega3_rad_s = 8.0", "1.0", "[1.0, 1.2, 0.5]"),
                              "check", 2, "set motion.method to one of euler, rk4"}),
    [](const auto& tested) { return tested.param.name; });

// The camera is valid at every extreme: each picture contains a body.
class ExtremePicture : public ::testing::TestWithParam<Extreme> {};

TEST_P(ExtremePicture, ShowsABody) {
    const ScratchFolder folder;
    folder.write("scene.toml", GetParam().scene);
    const ProgramRun run = run_program_in(
        folder, "still scene.toml -o a.png --quiet --size 160x90 " + GetParam().command);
    ASSERT_EQ(run.code, 0) << run.err;
    const Image image = read_png(folder.path() / "a.png");
    int n_unlike_corner = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const Rgba8 a = image.at(x, y);
            const Rgba8 b = image.at(0, 0);
            n_unlike_corner += std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) > 60;
        }
    }
    EXPECT_GT(n_unlike_corner, 160 * 90 / 40);
}

INSTANTIATE_TEST_SUITE_P(
    Views, ExtremePicture,
    ::testing::Values(
        Extreme{"sphere", body("[2.0, 2.0, 2.0]", "[0.5, 0.3, 1.0]"), "", 0, ""},
        Extreme{"steady_spin", body("[1.0, 2.0, 2.5]", "[0.0, 0.0, 1.5]"), "", 0, ""},
        Extreme{"wobble_1e_300", body("[1.0, 2.0, 2.5]", "[1e-300, 2e-300, 1.0]"), "", 0, ""},
        Extreme{"subnormal", body("[1.0, 2.0, 2.5]", "[5e-324, 1.0, 5e-324]"), "", 0, ""},
        Extreme{"omega_times_1e150", body("[1.0, 2.0, 2.5]", "[3e149, 1e150, 2e149]"),
                "--set film.duration_s=1e-149 --set film.speed=1e-150", 0, ""},
        Extreme{"separatrix", body("[1.0, 2.0, 2.25]", "[0.75, 0.5, 1.0]"), "", 0, ""}),
    [](const auto& tested) { return tested.param.name; });

// Frame k of a film at 29.97/s is the instant k·1001/30000 s: its record contains the frames, and
// the picture is the still of that instant, but for names of curves and surfaces, which keep their
// sides in a film.
TEST(ExtremeInput, FrameTimesAreRatiosAt2997) {
    const ScratchFolder folder;
    folder.write("scene.toml", body("[1.0, 2.0, 2.5]", "[0.3, 1.0, 0.2]"));
    const std::string more =
        " --set film.fps=29.97 --set film.duration_s=20 --set 'show=[\"ellipsoid\"]' --set "
        "names=false --size 160x90";
    ASSERT_EQ(
        run_program_in(folder, "render scene.toml -o f-####.png --frames 500-500" + more).code, 0);
    // 500 · 1001/30000 s, as a double
    ASSERT_EQ(
        run_program_in(folder, "still scene.toml -o s.png --time 16.683333333333334" + more).code,
        0);
    EXPECT_TRUE(read_png(folder.path() / "f-0500.png") == read_png(folder.path() / "s.png"));
}

}  // namespace
}  // namespace poinsot::testing::extremes_tests
