// check: what it says about the motion, the plan, the bound in pixels and the certificate.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program_run.h"
#include "cli/small_scene.h"

namespace poinsot::testing {
namespace {

TEST(Check, NamesRegimeAndConstants) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const ProgramRun run = run_program_in(folder, "check scene.toml --json");
    ASSERT_EQ(run.code, 0) << run.err;
    // T = ½ Σ I ω² and the plane's distance √(2T)/L from the input by hand.
    const double twice_T = 3e-4 + 8.0 + 1e-4;
    const double L = std::sqrt(9e-4 + 16.0 + 1e-4);
    const auto number = [&run](const std::string& key) {
        const std::size_t at = run.out.find("\"" + key + "\": ");
        EXPECT_NE(at, std::string::npos) << run.out;
        return std::stod(run.out.substr(at + key.size() + 4));
    };
    EXPECT_NEAR(number("kinetic_energy_J"), 0.5 * twice_T, 1e-14);
    EXPECT_NEAR(number("momentum_kg_m2_s"), L, 1e-14);
    EXPECT_NEAR(number("plane_distance"), std::sqrt(twice_T) / L, 1e-15);
    EXPECT_EQ(number("n_frames"), 30.0);
}

const std::string generic = R"(
[body]
moments_kg_m2 = [1.0, 2.0, 2.5]
[start]
omega_rad_s = [0.3, 1.0, 0.2]
[film]
size = [320, 180]
duration_s = 2.0
)";

std::string output_of(const std::string& scene, const std::string& arguments) {
    const ScratchFolder folder;
    folder.write("scene.toml", scene);
    const ProgramRun run = run_program_in(folder, arguments);
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out;
}

// Returns the number after `key` in the JSON of check.
double number_of(const std::string& json, const std::string& key) {
    const std::size_t at = json.find("\"" + key + "\": ");
    EXPECT_NE(at, std::string::npos) << key << " in " << json;
    return at == std::string::npos ? -1.0 : std::stod(json.substr(at + key.size() + 4));
}

// A tensor says nothing of its principal axes: diag(4, 3, 1.5) turned by the angle with cosine 0.8
// about z has e1 = (0.8, 0.6, 0).
TEST(Check, NamesThePrincipalAxesOfATensor) {
    const std::string scene = R"(
[body]
tensor_kg_m2 = [[3.64, 0.48, 0.0], [0.48, 3.36, 0.0], [0.0, 0.0, 1.5]]
[start]
omega_rad_s = [0.3, 1.0, 0.2]
[film]
size = [320, 180]
duration_s = 2.0
)";
    const auto found = nlohmann::json::parse(output_of(scene, "check scene.toml --json"));
    const auto moments = found.at("moments_kg_m2").get<std::vector<double>>();
    const auto axes = found.at("principal_axes").get<std::vector<std::vector<double>>>();
    const std::vector<std::vector<double>> expected{{0.8, 0.6, 0.0}, {-0.6, 0.8, 0.0}, {0, 0, 1}};
    const std::vector<double> expected_moments{4.0, 3.0, 1.5};
    ASSERT_EQ(axes.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto same =
            static_cast<std::size_t>(std::min_element(moments.begin(), moments.end(),
                                                      [&](double a, double b) {
                                                          return std::abs(a - expected_moments[k]) <
                                                                 std::abs(b - expected_moments[k]);
                                                      }) -
                                     moments.begin());
        double along = 0.0, length = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            along += axes[i][same] * expected[k][i];
            length += axes[i][same] * axes[i][same];
        }
        EXPECT_NEAR(std::abs(along), 1.0, 1e-15);
        EXPECT_NEAR(length, 1.0, 1e-15);
    }
    EXPECT_NE(output_of(scene, "check scene.toml").find("\nprincipal axes: e1 = ("),
              std::string::npos);
    // Moments are given in principal axes.
    EXPECT_EQ(output_of(generic, "check scene.toml").find("principal axes"), std::string::npos);
}

// Returns the line of the plan with this beginning.
std::string plan_line(const std::string& out, const std::string& what) {
    std::stringstream lines(out);
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind(what + ": ", 0) == 0) return line;
    }
    return "";
}

TEST(Plan, GivesAReasonInEveryLine) {
    const std::string out = output_of(generic, "check scene.toml --plan");
    for (const char* what :
         {"motion", "torque", "angular velocity", "attitude", "herpolhode's point",
          "herpolhode's history", "Euler angles", "curves"}) {
        const std::string line = plan_line(out, what);
        const std::size_t reason = line.find('(');
        ASSERT_NE(reason, std::string::npos) << what << " in " << out;
        EXPECT_GT(line.find(')', reason), reason + 8) << line;
    }
}

TEST(Plan, FollowsTheScene) {
    const std::string sphere = output_of(generic,
                                         "check scene.toml --plan --set "
                                         "'body.moments_kg_m2=[2, 2, 2]'");
    EXPECT_NE(plan_line(sphere, "motion").find("no elliptic function"), std::string::npos);
    EXPECT_NE(plan_line(sphere, "herpolhode's history").find(": none ("), std::string::npos);

    const std::string body =
        output_of(generic + "[[panels]]\nkind = \"body\"\n", "check scene.toml --plan");
    EXPECT_NE(plan_line(body, "attitude").find(": none ("), std::string::npos);
    EXPECT_NE(plan_line(body, "torque").find(": none ("), std::string::npos);

    const std::string heavy = output_of(
        "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.5]\n[start]\nomega_rad_s = [0.3, 1.0, 0.2]\n"
        "[torque]\nkind = \"gravity\"\nmgl_N_m = 1.0\n[motion]\nmethod = \"rk4\"\nstep_s = 0.01\n",
        "check scene.toml --plan");
    // rk4 evaluates the torque four times in each step: 1000 steps of the film, and the steps of
    // the curves' last piece.
    int n_steps = 0, n_evaluations = 0;
    const std::string motion = plan_line(heavy, "motion");
    ASSERT_EQ(std::sscanf(motion.c_str() + motion.find("rk4: "), "rk4: %d steps, %d evaluations",
                          &n_steps, &n_evaluations),
              2)
        << heavy;
    EXPECT_GE(n_steps, 1000);
    EXPECT_LE(n_steps, 1500);
    EXPECT_EQ(n_evaluations, 4 * n_steps);
    EXPECT_NE(plan_line(heavy, "torque").find(fmt::format("evaluated {} times", n_evaluations)),
              std::string::npos)
        << heavy;
}

// The numbers of `sample` do not depend on the accuracy of the picture.
TEST(Plan, DoesNotChangeNumbers) {
    const std::string arguments = "sample scene.toml --times 12345.678";
    EXPECT_EQ(output_of(generic, arguments),
              output_of(generic, arguments + " --set accuracy_px=1e-6"));
}

TEST(Bound, IsPrintedByCheckAndAddsUp) {
    const std::string json = output_of(generic, "check scene.toml --json");
    EXPECT_EQ(number_of(json, "accuracy_px"), 0.1);
    EXPECT_LE(number_of(json, "bound_px"), 0.1);
    EXPECT_NEAR(number_of(json, "bound_px"),
                number_of(json, "motion_error_px") + number_of(json, "curve_error_px"), 1e-15);
    const std::string draft = output_of(generic, "check scene.toml --json --quality draft");
    EXPECT_GT(number_of(draft, "curve_error_px"), 0.1);
    // A bad step is reported.
    const std::string bad = output_of(generic + "[motion]\nmethod = \"rk4\"\nstep_s = 1.0\n",
                                      "check scene.toml --json --set accuracy_px=100");
    EXPECT_GT(number_of(bad, "motion_error_px"), 0.1);
}

TEST(Bound, IsInTheRecordAndOnStderr) {
    const ScratchFolder folder;
    folder.write("scene.toml", generic);
    const ProgramRun still = run_program_in(folder, "still scene.toml -o a.png");
    ASSERT_EQ(still.code, 0) << still.err;
    EXPECT_NE(still.err.find("within 0.05 px of the truth"), std::string::npos) << still.err;
    const ProgramRun film = run_program_in(folder, "render scene.toml -o a.mp4 --frames 0-3");
    ASSERT_EQ(film.code, 0) << film.err;
    EXPECT_NE(film.err.find("within 0.05 px of the truth"), std::string::npos) << film.err;
    for (const char* file : {"a.png", "a.mp4"}) {
        const ProgramRun record = run_program_in(folder, std::string("explain ") + file);
        EXPECT_NE(record.out.find("bounds: within 0.05 px of the truth"), std::string::npos)
            << record.out;
    }
    const ProgramRun quiet = run_program_in(folder, "still scene.toml -o b.png --quiet");
    EXPECT_EQ(quiet.err, "");
}

TEST(Certificate, HoldsForTheExactMotion) {
    const ScratchFolder folder;
    folder.write("scene.toml", generic);
    const ProgramRun check = run_program_in(folder, "check scene.toml");
    EXPECT_EQ(check.code, 0);
    EXPECT_NE(check.out.find("every claim holds"), std::string::npos);
    const ProgramRun film =
        run_program_in(folder, "render scene.toml -o a.mp4 --frames 0-3 --certify");
    EXPECT_EQ(film.code, 0) << film.err;
    EXPECT_NE(film.out.find("every claim holds"), std::string::npos);
    EXPECT_NE(folder.listing().find("a.mp4"), std::string::npos);
}

// ωt is 4.8e4 rad after an hour. After 1e13 s, no step in time is fine enough to measure speeds.
// After 1e15 s, doubles cannot tell the instants of a turn apart, so that no curve can be drawn.
TEST(Certificate, HoldsHoweverLateTheFilm) {
    const ScratchFolder folder;
    folder.write(
        "scene.toml",
        "[body]\nmoments_kg_m2 = [3.0, 2.0, 1.5]\n[start]\nomega_rad_s = [3.0, 12.0, 5.0]\n"
        "[film]\nsize = [64, 36]\nduration_s = 1.0\n");
    for (const char* start : {"3600", "1e5", "1e12"}) {
        const ProgramRun check =
            run_program_in(folder, std::string("check scene.toml --set film.start_s=") + start);
        EXPECT_EQ(check.code, 0) << start << check.out;
        EXPECT_EQ(check.out.find("FAILS"), std::string::npos) << check.out;
    }
    const ProgramRun late = run_program_in(folder, "check scene.toml --set film.start_s=1e13");
    EXPECT_NE(late.out.find("not measured speed_difference"), std::string::npos) << late.out;
    EXPECT_NE(late.out.find("every claim that was measured holds"), std::string::npos) << late.out;
    const ProgramRun json =
        run_program_in(folder, "check scene.toml --json --set film.start_s=1e13");
    EXPECT_NE(json.out.find("\"worst_speed_difference\": null"), std::string::npos) << json.out;
    const ProgramRun latest = run_program_in(folder, "check scene.toml --set film.start_s=1e15");
    EXPECT_EQ(latest.code, 2);
    EXPECT_NE(latest.err.find("times are too large to resolve its points"), std::string::npos);
    // A slow rotation is checked in the form in which it is drawn.
    for (const char* omega : {"1e-100", "1e-170", "1e-300"}) {
        const ProgramRun slow =
            run_program_in(folder, std::string("check scene.toml --set start.omega_rad_s=[0.0,") +
                                       omega + ",0.0]");
        EXPECT_EQ(slow.code, 0) << omega << slow.err << slow.out;
    }
    const ProgramRun light = run_program_in(
        folder, "check scene.toml --set body.moments_kg_m2=[3e-310,2e-310,1.5e-310]");
    EXPECT_EQ(light.out.find("inf"), std::string::npos) << light.out << light.err;
}

TEST(Certificate, RefusesInaccurateMotions) {
    const ScratchFolder folder;
    folder.write("scene.toml", generic + "[motion]\nmethod = \"euler\"\nstep_s = 0.1\n");
    const ProgramRun check = run_program_in(folder, "check scene.toml");
    EXPECT_EQ(check.code, 1);
    EXPECT_NE(check.out.find("FAILS momentum"), std::string::npos) << check.out;
    const ProgramRun film = run_program_in(folder, "render scene.toml -o a.mp4 --certify");
    EXPECT_EQ(film.code, 1) << film.err;
    EXPECT_EQ(folder.listing().find("a.mp4"), std::string::npos);
    // Without --certify, the same step is accepted.
    EXPECT_EQ(run_program_in(folder, "render scene.toml -o a.mp4 --frames 0-1").code, 0);
}

const std::string pushed =
    "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.9]\n[start]\nomega_rad_s = [0.3, 1.0, 0.2]\n"
    "[torque]\nkind = \"constant_body\"\ntorque_body_N_m = [0.01, 0.0, 0.0]\n"
    "[film]\nsize = [64, 36]\nduration_s = 10.0\n";

// A computation of minutes is refused before it begins, with an estimate of its time.
TEST(Stepping, IsRefusedAtOnceIfItTakesTooLong) {
    const ScratchFolder folder;
    folder.write("fine.toml", pushed + "[motion]\nmethod = \"rkmk4\"\nstep_s = 3e-9\n");
    folder.write("long.toml", pushed + "[motion]\nmethod = \"dopri5\"\n");
    for (const char* command :
         {"check fine.toml", "still fine.toml -o a.png", "render fine.toml -o a.md5",
          "sample fine.toml --times 0,10", "check long.toml --set film.duration_s=1e9 --fps 1/1000",
          "sample long.toml --times 1e9"}) {
        const ProgramRun run = run_program_in(folder, command, "timeout 20");
        EXPECT_EQ(run.code, 2) << command << ": " << run.err;
        EXPECT_NE(run.err.find("longer than the limit of 600 s"), std::string::npos) << run.err;
        EXPECT_NE(run.err.find(".toml:1"), std::string::npos) << run.err;
    }
}

TEST(Stepping, IsReportedAfterASecondAndStopsOnCtrlC) {
    const ScratchFolder folder;
    folder.write("short.toml", pushed + "[motion]\nmethod = \"rk4\"\nstep_s = 0.01\n");
    folder.write("long.toml", pushed + "[motion]\nmethod = \"rk4\"\nstep_s = 4e-7\n");
    // The second of two scenes: Ctrl-C is handled since the first.
    folder.write("run.sh",
                 "set -m\n'" + program_path() +
                     "' render short.toml long.toml --frames 0 -o '##.md5' 2>said & pid=$!\n"
                     "for k in $(seq 200); do grep -q stepping said && break; sleep 0.1; done\n"
                     "kill -INT $pid; wait $pid; [ $? -eq 130 ]\n");
    EXPECT_EQ(
        std::system(("cd '" + folder.path().string() + "' && bash run.sh 2>/dev/null").c_str()), 0);
    const std::string said = text_of(folder.path() / "said");
    EXPECT_NE(said.find("long: stepping the motion: 1 of about"), std::string::npos) << said;
}

TEST(Stepping, ReachesTheEndOfAnyFilm) {
    // A drawn history ends with a whole piece, beyond the film's last frame.
    for (const char* duration : {"9.9", "3.3", "0.07"}) {
        const ScratchFolder folder;
        folder.write("scene.toml", generic + "[motion]\nmethod = \"rk4\"\n");
        const std::string set = std::string(" --set film.duration_s=") + duration;
        EXPECT_EQ(run_program_in(folder, "still scene.toml -o a.png" + set).code, 0) << duration;
        EXPECT_EQ(run_program_in(folder, "still scene.toml -o b.png --time 20" + set).code, 0);
    }
}

}  // namespace
}  // namespace poinsot::testing
