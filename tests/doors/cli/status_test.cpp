// status reports the state of every task of a submission; submit_test.cpp tests more of its output.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/submitted_films.h"

namespace poinsot::testing::submit_tests {
namespace {

namespace fs = std::filesystem;

using Status = Submit;

TEST_F(Status, ReportsFailedTasks) {
    ASSERT_EQ(run("submit a.toml -o a.mp4 --parts 2 --dry-run -q").code, 0);
    fs::remove(folder_.path() / "a.toml");
    folder_.write("go", "cd \"$(dirname \"$0\")\"\nsh a.mp4.job/task.sh tasks 2\n");
    run_program_in(folder_, "--version", "sh go;");
    const ProgramRun done = run("status a.mp4.job");
    EXPECT_EQ(done.code, 1);
    EXPECT_NE(done.out.find("a.2 failed: "), std::string::npos) << done.out;
    EXPECT_NE(run("status a.mp4.job --json").out.find("\"state\": \"failed\""), std::string::npos);
}

}  // namespace
}  // namespace poinsot::testing::submit_tests
