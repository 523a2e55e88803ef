// render --jobs: a film of several processes is byte-identical to that of one, also after some are
// killed.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/film_in_parts.h"
#include "cli/program_run.h"
#include "sanitized.h"

namespace poinsot::testing {
namespace {

namespace fs = std::filesystem;

using JobParts = Parts;

TEST_F(JobParts, OfManyJobsAreByteIdenticalToOne) {
    // The next test draws the other kinds.
    const std::vector<std::string> kinds =
        sanitized ? std::vector<std::string>{"a.mp4"}
                  : std::vector<std::string>{"a.mp4", "a.webm", "a.mov", "a.gif", "a.md5"};
    for (const std::string& kind : kinds) {
        make("render a.toml -q --set film.fps=20 --jobs 1 -o one_" + kind);
        make("render a.toml -q --set film.fps=20 --jobs 3 -o " + kind);
        EXPECT_TRUE(bytes(kind) == bytes("one_" + kind)) << kind;
    }
    make("render a.toml -q --frames 5-30 -o 'one_##.png'");
    make("render a.toml -q --frames 5-30 --jobs 2 -o 'two_##.png'");
    for (const char* frame : {"05", "17", "18", "30"})
        EXPECT_TRUE(bytes(std::string("two_") + frame + ".png") ==
                    bytes(std::string("one_") + frame + ".png"));
    for (const std::string& name : names()) EXPECT_NE(name.front(), '.') << name;
}

ProgramRun run_shell(const ScratchFolder& folder, const std::string& script) {
    folder.write("script", script);
    return run_program_in(folder, "", "bash script");
}

// Values of the whole film: a loop's changed start, and whether any frame is transparent.
TEST_F(JobParts, OfLoopsAndTransparentFilmsAreByteIdentical) {
    for (const std::string film :
         {"a.mp4 --set 'film.loop=\"period\"' --set 'camera.motion=\"co-precessing\"'",
          "a.webm --theme transparent", "a.mov --theme transparent", "a.gif --theme transparent"}) {
        make("render a.toml -q --set film.fps=15 --jobs 1 -o one_" + film);
        make("render a.toml -q --set film.fps=15 --jobs 2 -o " + film);
        const std::string name = film.substr(0, film.find(' '));
        EXPECT_TRUE(bytes(name) == bytes("one_" + name)) << film;
    }
}

// A second run on the output of several processes is refused, as for a single process.
TEST_F(JobParts, AreRenderedByOneRunAtATime) {
    for (const std::string output : {"a.mp4", "a_####.png"}) {
        const std::string held = output == "a.mp4" ? ".a.mp4.part.frames" : ".a_####.png.part";
        const ProgramRun done = run_shell(
            folder_, "\"$1\" render a.toml -q --jobs 2" + large_size + "-o '" + output +
                         "' & first=$!; for i in $(seq 3000); do [ -e '" + held +
                         "' ] && [ -n \"$(pgrep -P $first)\" ] && break; sleep 0.05; done; "
                         "kill -STOP $first; \"$1\" render a.toml -q --jobs 1" +
                         large_size + "-o '" + output +
                         "'; echo $? >code; kill -CONT $first; kill -INT $first; wait $first");
        EXPECT_EQ(bytes("code"), "3\n") << output << done.err;
        EXPECT_NE(done.err.find("another run"), std::string::npos) << done.err;
    }
}

// Otherwise the parts would be taken from the processes that draw them.
TEST_F(JobParts, AreNotRecoveredWhileTheyAreDrawn) {
    const ProgramRun done = run_shell(
        folder_, "\"$1\" render a.toml -q --jobs 2" + large_size +
                     "-o a.mp4 & first=$!; for i in $(seq 3000); do [ -e "
                     ".a.mp4.parts/.2-of-2.mp4.part.frames ] && break; sleep 0.02; done; "
                     "kill -STOP $first; \"$1\" recover a.mp4; echo $? >code; kill -CONT $first; "
                     "wait $first");
    EXPECT_EQ(bytes("code"), "3\n") << done.err;
    EXPECT_NE(done.err.find("cannot write a.mp4: another run is writing it"), std::string::npos)
        << done.err;
    make("explain --verify a.mp4");
    for (const std::string& name : names()) EXPECT_NE(name.front(), '.') << name;
}

// Renders in two jobs, runs the commands `how`, which stop some of the processes, and waits.
std::string kill_one_of(const ScratchFolder& folder, const std::string& how) {
    return "(\"$1\" render a.toml -o k.mp4 --jobs 2" + large_size +
           "-q; echo $? >code) & "
           "parent=$!; " +
           how + " wait $parent; cd '" + folder.path().string() + "'";
}

TEST_F(JobParts, OfAKilledJobAreResumed) {
    const std::string big = "render a.toml -q" + large_size;
    make(big + "-o one.mp4 --jobs 1");
    // Waits until both children are rendering, then kills one of them or their parent.
    const std::string started =
        "for i in $(seq 3000); do program=$(pgrep -P $parent); [ -n \"$program\" ] && "
        "children=$(pgrep -P $program) && [ $(echo \"$children\" | wc -l) = 2 ] && break; "
        "sleep 0.05; done; sleep 0.3; ";
    for (const auto& [kill, code] :
         {std::pair<std::string, std::string>{"kill -9 $(echo \"$children\" | tail -1);", "3"},
          {"kill -INT $program;", "3"},
          {"kill -TERM $program;", "3"}}) {
        // From the start, because the previous run may have left work for less than two processes.
        for (const std::string& name : names())
            if (name.front() == '.') fs::remove_all(folder_.path() / name);
        const ProgramRun done = run_shell(folder_, kill_one_of(folder_, started + kill));
        EXPECT_EQ(bytes("code"), code + "\n") << kill << done.err;
        EXPECT_FALSE(fs::exists(folder_.path() / "k.mp4"));
        EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    }
    make(big + "-o k.mp4 --jobs 2");
    EXPECT_TRUE(bytes("k.mp4") == bytes("one.mp4"));
    for (const std::string& name : names()) EXPECT_NE(name.front(), '.') << name;
}

// A stopped child receives no other signal: the end of the run does not wait for it.
TEST_F(JobParts, EndWithTheirParentProcess) {
    const ProgramRun done = run_shell(
        folder_,
        kill_one_of(folder_,
                    "for i in $(seq 3000); do program=$(pgrep -P $parent); [ -n \"$program\" ] && "
                    "children=$(pgrep -P $program) && [ $(echo \"$children\" | wc -l) = 2 ] && "
                    "break; sleep 0.02; done; "
                    "kill -STOP $children; kill -9 $program; "
                    // A process that has ended is gone, or a zombie until its parent waits for it.
                    // A zombie with other threads ("Zl") still holds its files.
                    "for i in $(seq 3000); do left=$(ps -o stat= -p $(echo $program $children | tr "
                    "' ' ,) | "
                    "grep -vc '^Z[^l]*$'); [ $left = 0 ] && break; sleep 0.02; done; "
                    "echo $left; kill -9 $children 2>/dev/null;"));
    EXPECT_EQ(done.out, "0\n") << done.err;
    EXPECT_EQ(bytes("code"), "137\n");
    make("render a.toml -q" + large_size + "-o k.mp4 --jobs 2");
    make("explain --verify k.mp4");
}

// The logs that several processes have left of a film: recover makes a film up to the first gap,
// and one process continues it.
TEST_F(JobParts, OfAnInterruptedJobAreRecovered) {
    const std::string big = "render a.toml -q" + large_size;
    make(big + "-o one.mp4 --jobs 1");
    // The first part has two of the four chunks; more than one must be finished.
    const std::string enough =
        std::to_string(fs::file_size(folder_.path() / "one.mp4") * 240 / 372 * 7 / 10);
    const auto interrupted = [&] {
        // Waits until the first part's log has enough frames, then interrupts all processes.
        const ProgramRun done = run_shell(
            folder_, kill_one_of(folder_,
                                 "for i in $(seq 6000); do [ $(stat -c %s "
                                 "\"$(dirname \"$0\")/.k.mp4.parts/.1-of-2.mp4.part.frames\" "
                                 "2>/dev/null || echo 0) -gt " +
                                     enough +
                                     " ] && break; sleep 0.05; done; "
                                     "kill -INT $(pgrep -P $parent);"));
        EXPECT_EQ(bytes("code"), "3\n") << done.err;
        EXPECT_TRUE(fs::exists(folder_.path() / ".k.mp4.parts"));
    };
    interrupted();
    const ProgramRun recovered = run("recover k.mp4");
    EXPECT_EQ(recovered.code, 0) << recovered.err;
    make("explain --verify k.mp4");
    const std::string record = run("explain k.mp4").out;
    EXPECT_NE(record.find("\nrun: 0-371\n"), std::string::npos) << record;
    // Rendered again by one process it is byte-identical.
    make("rerender k.mp4 -o again.mp4");
    EXPECT_TRUE(bytes("again.mp4") == bytes("k.mp4"));
    // The frames of the second part are kept: this is reported, and the next run uses them.
    const bool has_more = recovered.err.find("later frames follow a gap") != std::string::npos;
    EXPECT_EQ(has_more, fs::exists(folder_.path() / ".k.mp4.parts")) << recovered.err;
    make("render a.toml" + large_size + "-q -o k.mp4");
    EXPECT_TRUE(bytes("k.mp4") == bytes("one.mp4"));
    for (const std::string& name : names()) EXPECT_NE(name.front(), '.') << name;
    fs::remove(folder_.path() / "k.mp4");
    // By default, the next run continues with the same number of processes.
    interrupted();
    const bool first_is_whole = fs::exists(folder_.path() / ".k.mp4.parts" / "1-of-2.mp4");
    const ProgramRun done = run("render a.toml" + large_size + "-o k.mp4");
    EXPECT_EQ(done.code, 0) << done.err;
    // If the other processes used the processors, the first part was complete when the signal came.
    const char* said = first_is_whole ? "part 1 of 2 exists already" : "continuing with frame";
    EXPECT_NE(done.err.find(said), std::string::npos) << done.err;
    EXPECT_TRUE(bytes("k.mp4") == bytes("one.mp4"));
    for (const std::string& name : names()) EXPECT_NE(name.front(), '.') << name;
}

// The default number of processes gives the same film as one process, whatever the number; several
// scenes share one process once it has rendered.
TEST_F(JobParts, OfTheDefaultJobsAreByteIdenticalToOne) {
    if (sanitized) GTEST_SKIP() << "the films of the tests above pass the same code";
    folder_.write("b.toml", a_scene);
    const std::string big = large_size + "-q ";
    make("render b.toml a.toml --jobs 1 -o 'one_{scene}.mp4'" + big);
    make("render b.toml a.toml -o '{scene}.mp4'" + big);
    for (const char* name : {"a.mp4", "b.mp4"})
        EXPECT_TRUE(bytes(name) == bytes(std::string("one_") + name)) << name;
    EXPECT_NE(run("check a.toml --plan").out.find("\njobs: "), std::string::npos);
}

}  // namespace
}  // namespace poinsot::testing
