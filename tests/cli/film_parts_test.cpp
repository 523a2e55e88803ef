// Films in parts and by several processes, on the command line: byte-identical to a single run, or
// refused with a message.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "cli/program_run.h"
#include "sanitized.h"

namespace poinsot::testing {
namespace {

namespace fs = std::filesystem;

// A film of 372 frames: four chunks, the last of them short.
constexpr const char* a_scene = R"(title = "In parts"
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.3, 2.0, 0.1]
[film]
size = [96, 54]
duration_s = 12.4
quality = "draft"
[[chapters]]
at_s = 0.0
title = "One"
[[chapters]]
at_s = 5.0
title = "Two \"quoted\""
[[captions]]
at_s = 4.0
text = '$\mathbf{L}$ stays'
)";

// A film that takes until a signal ends it.
const std::string large_size =
    sanitized ? " --set film.size=[160,90] " : " --set film.size=[640,360] ";

class Parts : public ::testing::Test {
 protected:
    Parts() { folder_.write("a.toml", a_scene); }

    ProgramRun run(const std::string& arguments) { return run_program_in(folder_, arguments); }
    void make(const std::string& arguments) {
        const ProgramRun done = run(arguments);
        EXPECT_EQ(done.code, 0) << arguments << ": " << done.err;
    }
    std::string bytes(const std::string& name) { return text_of(folder_.path() / name); }
    // Returns the message of a refused command.
    std::string refusal(const std::string& arguments, int code = 2) {
        const ProgramRun done = run(arguments);
        EXPECT_EQ(done.code, code) << arguments << ": " << done.err;
        EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
        return done.err;
    }
    void expect_refusal(const std::string& arguments, const std::string& words, int code = 2) {
        const std::string said = refusal(arguments, code);
        EXPECT_NE(said.find(words), std::string::npos) << arguments << ": " << said;
    }
    std::vector<std::string> names() {
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder_.path()))
            found.push_back(entry.path().filename().string());
        std::sort(found.begin(), found.end());
        return found;
    }

    ScratchFolder folder_;
};

TEST_F(Parts, JoinedAreByteIdenticalToASingleRun) {
    for (const std::string kind : {".mp4", ".webm", ".gif", ".md5"}) {
        // Two chunks and a short one.
        const std::string render = "render a.toml -q --set film.fps=20 -o ";
        make(render + "one" + kind);
        for (const char* k : {"3", "1", "2"})
            make(render + "'part##" + kind + "' --part " + k + "/3");
        make("join part03" + kind + " part01" + kind + " part02" + kind + " -q -o '{scene}" + kind +
             "'");
        EXPECT_TRUE(bytes("a" + kind) == bytes("one" + kind)) << kind;
    }
    // The sidecar of chapters is that of a single run, except for the film's name.
    std::string beside = bytes("one.chapters.json");
    beside.replace(beside.find("one.mp4"), 7, "a.mp4");
    EXPECT_EQ(bytes("a.chapters.json"), beside);
    // So are the captions: they are shown from 4 s to the end.
    for (const std::string name : {"a.mp4", "a.webm"}) {
        const std::string text = name == "a.mp4" ? bytes("a.vtt") : bytes("a.webm.vtt");
        EXPECT_EQ(text, "WEBVTT\n\nNOTE poinsot: " + name +
                            "\n\n00:00:04.000 --> 00:00:12.400\nL stays\n");
    }
    make("explain --verify a.mp4");
}

TEST_F(Parts, OfASequenceAreItsPictures) {
    make("render a.toml -q -o 'one_###.png' --frames 0-40");
    for (const char* k : {"2", "3", "1"})
        make("render a.toml -q -o 'two_###.png' --frames 0-40 --part " + std::string(k) + "/3");
    make("join 'two_###.png' -q -o 'two_###.png'");
    make("join two_*.png -q -o 'three_###.png'");
    for (const char* frame : {"000", "013", "014", "040"})
        for (const char* name : {"two_", "three_"})
            EXPECT_TRUE(bytes(std::string(name) + frame + ".png") ==
                        bytes(std::string("one_") + frame + ".png"))
                << name << frame;
    fs::remove(folder_.path() / "two_020.png");
    fs::remove(folder_.path() / "two_021.png");
    expect_refusal("join 'two_###.png' -o 'four_###.png'", "missing: 20-21;");
    fs::resize_file(folder_.path() / "three_007.png", 900);
    refusal("join 'three_###.png' -o 'four_###.png'");
    expect_refusal("join one_*.png two_004.png -o 'four_###.png'", "are both frame 4");
    EXPECT_FALSE(fs::exists(folder_.path() / "four_000.png"));
}

TEST_F(Parts, ThatDoNotBelongTogetherAreRefusedInASentence) {
    for (const char* k : {"1", "2", "3"})
        make("render a.toml -q -o p" + std::string(k) + ".mp4 --part " + k + "/3 --portable");
    expect_refusal("join p1.mp4 p3.mp4 -o f.mp4", "part 2 of 3 is missing (frames 240-");
    expect_refusal("join p1.mp4 p2.mp4 p3.mp4 p2.mp4 -o f.mp4", "are both part 2 of 3");
    expect_refusal("join p1.mp4 p2.mp4 p3.mp4 -o f.webm", "the parts are for a .mp4");
    expect_refusal("join p1.mp4 p2.mp4 p3.mp4 -o p1.mp4", "is one of the parts");
    expect_refusal("join p1.mp4 a.toml -o f.mp4", "a.toml: is not a part of a film");
    expect_refusal("join p1.mp4 none.mp4 -o f.mp4", "none.mp4: no such file");
    make("render a.toml -q -o q.mp4 --part 2/3 --portable --set start.omega_rad_s[0]=0.31");
    expect_refusal("join p1.mp4 q.mp4 p3.mp4 -o f.mp4", "their scenes or settings differ");
    make("render a.toml -q -o native.mp4 --part 2/3");
    expect_refusal("join p1.mp4 native.mp4 p3.mp4 -o f.mp4", "their profiles differ");
    make("render a.toml -q -o other.mp4 --part 2/2 --portable");
    expect_refusal("join p1.mp4 other.mp4 -o f.mp4", "one is of 3 parts, the other of 2");
    // One byte less: the last frame is incomplete.
    const fs::path cut = folder_.path() / "p2.mp4";
    fs::resize_file(cut, fs::file_size(cut) - 1);
    expect_refusal("join p1.mp4 p2.mp4 p3.mp4 -o f.mp4", "unfinished, cut off or changed");
    EXPECT_FALSE(fs::exists(folder_.path() / "f.mp4"));
    EXPECT_FALSE(fs::exists(folder_.path() / "f.chapters.json"));
}

// The record of a native film lists the processor's features; a portable film does not need them.
TEST_F(Parts, RecordTheProcessorUnlessPortable) {
    make("render a.toml -q -o p1.md5 --part 1/2");
    EXPECT_NE(bytes("p1.md5").find("\nprocessor: "), std::string::npos);
    make("render a.toml -q -o p2.md5 --part 1/2 --portable");
    EXPECT_EQ(bytes("p2.md5").find("\nprocessor: "), std::string::npos);
}

TEST_F(Parts, WithInvalidNumbersAreRefused) {
    for (const char* part : {"0/4", "5/4", "1", "x/2", "1/2/3", "-1/2", "1/0"})
        expect_refusal("render a.toml -o p.mp4 --part " + std::string(part), "--part ");
    expect_refusal("render a.toml -o p.png --part 1/2", "one picture has no parts");
    expect_refusal("render a.toml -o null --part 1/2", "has no parts");
    expect_refusal("render a.toml -o p.mp4 --jobs 0", "--jobs 0");
    expect_refusal("render a.toml -o p.mp4 --jobs 2 --part 1/2", "one process draws a --part");
    // If the name has no part number, the parts would replace each other or the film.
    make("render a.toml -q -o p.mp4 --part 1/2");
    expect_refusal("render a.toml -q -o p.mp4 --part 2/2", "holds part 1 of this film");
    folder_.write("film.mp4", "a film");
    expect_refusal("render a.toml -q -o film.mp4 --part 1/2", "exists and is not a part");
    EXPECT_EQ(bytes("film.mp4"), "a film");
    expect_refusal("recover p.mp4", "no unfinished film");
}

TEST_F(Parts, AreNotMoreThanTheChunks) {
    make("render a.toml -q -o one.mp4");
    for (int k = 1; k <= 6; ++k) {
        const ProgramRun done = run("render a.toml -o p" + std::to_string(k) + ".mp4 --part " +
                                    std::to_string(k) + "/6");
        EXPECT_EQ(done.code, 0) << done.err;
        EXPECT_NE(done.err.find("4 parts, not 6"), std::string::npos) << done.err;
        EXPECT_EQ(fs::exists(folder_.path() / ("p" + std::to_string(k) + ".mp4")), k <= 4);
    }
    make("join p1.mp4 p2.mp4 p3.mp4 p4.mp4 -q -o a.mp4");
    EXPECT_TRUE(bytes("a.mp4") == bytes("one.mp4"));
    // A finished part is not rendered again.
    const ProgramRun again = run("render a.toml -o p2.mp4 --part 2/6");
    EXPECT_NE(again.err.find("part 2 of 4 exists already"), std::string::npos) << again.err;
}

TEST_F(Parts, OfManyJobsAreByteIdenticalToOne) {
    for (const std::string kind : {"a.mp4", "a.webm", "a.gif", "a.md5"}) {
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
TEST_F(Parts, OfLoopsAndTransparentFilmsAreByteIdentical) {
    for (const std::string film :
         {"a.mp4 --set 'film.loop=\"period\"' --set 'camera.motion=\"co-precessing\"'",
          "a.webm --theme transparent", "a.gif --theme transparent"}) {
        make("render a.toml -q --set film.fps=15 --jobs 1 -o one_" + film);
        make("render a.toml -q --set film.fps=15 --jobs 2 -o " + film);
        const std::string name = film.substr(0, film.find(' '));
        EXPECT_TRUE(bytes(name) == bytes("one_" + name)) << film;
    }
}

// A second run on the output of several processes is refused, as for a single process.
TEST_F(Parts, AreRenderedByOneRunAtATime) {
    for (const std::string output : {"a.mp4", "a_####.png"}) {
        const std::string held = output == "a.mp4" ? ".a.mp4.part.frames" : ".a_####.png.part";
        const ProgramRun done = run_shell(
            folder_, "\"$1\" render a.toml -q --jobs 2" + large_size + "-o '" + output +
                         "' & first=$!; for i in $(seq 3000); do [ -e '" + held +
                         "' ] && [ -n \"$(pgrep -P $first)\" ] && break; sleep 0.05; done; "
                         "\"$1\" render a.toml -q --jobs 1" +
                         large_size + "-o '" + output +
                         "'; echo $? >code; kill -INT $first; wait $first");
        EXPECT_EQ(bytes("code"), "3\n") << output << done.err;
        EXPECT_NE(done.err.find("another run"), std::string::npos) << done.err;
    }
}

// Renders in two jobs, runs the commands `how`, which stop some of the processes, and waits.
std::string kill_one_of(const ScratchFolder& folder, const std::string& how) {
    return "(\"$1\" render a.toml -o k.mp4 --jobs 2" + large_size +
           "-q; echo $? >code) & "
           "parent=$!; " +
           how + " wait $parent; cd '" + folder.path().string() + "'";
}

TEST_F(Parts, OfAKilledJobAreResumed) {
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
TEST_F(Parts, EndWithTheirParentProcess) {
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
TEST_F(Parts, OfAnInterruptedJobAreRecovered) {
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
TEST_F(Parts, OfTheDefaultJobsAreByteIdenticalToOne) {
    folder_.write("b.toml", a_scene);
    const std::string big = large_size + "-q ";
    make("render b.toml a.toml --jobs 1 -o 'one_{scene}.mp4'" + big);
    make("render b.toml a.toml -o '{scene}.mp4'" + big);
    for (const char* name : {"a.mp4", "b.mp4"})
        EXPECT_TRUE(bytes(name) == bytes(std::string("one_") + name)) << name;
    EXPECT_NE(run("check a.toml --plan").out.find("\njobs: "), std::string::npos);
}

TEST_F(Parts, AreNotForPictures) {
    expect_refusal("still a.toml -o a.png --part 1/2", "--part");
    expect_refusal("render a.toml -o null --jobs 2", "this format has no parts for --jobs");
    expect_refusal("render a.toml -o p.mp4 --jobs -3", "--jobs -3");
    expect_refusal("render a.toml -o p.mp4 --jobs many", "--jobs");
}

}  // namespace
}  // namespace poinsot::testing
