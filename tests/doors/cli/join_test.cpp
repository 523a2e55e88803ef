// join: the parts of a film make it byte-identical to a single run, or are refused with a message.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/film_in_parts.h"
#include "cli/program_run.h"

namespace poinsot::testing {
namespace {

namespace fs = std::filesystem;

TEST_F(Parts, JoinedAreByteIdenticalToASingleRun) {
    // tests/outputs/encoding/film_parts_test.cpp has the other formats.
    for (const std::string kind : {".mp4", ".mov"}) {
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
    std::string beside = without_seal(bytes("one.chapters.json"));
    beside.replace(beside.find("one.mp4"), 7, "a.mp4");
    EXPECT_EQ(without_seal(bytes("a.chapters.json")), beside);
    // So are the captions: they are shown from 4 s to the end.
    for (const std::string name : {"a.mp4", "a.mov"}) {
        const std::string text = without_seal(bytes(name == "a.mp4" ? "a.vtt" : name + ".vtt"));
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

TEST_F(Parts, AreNotForPictures) {
    expect_refusal("still a.toml -o a.png --part 1/2", "--part");
    expect_refusal("render a.toml -o null --jobs 2", "this format has no parts for --jobs");
    expect_refusal("render a.toml -o p.mp4 --jobs -3", "--jobs -3");
    expect_refusal("render a.toml -o p.mp4 --jobs many", "--jobs");
}

}  // namespace
}  // namespace poinsot::testing
