// Scenes on the command line: the supplied ones by their names, and several of them with numbered
// outputs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/program_run.h"
#include "cli/small_scene.h"
#include "image/files/png_files.h"
#include "places.h"

namespace poinsot::testing::scenes_tests {
namespace {

using SceneMessages = Messages;

// Every supplied scene can be drawn, and its picture has more than one colour.
class EveryScene : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(EveryScene, FulfilsItsClaims) {
    const ScratchFolder folder;
    const ProgramRun check = run_program_in(folder, "check '" + GetParam().string() + "'");
    EXPECT_EQ(check.code, 0) << check.err;
    EXPECT_NE(check.out.find("title: "), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, ::testing::ValuesIn(supplied_scenes()),
                         [](const auto& tested) {
                             return std::filesystem::path(tested.param).stem().string();
                         });

// The share of pixels that differ clearly from the background colour.
double share_unlike_corner(const Image& image) {
    std::size_t n_unlike = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const Rgba8 a = image.at(x, y);
            const Rgba8 b = image.at(0, 0);
            n_unlike += std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) > 60;
        }
    }
    return static_cast<double>(n_unlike) / (image.width() * image.height());
}

TEST(Scenes, AllShowSomething) {
    const ScratchFolder folder;
    const std::string scenes = "'" + (source_folder() / "scenes").string() + "'/*.toml";
    const ProgramRun still =
        run_program_in(folder, "still " + scenes + " --size 320x180 --time 1 -q -o '{scene}.png'");
    ASSERT_EQ(still.code, 0) << still.err;
    for (const std::filesystem::path& file : supplied_scenes()) {
        const std::string name = file.stem().string() + ".png";
        // Of thin rods and arrows alone, or as pale as the ground.
        const bool is_slight = name == "inertial_forces.png" || name == "feynman_plate.png";
        const double least = is_slight ? 0.04 : 0.05;
        EXPECT_GT(share_unlike_corner(read_png(folder.path() / name)), least) << name;
    }
}

// A bare name means a supplied scene, or nearly one.
TEST_F(SceneMessages, AMistypedSceneGetsTheNearestName) {
    refuses("check genric", 2, {"genric: no such file, and no scene", "did you mean \"generic\"?"});
    refuses("check scene", 2, {"did you mean \"scene.toml\"?"});
    refuses("check qqqqqqqqq", 2, {"qqqqqqqqq: no such file", "poinsot list scenes"});
    folder_.write("generic.toml", "not read");
    EXPECT_EQ(run("check generic").code, 0);
}

std::string scene(const std::string& title) {
    return "title = \"" + title + R"("
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.3, 2.0, 0.1]
[film]
size = [192, 108]
duration_s = 0.1
)";
}

Image image_of(const ScratchFolder& folder, const std::string& name) {
    return read_png(folder.path() / name);
}

TEST(ManyScenes, AreNumberedInOrderAndDrawnAsEachAlone) {
    const ScratchFolder folder;
    for (const char* name : {"a", "b", "c"}) folder.write(name + std::string(".toml"), scene(name));
    const ProgramRun run = run_program_in(folder, "still *.toml -q -o '##.png'");
    ASSERT_EQ(run.code, 0) << run.err;
    int number = 0;
    for (const char* name : {"a", "b", "c"}) {
        const std::string one = std::string(name) + ".png";
        ASSERT_EQ(run_program_in(folder, "still " + (name + (".toml -q -o " + one))).code, 0);
        EXPECT_EQ(image_of(folder, "0" + std::to_string(number++) + ".png"), image_of(folder, one));
    }
    EXPECT_NE(image_of(folder, "00.png"), image_of(folder, "01.png"));
}

// Down to the smallest size: text that does not fit is omitted, and no scene is refused for it.
TEST(ManyScenes, AreDrawnHoweverSmall) {
    const ScratchFolder folder;
    const std::string scenes = "'" + (source_folder() / "scenes").string() + "'/*.toml";
    for (const char* size : {"64x36", "200x40"}) {
        const ProgramRun run = run_program_in(
            folder, "still " + scenes + " -q -o '####.png' --size " + std::string(size));
        EXPECT_EQ(run.code, 0) << size << ": " << run.err;
    }
    EXPECT_FALSE(image_of(folder, "0030.png").empty());
    const std::string generic = "'" + (source_folder() / "scenes/generic.toml").string() + "'";
    EXPECT_EQ(run_program_in(folder, "still " + generic + " -q -o one.png --size 16x16").code, 0);
}

TEST(ManyScenes, AnErrorInOneDoesNotStopTheOthers) {
    const ScratchFolder folder;
    folder.write("a.toml", scene("a"));
    folder.write("b.toml", "titel = \"b\"\n");
    folder.write("c.toml", scene("c"));
    const ProgramRun run = run_program_in(folder, "still a.toml b.toml c.toml -q -o '####.png'");
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find("b.toml:1:1: unknown key \"titel\""), std::string::npos) << run.err;
    EXPECT_EQ(folder.listing().find("0001.png"), std::string::npos);
    EXPECT_FALSE(image_of(folder, "0000.png").empty());
    EXPECT_FALSE(image_of(folder, "0002.png").empty());
}

// One picture is written while the next one is drawn.
TEST(ManyScenes, AreReportedInOrderAsSoonAsEachIsWritten) {
    const ScratchFolder folder;
    for (const char* name : {"a", "b", "c"}) folder.write(name + std::string(".toml"), scene(name));
    const ProgramRun run = run_program_in(folder, "still a.toml b.toml c.toml -o '####.png'");
    EXPECT_EQ(run.code, 0) << run.err;
    std::size_t at = 0;
    for (const char* name : {"0000.png\n", "0001.png\n", "0002.png\n"}) {
        at = run.err.find(name, at);
        ASSERT_NE(at, std::string::npos) << name << " in " << run.err;
    }
}

TEST(ManyScenes, AWriteErrorStopsAllAndIsReportedOnce) {
    for (const char* taken : {"0001.png", "0002.png"}) {
        const ScratchFolder folder;
        for (const char* name : {"a", "b", "c"})
            folder.write(name + std::string(".toml"), scene(name));
        std::filesystem::create_directories(folder.path() / taken / "full");
        const ProgramRun run =
            run_program_in(folder, "still a.toml b.toml c.toml -q -o '####.png'");
        EXPECT_EQ(run.code, 3) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        EXPECT_NE(run.err.find(taken), std::string::npos) << run.err;
        EXPECT_FALSE(image_of(folder, "0000.png").empty());
        EXPECT_EQ(std::filesystem::exists(folder.path() / "0002.png"),
                  std::string(taken) == "0002.png");
        EXPECT_EQ(folder.listing().find("0003"), std::string::npos);
    }
}

TEST(ManyScenes, WithoutANameAreWrittenToANewFolder) {
    for (const std::string command : {"still a.toml", "still a.toml b.toml"}) {
        const ScratchFolder folder;
        for (const char* name : {"a", "b"}) folder.write(name + std::string(".toml"), scene(name));
        const ProgramRun run = run_program_in(folder, command + " -q");
        EXPECT_EQ(run.code, 0) << command << ": " << run.err;
        EXPECT_FALSE(image_of(folder, "output/a.png").empty()) << command;
        EXPECT_EQ(std::filesystem::exists(folder.path() / "output/b.png"),
                  command.find('b') != std::string::npos);
    }
}

TEST(ManyScenes, FilmsAreNumberedToo) {
    const ScratchFolder folder;
    folder.write("a.toml", scene("a"));
    folder.write("b.toml", scene("b"));
    const ProgramRun run = run_program_in(folder, "render a.toml b.toml -q -o film_##.md5");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(text_of(folder.path() / "film_00.md5"), "");
    EXPECT_NE(text_of(folder.path() / "film_00.md5"), text_of(folder.path() / "film_01.md5"));
}

// Two folders may contain scenes of the same name; neither picture silently replaces the other.
TEST(ManyScenes, OfTheSameNameAreRefusedBeforeDrawing) {
    for (const char* command :
         {"still one/a.toml two/a.toml", "render one/a.toml two/a.toml --frames 0",
          "still b.toml one/a.toml two/a.toml -o '{scene}.png'", "still b.toml ./b.toml",
          "still 'c#.toml' c_.toml -o '{scene}.png'"}) {
        const ScratchFolder folder;
        for (const char* name : {"one", "two"}) {
            std::filesystem::create_directory(folder.path() / name);
            folder.write(std::string(name) + "/a.toml", scene(name));
        }
        for (const char* name : {"b.toml", "c#.toml", "c_.toml"}) folder.write(name, scene("d"));
        const std::string before = folder.listing();
        const ProgramRun run = run_program_in(folder, command);
        EXPECT_EQ(run.code, 2) << command << ": " << run.err;
        EXPECT_NE(run.err.find("would both be written to"), std::string::npos) << run.err;
        EXPECT_EQ(folder.listing(), before) << command;
    }
}

TEST(ManyScenes, AreNamedInTheirOutputs) {
    const ScratchFolder folder;
    for (const char* name : {"a", "b#1"}) folder.write(name + std::string(".toml"), scene("d"));
    for (const char* command :
         {"still a.toml 'b#1.toml' -q -o 'x_{scene}.png'", "still 'b#1.toml' -q -o '{scene}.png'",
          "still a.toml 'b#1.toml' -q -o '{scene}-##.png'", "render 'b#1.toml' -q --frames 0",
          "render a.toml 'b#1.toml' -q --frames 0-1 -o '{scene}_###.png'",
          "render a.toml -q --frames 0 -o '{scene}{scene}.md5'"})
        EXPECT_EQ(run_program_in(folder, command).code, 0) << command;
    for (const char* name : {"x_a.png", "x_b_1.png", "b_1.png", "a-00.png", "b_1-01.png",
                             "a_000.png", "a_001.png", "b_1_001.png", "aa.md5", "output/b_1.mp4"})
        EXPECT_TRUE(std::filesystem::exists(folder.path() / name))
            << name << " in " << folder.listing();
}

// A single scene has the same number as the first of two.
TEST(ManyScenes, NumberASingleSceneLikeTheFirst) {
    const ScratchFolder folder;
    folder.write("a.toml", scene("a"));
    for (const char* command :
         {"still a.toml -q -o '####.png'", "render a.toml -q --frames 0 -o 'film_##.md5'",
          "rerender 0000.png -q -o 'again_#.png'",
          "render a.toml -q --frames 1-2 -o 'turn_####.png'",
          "rerender turn_0002.png -q -o 'turned_####.png'"})
        EXPECT_EQ(run_program_in(folder, command).code, 0) << command;
    for (const char* name : {"0000.png", "film_00.md5", "again_0.png", "turn_0001.png",
                             "turn_0002.png", "turned_0002.png"})
        EXPECT_TRUE(std::filesystem::exists(folder.path() / name))
            << name << " in " << folder.listing();
    EXPECT_EQ(run_program_in(folder, "rerender 0000.png -o ./0000.png").code, 2);
}

TEST(ManyScenes, DoNotReplaceEachOther) {
    const ScratchFolder folder;
    folder.write("a.toml", scene("a"));
    folder.write("b.toml", scene("b"));
    const ProgramRun run = run_program_in(folder, "still a.toml b.toml -o one.png");
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.err.find("put #### into the name"), std::string::npos) << run.err;
    EXPECT_EQ(folder.listing(), "a.toml\nb.toml\n");
}

}  // namespace
}  // namespace poinsot::testing::scenes_tests
