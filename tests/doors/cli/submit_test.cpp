// submit without a cluster: a fake sbatch records its arguments.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "cli/submitted_films.h"

namespace poinsot::testing::submit_tests {
namespace {

namespace fs = std::filesystem;

TEST_F(Submit, SubmitsAnArrayFollowedByTheJoins) {
    stand_in("sbatch", accepting_sbatch);
    stand_in("scontrol", "echo 'MaxArraySize            = 6'\n");
    folder_.write("config/x", "");
    fs::create_directory(folder_.path() / "config/poinsot");
    folder_.write("config/poinsot/slurm.options", "# here\n--account=physics --qos=\"a b\"\n");
    const ProgramRun done =
        run("submit a.toml b.toml -o '{scene}.mp4' --parts 8 --slurm '--partition=short'");
    ASSERT_EQ(done.code, 0) << done.err;
    // Three chunks each: six tasks, of which an array may have five.
    const std::string calls = text("calls");
    EXPECT_EQ(n_lines("calls"), 3) << calls;
    EXPECT_NE(calls.find("--array=1-5 "), std::string::npos) << calls;
    EXPECT_NE(calls.find("--array=1 "), std::string::npos) << calls;
    EXPECT_NE(calls.find("POINSOT_OFFSET=5 "), std::string::npos) << calls;
    EXPECT_NE(calls.find("--dependency=afterok:100:101 "), std::string::npos) << calls;
    EXPECT_NE(calls.find("--account=physics --qos=a b --partition=short "), std::string::npos);
    EXPECT_NE(done.out.find("parts 100\nparts 101\njoins 102\n"), std::string::npos) << done.out;
    EXPECT_EQ(n_lines("scene.mp4.job/tasks"), 6);
    EXPECT_NE(text("scene.mp4.job/tasks").find("--portable"), std::string::npos);
}

// Runs the tasks of the array one after the other.
TEST_F(Submit, IsByteIdenticalToASingleRun) {
    stand_in("sbatch", accepting_sbatch);
    const ProgramRun written = run("submit a.toml -o a.mp4 --parts 2 --dry-run");
    ASSERT_EQ(written.code, 0) << written.err;
    EXPECT_NE(written.out.find("parts=$parts:$(sbatch --parsable --array=1-2"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder_.path() / "calls"));
    EXPECT_NE(run("status a.mp4.job").out.find("2 waiting; join waiting"), std::string::npos);
    folder_.write("go",
                  "cd \"$(dirname \"$0\")\"\nfor k in 1 2; do sh a.mp4.job/task.sh tasks $k; "
                  "done\n");
    ASSERT_EQ(run_program_in(folder_, "--version", "sh go &&").code, 0);
    EXPECT_NE(run("status .").out.find("2 done; join waiting"), std::string::npos);
    folder_.write("go", "cd \"$(dirname \"$0\")\"\nsh a.mp4.job/task.sh joins 1\n");
    run_program_in(folder_, "--version", "sh go;");
    const ProgramRun over = run("status a.mp4.job");
    EXPECT_NE(over.out.find("2 done; join done"), std::string::npos) << over.out;
    ASSERT_EQ(run("render a.toml -q --portable -o one.mp4").code, 0);
    EXPECT_TRUE(text("a.mp4") == text("one.mp4"));
    EXPECT_TRUE(fs::is_empty(folder_.path() / "a.mp4.job/parts"));
    // No work is left to be submitted.
    const ProgramRun again = run("submit a.toml -o a.mp4 --parts 2");
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.err.find("nothing to submit: all parts are done"), std::string::npos)
        << again.err;
    EXPECT_FALSE(fs::exists(folder_.path() / "calls"));
}

// A task gets the path of a supplied scene.
TEST_F(Submit, RendersSuppliedScenes) {
    const ProgramRun written =
        run("submit generic -o g.mp4 --parts 1 --dry-run -q --set film.size=[64,36]"
            " --set film.duration_s=0.5 --quality draft");
    ASSERT_EQ(written.code, 0) << written.err;
    folder_.write("go", "cd \"$(dirname \"$0\")\"\nsh g.mp4.job/task.sh tasks 1\n");
    run_program_in(folder_, "--version", "sh go;");
    const ProgramRun over = run("status g.mp4.job");
    EXPECT_NE(over.out.find("1 done; join waiting"), std::string::npos) << over.out;
}

// The content of a file decides, not its time.
TEST_F(Submit, RendersOnlyChangedFilmsAgain) {
    const std::string submit = "submit a.toml b.toml -o '{scene}.mp4' --parts 2 --dry-run";
    ASSERT_EQ(run(submit).code, 0);
    folder_.write("go",
                  "cd \"$(dirname \"$0\")\"\nfor k in 1 2 3 4; do sh scene.mp4.job/task.sh tasks "
                  "$k; done\nfor k in 1 2; do sh scene.mp4.job/task.sh joins $k; done\n");
    run_program_in(folder_, "--version", "sh go;");
    EXPECT_NE(run(submit).err.find("nothing to submit: all parts are done"), std::string::npos);
    const fs::path scene = folder_.path() / "b.toml";
    const auto then = fs::last_write_time(scene);
    std::string text_now = a_scene;
    text_now.replace(text_now.find("0.3, 2.0"), 8, "0.4, 2.0");
    folder_.write("b.toml", text_now);
    fs::last_write_time(scene, then);
    const ProgramRun again = run(submit);
    ASSERT_EQ(again.code, 0) << again.err;
    const std::string told = run("status scene.mp4.job").out;
    EXPECT_NE(told.find("2 done; join done"), std::string::npos) << told;
    EXPECT_NE(told.find("2 waiting; join waiting"), std::string::npos) << told;
    run_program_in(folder_, "--version", "sh go;");
    ASSERT_EQ(run("render b.toml -q --portable -o one.mp4").code, 0);
    EXPECT_TRUE(text("b.mp4") == text("one.mp4"));
}

// The tasks run in another folder than the one in which the theme was named.
TEST_F(Submit, KeepsAUsersTheme) {
    folder_.write("mine.toml", "extends = \"dark\"\nomega = \"#ff5050 1.5 dashed\"\n");
    fs::create_directory(folder_.path() / "scenes");
    fs::rename(folder_.path() / "a.toml", folder_.path() / "scenes/a.toml");
    const ProgramRun written =
        run("submit scenes/a.toml -o a.mp4 --parts 2 --theme mine.toml --dry-run -q");
    ASSERT_EQ(written.code, 0) << written.err;
    folder_.write("go",
                  "cd \"$(dirname \"$0\")\"\nfor k in 1 2; do sh a.mp4.job/task.sh tasks $k; "
                  "done\nsh a.mp4.job/task.sh joins 1\n");
    run_program_in(folder_, "--version", "sh go;");
    const ProgramRun over = run("status a.mp4.job");
    EXPECT_NE(over.out.find("2 done; join done"), std::string::npos) << over.out;
    ASSERT_EQ(run("render scenes/a.toml -q --portable --theme mine.toml -o one.mp4").code, 0);
    ASSERT_EQ(run("render scenes/a.toml -q --portable -o plain.mp4").code, 0);
    EXPECT_TRUE(text("a.mp4") == text("one.mp4"));
    EXPECT_FALSE(text("a.mp4") == text("plain.mp4"));
}

TEST_F(Submit, PassesOptionsToSbatchSeparately) {
    stand_in("sbatch", accepting_sbatch);
    const ProgramRun done = run(
        "submit a.toml -o a.mp4 --parts 2 --slurm --partition=short --slurm '--time=10 --qos=b'");
    ASSERT_EQ(done.code, 0) << done.err;
    EXPECT_NE(text("calls").find("--partition=short --time=10 --qos=b "), std::string::npos)
        << text("calls");
}

// The tasks get keys in place of the options that set them.
TEST_F(Submit, PassesShortOptionsAsKeys) {
    folder_.write("mine.toml", "extends = \"dark\"\n");
    ASSERT_EQ(run("submit a.toml -o a.mp4 --parts 2 --dry-run --theme mine.toml --fps 20 "
                  "--sweep 'start.omega_rad_s[0]=0.3'")
                  .code,
              0);
    const std::string tasks = text("a.mp4.job/tasks");
    EXPECT_NE(tasks.find("--set film.fps=20"), std::string::npos) << tasks;
    EXPECT_NE(tasks.find("--set theme=/"), std::string::npos) << tasks;
    EXPECT_NE(tasks.find("start.omega_rad_s[0]=0.3"), std::string::npos) << tasks;
    EXPECT_EQ(tasks.find("--sweep"), std::string::npos) << tasks;
}

TEST_F(Submit, IsRefusedInASentence) {
    const auto expect = [&](const std::string& arguments, int code, const std::string& words) {
        const ProgramRun done = run(arguments);
        EXPECT_EQ(done.code, code) << arguments << done.err;
        EXPECT_NE(done.err.find(words), std::string::npos) << done.err;
        EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    };
    expect("submit a.toml -o a.mp4", 2, "--parts N");
    expect("submit a.toml -o a.mp4 --parts 0", 2, "--parts N");
    expect("submit a.toml --parts 2", 2, "name the film with -o");
    expect("submit a.toml -o a.png --parts 2", 2, "has no parts");
    expect("submit none.toml -o a.mp4 --parts 2", 2, "none.toml");
    expect("submit a.toml -o no/a.mp4 --parts 2", 3, "there is no folder no");
    expect("status .", 2, "is not the folder of a submission");
    // The second call fails: the first job is cancelled.
    stand_in("scontrol", "echo 'MaxArraySize = 3'\n");
    stand_in("sbatch",
             "echo \"$@\" >>calls\n[ $(wc -l <calls) = 1 ] && echo 7 && exit\n"
             "printf 'sbatch: error: no such partition\\nsbatch: error: Batch failed\\n' >&2; "
             "exit 1\n");
    stand_in("scancel", "echo \"$@\" >cancelled\n");
    expect("submit a.toml -q -o a.mp4 --parts 3", 3,
           "sbatch refused: no such partition; Batch failed; cancelled");
    EXPECT_EQ(text("cancelled"), "7\n");
}

// A new list of tasks removes the states and logs of the old one, and nothing else; the join
// removes the parts.
TEST_F(Submit, LeavesFilesOfSomebodyElse) {
    const std::vector<std::string> mine{"state/mine", "logs/mine", "parts/a/mine", "mine"};
    for (const std::string& name : mine) {
        fs::create_directories((folder_.path() / "a.mp4.job" / name).parent_path());
        folder_.write("a.mp4.job/" + name, "mine");
    }
    for (const char* parts : {"2", "2", "1"}) {
        const ProgramRun done =
            run(std::string("submit a.toml -o a.mp4 --dry-run --parts ") + parts);
        EXPECT_EQ(done.code, 0) << done.err;
        folder_.write("a.mp4.job/state/a.2.done", "");
        folder_.write("a.mp4.job/logs/a.2.log", "drawn");
    }
    EXPECT_EQ(run("submit a.toml -o a.mp4 --dry-run --parts 2").code, 0);
    EXPECT_FALSE(fs::exists(folder_.path() / "a.mp4.job/state/a.2.done"));
    for (const std::string task : {"tasks 1", "tasks 2", "joins 1"}) {
        const ProgramRun done = run_program_in(folder_, "", "sh a.mp4.job/task.sh " + task + " #");
        EXPECT_EQ(done.code, 0) << done.err;
    }
    EXPECT_TRUE(fs::exists(folder_.path() / "a.mp4"));
    EXPECT_FALSE(fs::exists(folder_.path() / "a.mp4.job/parts/a/1-of-2.mp4"));
    for (const std::string& name : mine) EXPECT_EQ(text("a.mp4.job/" + name), "mine") << name;
}

TEST_F(Submit, NeedsSbatch) {
    const ProgramRun done =
        run_program_in(folder_, "submit a.toml -q -o a.mp4 --parts 2", "PATH=\"$PWD/bin\"");
    EXPECT_EQ(done.code, 3);
    EXPECT_NE(done.err.find("sbatch: this machine has no such program"), std::string::npos)
        << done.err;
}

}  // namespace
}  // namespace poinsot::testing::submit_tests
