// check --against: another program's motion beside the exact one.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/program_run.h"

namespace poinsot::testing {
namespace {

constexpr const char* scene =
    "[body]\nmoments_kg_m2 = [4.0, 3.0, 1.5]\n[start]\nomega_rad_s = [1.2, 0.8, "
    "2.4]\n[film]\nduration_s = 4.0\n";

TEST(CheckAgainst, OwnMotionPassesAndAnotherMethodFails) {
    const ScratchFolder folder;
    folder.write("scene.toml", scene);
    ASSERT_EQ(run_program_in(folder, "sample scene.toml --times 0:40:0.1 -o exact.csv").code, 0);
    const ProgramRun own =
        run_program_in(folder, "check scene.toml --against exact.csv --tolerance 1e-15rad");
    EXPECT_EQ(own.code, 0) << own.out << own.err;
    EXPECT_NE(own.out.find("passes: "), std::string::npos) << own.out;

    ASSERT_EQ(run_program_in(folder,
                             "sample scene.toml --set motion.method=euler --set motion.step_s=0.01 "
                             "--times 0:4:0.1 -o euler.csv")
                  .code,
              0);
    const ProgramRun euler =
        run_program_in(folder, "check scene.toml --against euler.csv --json --chart errors.png");
    EXPECT_EQ(euler.code, 1) << euler.err;
    const auto said = nlohmann::json::parse(euler.out);
    EXPECT_FALSE(said.at("passes").get<bool>());
    EXPECT_GT(said.at("error_px").get<double>(), 0.1);
    // Euler's explicit method gains energy.
    EXPECT_GT(said.at("energy_share").at("last").get<double>(), 1e-3);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "errors.png"));
}

// Names of files and scenes are shown as they are, whatever markup they hold.
TEST(CheckAgainst, ChartsTablesOfAnyName) {
    const ScratchFolder folder;
    folder.write("we$ird_{.toml", scene);
    ASSERT_EQ(
        run_program_in(folder, "sample 'we$ird_{.toml' --times 0:4:0.1 -o 'we$ird_{.csv'").code, 0);
    const ProgramRun run = run_program_in(folder,
                                          "check 'we$ird_{.toml' --against 'we$ird_{.csv' --set "
                                          "start.omega_rad_s=[1.2,0.8,2.5] --chart a.png");
    EXPECT_EQ(run.code, 1) << run.err;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "a.png"));
}

// A table whose body turns at a slightly other rate about its own axis is off by the difference of
// the angles.
TEST(CheckAgainst, SaysTheAngleThatItIsOff) {
    const ScratchFolder folder;
    folder.write(
        "spin.toml",
        "[body]\nmoments_kg_m2 = [4.0, 3.0, 1.5]\n[start]\nomega_rad_s = [0.0, 0.0, 2.0]\n");
    std::string table = "time (ms),q_w,q_x,q_y,q_z\n";
    for (int i = 0; i <= 100; ++i) {
        const double angle = 2.01 * 0.01 * i;
        table += std::to_string(10 * i) + "," + std::to_string(std::cos(0.5 * angle)) + ",0,0," +
                 std::to_string(std::sin(0.5 * angle)) + "\n";
    }
    folder.write("theirs.csv", table);
    const ProgramRun run =
        run_program_in(folder, "check spin.toml --against theirs.csv --json --tolerance 1deg");
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    // 0.01 rad/s for a second; the table has six digits.
    EXPECT_NEAR(nlohmann::json::parse(run.out).at("attitude_rad").at("largest").get<double>(), 0.01,
                3e-6);
    EXPECT_EQ(
        run_program_in(folder, "check spin.toml --against theirs.csv --tolerance 0.5deg").code, 1);
}

TEST(CheckAgainst, RefusesInOneLine) {
    const ScratchFolder folder;
    folder.write("scene.toml", scene);
    folder.write("theirs.csv", "t,wx,wy,wz\n0,1.2,0.8,2.4\n");
    for (const auto& [line, message] : std::vector<std::pair<std::string, std::string>>{
             {"--against theirs.csv --tolerance 3kg", "--tolerance 3kg: not a tolerance"},
             {"--against theirs.csv --tolerance -1px", "--tolerance -1px: not a tolerance"},
             {"--against theirs.csv --tolerance 0.5", "--tolerance 0.5: not a tolerance"},
             {"--against theirs.csv --plan", "leave out --sweep and --plan"},
             {"--tolerance 1px", "belong to --against"},
             {"--against theirs.csv --chart errors.pdf", "end its name in .png"}}) {
        const ProgramRun run = run_program_in(folder, "check scene.toml " + line);
        EXPECT_EQ(run.code, 2) << line;
        EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
    }
}

}  // namespace
}  // namespace poinsot::testing
