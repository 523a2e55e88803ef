// fit: the body behind a table of ω(t), as words, JSON and a scene.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>

#include "cli/program_run.h"
#include "places.h"

namespace poinsot::testing {
namespace {

// A body in axes that are not its own, and a table of its motion.
void write_table(const ScratchFolder& folder) {
    folder.write("body.toml",
                 "[body]\ntensor_kg_m2 = [[3.0, 0.2, 0.1], [0.2, 2.5, -0.3], [0.1, -0.3, 2.0]]\n"
                 "[start]\nomega_rad_s = [1.4, 2.1, -1.7]\n");
    // Not from the start: the times of the fitted scene are those of the table.
    ASSERT_EQ(run_program_in(folder, "sample body.toml --times 7:27:0.05 -o gyro.csv").code, 0);
}

TEST(FitCommand, WritesASceneOfTheSameMotion) {
    const ScratchFolder folder;
    write_table(folder);
    const ProgramRun fit = run_program_in(folder, "fit gyro.csv -o fitted.toml");
    ASSERT_EQ(fit.code, 0) << fit.err;
    EXPECT_NE(fit.out.find("I2/I1 = "), std::string::npos) << fit.out;
    // The fitted scene's own motion is that of the table: the attitude does not depend on the
    // factor that the moments are known up to.
    const ProgramRun check =
        run_program_in(folder, "check fitted.toml --against gyro.csv --tolerance 1e-5rad --json");
    EXPECT_EQ(check.code, 0) << check.out << check.err;
    EXPECT_EQ(nlohmann::json::parse(check.out).at("rows"), 401);
}

// What the scene that `fit` writes leaves of its table is what the fit says, for every drag: the
// stepped motion of the scene is that of the fit. One table begins at 0, the other does not.
TEST(FitCommand, WritesTheDragIntoTheScene) {
    const ScratchFolder folder;
    std::filesystem::copy_file(source_folder() / "scenes" / "measured_racket.csv",
                               folder.path() / "at_zero.csv");
    std::filesystem::copy_file(
        source_folder() / "tests" / "motion" / "measured" / "racket" / "round3_093502_11.csv",
        folder.path() / "later.csv");
    for (const std::string table : {"at_zero", "later"})
        for (const std::string drag : {"none", "linear", "growing", "axes", "quadratic"}) {
            const ProgramRun fit = run_program_in(
                folder, fmt::format("fit {}.csv --drag {} -o {}.toml --json", table, drag, drag));
            ASSERT_EQ(fit.code, 0) << fit.err;
            const auto found = nlohmann::json::parse(fit.out);
            const std::string scene = text_of(folder.path() / (drag + ".toml"));
            const bool has_drag = scene.find("kind = \"drag\"") != std::string::npos;
            EXPECT_EQ(has_drag, drag != "none") << scene;
            const bool is_written = std::filesystem::exists(folder.path() / (drag + ".csv"));
            EXPECT_EQ(is_written, has_drag && table == "later");
            const ProgramRun check = run_program_in(
                folder, fmt::format("check {}.toml --json{}", drag,
                                    has_drag ? " --set motion.tolerance=1e-11" : ""));
            ASSERT_EQ(check.code, 0) << check.err;
            const double left = nlohmann::json::parse(check.out).at("measured_rms_rad_s");
            const double said = found.at("residual_rad_s");
            EXPECT_NEAR(left, said, 1e-5 * said) << table << drag;
        }
}

// The first line of a scene is a comment with the table's name.
TEST(FitCommand, TakesTablesOfAnyName) {
    const ScratchFolder folder;
    write_table(folder);
    std::filesystem::rename(folder.path() / "gyro.csv", folder.path() / "a\nb = 1.csv");
    const ProgramRun fit = run_program_in(folder, "fit 'a\nb = 1.csv' -o fitted.toml");
    ASSERT_EQ(fit.code, 0) << fit.err;
    EXPECT_EQ(run_program_in(folder, "check fitted.toml").code, 0);
}

TEST(FitCommand, PrintsNumbersAsJson) {
    const ScratchFolder folder;
    write_table(folder);
    const ProgramRun fit = run_program_in(folder, "fit gyro.csv --json");
    ASSERT_EQ(fit.code, 0) << fit.err;
    const auto found = nlohmann::json::parse(fit.out);
    // The eigenvalues of the tensor sum up to its trace: 7.5; the product of moments is its
    // determinant.
    const auto moments = found.at("moments").get<std::vector<double>>();
    const double determinant =
        3.0 * (2.5 * 2.0 - 0.09) - 0.2 * (0.2 * 2.0 + 0.03) + 0.1 * (-0.06 - 0.25);
    const double scale = 7.5 / (moments[0] + moments[1] + moments[2]);
    EXPECT_NEAR(scale * scale * scale * moments[0] * moments[1] * moments[2], determinant, 1e-4);
    EXPECT_NEAR(found.at("damping_1_s").get<double>(), 0.0, 1e-6);
}

// The scene that fit writes names the table: its points are in the picture and in the numbers of
// check, and a record that is drawn again notices when they change.
TEST(FitCommand, WritesASceneThatShowsTheTable) {
    const ScratchFolder folder;
    write_table(folder);
    ASSERT_EQ(run_program_in(folder, "fit gyro.csv -o fitted.toml").code, 0);
    const ProgramRun check = run_program_in(folder, "check fitted.toml --json");
    ASSERT_EQ(check.code, 0) << check.err;
    const auto found = nlohmann::json::parse(check.out);
    EXPECT_EQ(found.at("measured_file"), "gyro.csv");
    EXPECT_EQ(found.at("measured_rows"), 401);
    // The table is exact, and its attitudes fix L.
    EXPECT_LT(found.at("measured_rms_rad_s").get<double>(), 1e-6);
    EXPECT_LT(found.at("measured_momentum_tilt_rad").get<double>(), 1e-5);
    EXPECT_TRUE(found.at("measured_gaps_s").empty());

    const ProgramRun still =
        run_program_in(folder, "still fitted.toml -o fitted.png --size 320x180");
    ASSERT_EQ(still.code, 0) << still.err;
    EXPECT_EQ(run_program_in(folder, "rerender fitted.png -o again.png").code, 0);
    folder.write("gyro.csv", "t,wx,wy,wz\n7,1,2,3\n8,1,2,3\n");
    const ProgramRun changed = run_program_in(folder, "rerender fitted.png -o again.png");
    EXPECT_EQ(changed.code, 2);
    EXPECT_NE(changed.err.find("gyro.csv has changed"), std::string::npos) << changed.err;
}

// A table elsewhere is named by its path from the scene, which needs --allow-outside.
TEST(FitCommand, NamesTablesOfOtherFolders) {
    const ScratchFolder folder;
    write_table(folder);
    std::filesystem::create_directory(folder.path() / "scenes");
    const ProgramRun fit = run_program_in(folder, "fit gyro.csv -o scenes/fitted.toml");
    ASSERT_EQ(fit.code, 0) << fit.err;
    EXPECT_NE(fit.out.find("--allow-outside"), std::string::npos) << fit.out;
    const ProgramRun refused = run_program_in(folder, "check scenes/fitted.toml");
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("\"../gyro.csv\" does not lie in the scene's folder"),
              std::string::npos)
        << refused.err;
    EXPECT_EQ(run_program_in(folder, "check scenes/fitted.toml --allow-outside").code, 0);
}

// The tensor of write_table has the moments that its characteristic polynomial gives.
TEST(FitCommand, TakesKnownMoments) {
    const ScratchFolder folder;
    write_table(folder);
    const ProgramRun known =
        run_program_in(folder, "fit gyro.csv --moments 1.83258853,2.59722856,3.07018290 --json");
    ASSERT_EQ(known.code, 0) << known.err;
    const auto found = nlohmann::json::parse(known.out);
    EXPECT_EQ(found.at("I1_kg_m2"), 3.0701829);
    EXPECT_LT(found.at("residual_rad_s").get<double>(), 1e-6);
    // Moments of another body do not fit.
    EXPECT_NE(run_program_in(folder, "fit gyro.csv --moments 1,2,3").code, 0);
}

// A scene could not be read with such a name in it.
TEST(FitCommand, RefusesATableWhoseNameNoSceneCanHold) {
    const ScratchFolder folder;
    write_table(folder);
    for (const std::string name : {"\xff.csv", "a\x01.csv"}) {
        std::filesystem::copy(folder.path() / "gyro.csv", folder.path() / name);
        const ProgramRun refused = run_program_in(folder, "fit '" + name + "' -o z.toml");
        EXPECT_EQ(refused.code, 2);
        EXPECT_NE(refused.err.find("a scene cannot name this file"), std::string::npos)
            << refused.err;
        EXPECT_FALSE(std::filesystem::exists(folder.path() / "z.toml"));
        EXPECT_EQ(run_program_in(folder, "fit '" + name + "'").code, 0);
    }
}

TEST(FitCommand, RefusesInOneLine) {
    const ScratchFolder folder;
    folder.write("few.csv", "t,wx,wy,wz\n0,1,2,3\n");
    folder.write("attitude.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0,1,0,0\n");
    folder.write("cut.csv", "t,wx,wy,wz\n0,1,2\n");
    for (const auto& [line, message] : std::vector<std::pair<std::string, std::string>>{
             {"fit few.csv", "few.csv: 1 row says too little about a motion; give 30 or more"},
             {"fit attitude.csv", "attitude.csv: 2 rows say too little"},
             {"fit few.csv --moments 3,2", "--moments 3,2: give three positive numbers in kg m²"},
             {"fit few.csv --moments 3,2,-1", "--moments 3,2,-1: give three positive numbers"},
             {"fit few.csv --moments 3,2,1,1", "--moments 3,2,1,1: give three positive numbers"},
             {"fit few.csv --moments 1,1,3", "--moments 1,1,3: no rigid body has these moments"},
             {"fit cut.csv", "cut.csv:2:6: the row has 3 cells"},
             {"fit missing.csv", "cannot read missing.csv"},
             {"fit few.csv -o scene.png", "-o scene.png: the output is a scene"}}) {
        const ProgramRun run = run_program_in(folder, line);
        EXPECT_NE(run.code, 0) << line;
        EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    }
}

// A real recording with 25 throws (tests/motion/measured/recording).
std::string recording() {
    return (source_folder() / "tests" / "motion" / "measured" / "recording" / "round3_093502.csv")
        .string();
}

TEST(FitCommand, ListsTheFlightsOfARecordingAndFitsOne) {
    const ScratchFolder folder;
    const ProgramRun fit = run_program_in(folder, "fit " + recording() + " --flight 3 -o t.toml");
    ASSERT_EQ(fit.code, 0) << fit.err;
    EXPECT_EQ(fit.out.find("25 free flights"), 0U) << fit.out;
    EXPECT_NE(fit.out.find("flight 3:"), std::string::npos) << fit.out;
    // The rows of the flight lie beside the scene, which shows them.
    const ProgramRun check = run_program_in(folder, "check t.toml --json");
    ASSERT_EQ(check.code, 0) << check.err;
    EXPECT_EQ(nlohmann::json::parse(check.out).at("measured_file"), "t.csv");
    // The rows of that flight alone are one flight: the same fit.
    const auto one = nlohmann::json::parse(run_program_in(folder, "fit t.csv --json").out);
    const auto chosen = nlohmann::json::parse(
        run_program_in(folder, "fit " + recording() + " --flight 3 --json").out);
    EXPECT_EQ(one.at("moments"), chosen.at("moments"));
    EXPECT_EQ(chosen.at("flights").size(), 25U);
    EXPECT_EQ(chosen.at("flight"), 3);
}

TEST(FitCommand, FitsFlightsTogetherAndPredicts) {
    const ScratchFolder folder;
    const ProgramRun fit =
        run_program_in(folder, "fit " + recording() + " --flight all --predict 10 --json");
    ASSERT_EQ(fit.code, 0) << fit.err;
    const auto found = nlohmann::json::parse(fit.out);
    // Pendulums gave 0.067 ± 0.013.
    EXPECT_NEAR(found.at("moments").at(2).get<double>(), 0.067, 0.013);
    EXPECT_GE(found.at("flights_used"), 23);
    const auto& first = found.at("flights").at(0).at("prediction");
    EXPECT_NEAR(first.at("period_s").get<double>(), first.at("measured_period_s").get<double>(),
                4.0 * first.at("period_sd_s").get<double>());
    const ProgramRun shared =
        run_program_in(folder, "fit " + recording() + " --flight all --share-drag");
    EXPECT_NE(shared.out.find("shared: γ = "), std::string::npos) << shared.out;
    EXPECT_NE(shared.out.find("rule: a flight is left out if"), std::string::npos);
}

TEST(FitCommand, DrawsChartsOfOneAndOfSeveralFlights) {
    const ScratchFolder folder;
    write_table(folder);
    ASSERT_EQ(run_program_in(folder, "sample body.toml --times 30:45:0.05 -o later.csv").code, 0);
    const auto begins = [&folder](const std::string& name, const std::string& with) {
        std::ifstream file(folder.path() / name, std::ios::binary);
        std::string head(with.size(), ' ');
        file.read(head.data(), static_cast<std::streamsize>(head.size()));
        return head == with;
    };
    for (const std::string tables : {"gyro.csv", "gyro.csv later.csv"}) {
        for (const auto& [name, head] :
             {std::pair("chart.svg", "<?xml"), {"chart.pdf", "%PDF-"}, {"chart.PNG", "\x89PNG"}}) {
            const ProgramRun fit =
                run_program_in(folder, fmt::format("fit {} --chart {}", tables, name));
            ASSERT_EQ(fit.code, 0) << fit.err;
            EXPECT_TRUE(fit.out.ends_with(fmt::format("{}\n", name))) << fit.out;
            EXPECT_TRUE(begins(name, head)) << tables << name;
            std::filesystem::remove(folder.path() / name);
        }
        const ProgramRun refused =
            run_program_in(folder, fmt::format("fit {} --chart chart.jpg", tables));
        EXPECT_EQ(refused.code, 2);
        EXPECT_NE(refused.err.find("the chart is an SVG, a PDF or a PNG"), std::string::npos);
        EXPECT_EQ(folder.listing().find("chart"), std::string::npos);
    }
}

TEST(FitCommand, RefusesFlightsThatAreNotThere) {
    const ScratchFolder folder;
    write_table(folder);
    for (const auto& [line, message] : std::vector<std::pair<std::string, std::string>>{
             {"fit gyro.csv --flight 2", "--flight 2: gyro.csv has 1 flight; give 1, or leave"},
             {"fit gyro.csv --flight x", "--flight x: gyro.csv has 1 flight"},
             {"fit gyro.csv --flight all", "gyro.csv: the table has one flight"},
             {"fit gyro.csv gyro.csv --flight 1", "of several tables all flights are fitted"},
             {"fit gyro.csv gyro.csv -o both.toml", "-o both.toml: a scene shows one flight"},
             {"fit gyro.csv gyro.csv", "gyro.csv and gyro.csv hold the same rows; give each"},
             {"fit gyro.csv --share-drag", "--share-drag: one flight shares its drag with none"},
             {"fit gyro.csv --predict 401", "--predict 401: gyro.csv: 401 rows are fitted of 401"},
             {"fit gyro.csv --predict 3", "--predict 3: gyro.csv: 3 rows say too little"},
             {"fit gyro.csv --predict 0", "--predict 0: give the number of rows"}}) {
        const ProgramRun run = run_program_in(folder, line);
        EXPECT_EQ(run.code, 2) << line;
        EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    }
}

// A table that no body fits, for which the fit tries much. The program stops meanwhile, so that a
// second of the clock passes however fast it is.
TEST(FitCommand, SaysWhatItDoesAndEndsWhenAsked) {
    const ScratchFolder folder;
    std::string table = "t,wx,wy,wz\n";
    for (int i = 0; i < 20'000; ++i) {
        const double t = 0.01 * i;
        table += fmt::format("{},{},{},{}\n", t, std::sin(t), 2.0 + std::cos(1.3 * t),
                             std::sin(0.7 * t * t / 100.0));
    }
    folder.write("gyro.csv", table);
    const std::string err = (folder.path() / "err").string();
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        if (chdir(folder.path().c_str()) != 0 || freopen(err.c_str(), "w", stderr) == nullptr)
            _exit(127);
        execl(program_path().c_str(), "poinsot", "fit", "gyro.csv", nullptr);
        _exit(127);
    }
    using namespace std::chrono_literals;
    std::this_thread::sleep_for(200ms);
    kill(child, SIGSTOP);
    std::this_thread::sleep_for(1100ms);
    kill(child, SIGCONT);
    int status = 0;
    while (text_of(err).find('\n') == std::string::npos && waitpid(child, &status, WNOHANG) == 0)
        std::this_thread::sleep_for(5ms);
    EXPECT_EQ(text_of(err).find("gyro.csv: fitting: "), 0u) << text_of(err);
    kill(child, SIGINT);
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;
}

}  // namespace
}  // namespace poinsot::testing
