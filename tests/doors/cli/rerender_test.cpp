// rerender: a file is drawn again from its record, byte-identically, or not at all.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/program_run.h"
#include "cli/recorded_pictures.h"
#include "image/files/png_files.h"

namespace poinsot::testing {
namespace {

namespace fs = std::filesystem;

using RerenderedPictures = Pictures;

TEST_F(RerenderedPictures, HaveRecordsAndAreRerendered) {
    struct Case {
        std::string name, command, profile;
    };
    for (const auto& [name, command, profile] :
         {Case{"a.png", "still scene.toml --time 0.3 --portable", "portable"},
          Case{"n.png", "still scene.toml --time 0.3", "native"},
          Case{"a.mp4", "render scene.toml", "native"},
          Case{"a.webm", "render scene.toml --portable", "portable"},
          Case{"a.mov", "render scene.toml --theme transparent", "native"},
          Case{"a.gif", "render scene.toml --frames 2-5", "native"},
          Case{"a_####.png", "render scene.toml --portable", "portable"}}) {
        ASSERT_EQ(run(command + " -q -o " + name).code, 0) << name;
        const std::string file = name == "a_####.png" ? "a_0007.png" : name;
        const std::string explained = run("explain " + file).out;
        EXPECT_EQ(said(explained, "scene"), "scene");
        EXPECT_EQ(said(explained, "scene-sha256").size(), 64u);
        EXPECT_EQ(said(explained, "method"), "exact");
        EXPECT_TRUE(contains(said(explained, "bounds"), "px"));
        EXPECT_TRUE(contains(said(explained, "renderer"), "llvmpipe"));
        EXPECT_FALSE(said(explained, "mesa").empty());
        EXPECT_EQ(said(explained, "profile"), profile);
        EXPECT_TRUE(contains(explained, "omega_rad_s = [0.01, 2.0, 0.01]")) << explained;
        const std::string again = "again_0007" + fs::path(file).extension().string();
        ASSERT_EQ(run("rerender -q " + file + " -o " + again).code, 0) << file;
        EXPECT_TRUE(text_of(folder_.path() / file) == text_of(folder_.path() / again)) << file;
        fs::remove(folder_.path() / again);
    }
}

// A theme file is read once: the record contains its values.
TEST_F(RerenderedPictures, WithAUsersThemeAreRerenderedWithoutItsFile) {
    folder_.write("mine.toml", "extends = \"dark\"\nomega = \"#ff5050 1.5 dashed\"\n");
    ASSERT_EQ(run("still scene.toml -q --theme mine.toml -o a.png").code, 0);
    ASSERT_EQ(run("render scene.toml -q --theme mine.toml --jobs 2 -o a.mp4").code, 0);
    ASSERT_EQ(run("still scene.toml -q --theme dark -o dark.png").code, 0);
    EXPECT_FALSE(text_of(folder_.path() / "a.png") == text_of(folder_.path() / "dark.png"));
    fs::remove(folder_.path() / "mine.toml");
    for (const std::string suffix : {".png", ".mp4"}) {
        EXPECT_TRUE(contains(run("explain a" + suffix).out, "omega = \"#ff5050 1.5 dashed\""));
        ASSERT_EQ(run("rerender -q a" + suffix + " -o again" + suffix).code, 0);
        EXPECT_TRUE(text_of(folder_.path() / ("a" + suffix)) ==
                    text_of(folder_.path() / ("again" + suffix)))
            << suffix;
    }
}

// A picture on a face belongs to the scene: if its file has changed, the output is not rendered
// again.
TEST_F(RerenderedPictures, WithAPictureOnAFaceNeedTheSamePictureToBeRerendered) {
    const auto cover = [this](std::uint8_t green) {
        Image image(2, 2);
        for (const int k : {0, 1, 2, 3}) image.set(k / 2, k % 2, {200, green, 40, 255});
        write_png(folder_.path() / "cover.png", image);
    };
    cover(30);
    folder_.write("scene.toml", racket +
                                    "[[object.pictures]]\nface = \"+e3\"\nfile = \"cover.png\"\n"
                                    "[[panels]]\nkind = \"object\"\n");
    for (const std::string file : {"a.png", "a.pdf"}) {
        const std::string size = file == "a.pdf" ? " --width-mm 120" : "";
        ASSERT_EQ(run("still scene.toml -q -o " + file + size).code, 0);
        ASSERT_EQ(run("rerender -q " + file + " -o again_" + file).code, 0);
        EXPECT_TRUE(text_of(folder_.path() / file) == text_of(folder_.path() / ("again_" + file)));
    }
    cover(31);
    const ProgramRun changed = run("rerender a.png -o b.png");
    EXPECT_EQ(changed.code, 2);
    EXPECT_EQ(
        changed.err,
        "a.png: cover.png has changed since the file was drawn; restore the earlier version\n");
    EXPECT_FALSE(fs::exists(folder_.path() / "b.png"));
    cover(30);
    EXPECT_EQ(run("rerender -q a.png -o b.png").code, 0);
}

const std::string with_symbols = R"(
title = "Renamed"
show = ["plane", "ellipsoid", "omega"]
labels = true
unlabelled = ["omega"]
[symbols]
omega = '\Omega'
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.01, 2.0, 0.01]
[film]
size = [128, 72]
length_s = 0.5
[[chapters]]
at_s = 0.0
title = "First"
[[chapters]]
at_s = 0.2
title = "Second"
)";

// Symbols are a table, and keys without a table were once written after them.
TEST_F(RerenderedPictures, OfScenesWithSymbolsAreRerendered) {
    folder_.write("scene.toml", with_symbols);
    for (const std::string name : {"a.png", "a.pdf", "a.svg", "a.mp4", "a_##.png"}) {
        const bool is_film = name == "a.mp4" || name == "a_##.png";
        const std::string file = name == "a_##.png" ? "a_07.png" : name;
        const std::string again = "again_07" + fs::path(file).extension().string();
        ASSERT_EQ(
            run((is_film ? "render" : "still") + std::string(" scene.toml -q -o ") + name).code, 0);
        const ProgramRun verified = run("explain --verify " + file);
        EXPECT_EQ(verified.code, 0) << verified.err;
        EXPECT_TRUE(is_one_line(verified.err) && contains(verified.err, "can be drawn again here"));
        const ProgramRun drawn = run("rerender -q " + file + " -o " + again);
        ASSERT_EQ(drawn.code, 0) << drawn.err;
        EXPECT_TRUE(text_of(folder_.path() / file) == text_of(folder_.path() / again)) << file;
        fs::remove(folder_.path() / again);
    }
}

// A tetrahedron whose first corner has a variable distance.
std::string tetrahedron(double x_m) {
    return "v " + std::to_string(x_m) +
           " 0 0\nv 0 1 0\nv 0 0 2\nv 0 0 0\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";
}

// The scene's text does not change when the content of its mesh file does; the meaning of the scene
// does.
TEST_F(RerenderedPictures, DetectAChangedMesh) {
    folder_.write("part.obj", tetrahedron(1.0));
    folder_.write("scene.toml",
                  "title = \"Part\"\n[body]\nmesh = \"part.obj\"\nmass_kg = 1.0\n[start]\n"
                  "omega_rad_s = [0.1, 2.0, 0.1]\n[film]\nsize = [96, 54]\nduration_s = 0.5\n");
    draw("a.png", "--portable --time 0.1");
    const std::string film = "render scene.toml -q --portable -o f_##.png";
    ASSERT_EQ(run(film).code, 0);
    EXPECT_EQ(run("rerender -q a.png -o b.png").code, 0);
    EXPECT_TRUE(text_of(folder_.path() / "a.png") == text_of(folder_.path() / "b.png"));
    const std::string hash = said(run("explain a.png").out, "scene-sha256");
    const std::string frame = text_of(folder_.path() / "f_03.png");

    folder_.write("part.obj", tetrahedron(1.5));
    const ProgramRun refused = run("rerender -q a.png -o c.png");
    EXPECT_EQ(refused.code, 2);
    EXPECT_TRUE(is_one_line(refused.err) && contains(refused.err, "part.obj")) << refused.err;
    EXPECT_FALSE(fs::exists(folder_.path() / "c.png"));
    draw("a.png", "--portable --time 0.1");
    EXPECT_NE(said(run("explain a.png").out, "scene-sha256"), hash);
    // An existing sequence is not continued, but rendered again.
    ASSERT_EQ(run(film).code, 0);
    EXPECT_FALSE(text_of(folder_.path() / "f_03.png") == frame);
}

// A scene just below the size limit is written in full, and is read again.
TEST(LargeScene, IsRerenderedFromItsRecord) {
    const ScratchFolder folder;
    std::string masses = "[start]\nomega_rad_s=[0,0,1]\n[film]\nsize=[64,36]\n";
    for (int k = 0; masses.size() + 100 < (1 << 20); ++k)
        masses += "[[body.masses]]\nmass_kg=1\nat_m=[" + std::to_string(k % 7) + "," +
                  std::to_string(k % 5) + "," + std::to_string(k % 3) + "]\n";
    folder.write("scene.toml", masses);
    const ProgramRun still = run_program_in(folder, "still scene.toml -q -o a.png");
    ASSERT_EQ(still.code, 0) << still.err;
    const ProgramRun again = run_program_in(folder, "rerender a.png -q -o b.png");
    EXPECT_EQ(again.code, 0) << again.err;
}

}  // namespace
}  // namespace poinsot::testing
