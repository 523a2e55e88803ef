// [style], and theme files of the user.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>

#include "mesh_folder.h"
#include "scene/write_scene.h"
#include "scene_text.h"

namespace poinsot {
namespace {

const std::array<double, 3> red{1.0, 0.0, 0.0};

TEST(Style, AcceptsColoursByNameAndByNumber) {
    for (const char* const colour : {"red", "#f00", "#ff0000", "#FF0000"})
        EXPECT_EQ(scene_of(a_scene + fmt::format("[style]\nomega = \"{}\"\n", colour))
                      .style.looks.at("omega")
                      .srgb,
                  red)
            << colour;
}

TEST(Style, RefusesUnknownWordsAtTheirPlace) {
    const auto said = [](const std::string& line) {
        return refusal(a_scene + "[style]\n" + line + "\n");
    };
    EXPECT_EQ(said("omega = \"redd\""),
              "scenes/a.toml:7:9: style.omega has \"redd\"; did you mean \"red\"?");
    EXPECT_EQ(said("omega = \"#12345\""),
              "scenes/a.toml:7:9: style.omega has \"#12345\"; give a colour, a weight and a line "
              "style, or some of them, as in \"#9a247d 1.5 dashed\"");
    EXPECT_NE(said("omega = \"dashd\"").find("did you mean \"dashed\"?"), std::string::npos);
    EXPECT_NE(said("omega = \"red red\"").find("has \"red\""), std::string::npos);
    EXPECT_NE(said("omega = \"\"").find("is empty"), std::string::npos);
    EXPECT_NE(said("plane = \"red 2\"").find("give a colour and an opacity"), std::string::npos);
    EXPECT_NE(said("plane = \"120%\"").find("give a colour and an opacity"), std::string::npos);
    EXPECT_NE(said("text = \"red 2\"").find("give a colour, as in"), std::string::npos);
    EXPECT_EQ(said("omga = \"red\""),
              "scenes/a.toml:7:1: unknown key \"omga\" in [style]; did you mean \"omega\"?");
}

TEST(ThemeFile, IsOverriddenByTheScene) {
    const MeshFolder folder;
    folder.write(
        "scenes/mine.toml",
        "extends = \"dark\"\nomega = \"red 2\"\npolhode = \"#00ff00\"\nlabel_scale = 1.5\n");
    const Scene scene =
        scene_of("theme = \"mine.toml\"\n" + a_scene + "[style]\nomega = \"dashed\"\n");
    EXPECT_EQ(scene.theme, "dark");
    EXPECT_EQ(scene.style.looks.at("omega").srgb, red);
    EXPECT_EQ(scene.style.looks.at("omega").weight, 2.0);
    EXPECT_EQ(scene.style.looks.at("omega").line, "dashed");
    EXPECT_EQ(scene.style.label_scale, 1.5);
    EXPECT_EQ(scene.where("style.polhode"), "scenes/mine.toml:3:1: ");

    // The written scene, as in the record of a picture, does not need the file.
    const std::string text = to_toml(scene);
    std::filesystem::remove("scenes/mine.toml");
    const Scene again = scene_of(text);
    EXPECT_EQ(again.theme, "dark");
    EXPECT_EQ(again.style.looks.at("polhode").srgb, (std::array<double, 3>{0.0, 1.0, 0.0}));
    EXPECT_EQ(to_toml(again), text);
}

TEST(ThemeFile, ExtendsTheLightThemeByDefault) {
    const MeshFolder folder;
    folder.write("scenes/mine.toml", "omega = \"red\"\n");
    EXPECT_EQ(scene_of("theme = \"mine.toml\"\n" + a_scene).theme, "light");
}

TEST(ThemeFile, OnTheCommandLineIsFoundInTheCurrentOrScenesFolder) {
    const MeshFolder folder;
    folder.write("here.toml", "omega = \"red\"\n");
    EXPECT_EQ(scene_of(a_scene, {"theme=here.toml"}).style.looks.at("omega").srgb, red);
    folder.write("scenes/there.toml", "omega = \"red\"\n");
    EXPECT_EQ(scene_of(a_scene, {"theme=there.toml"}).style.looks.at("omega").srgb, red);
}

TEST(ThemeFile, IsRefusedAtItsOwnPlace) {
    const MeshFolder folder;
    const auto said = [&folder](const std::string& theme) {
        folder.write("scenes/mine.toml", theme);
        return refusal("theme = \"mine.toml\"\n" + a_scene);
    };
    EXPECT_EQ(said("\nomga = \"red\"\n"),
              "scenes/mine.toml:2:1: unknown key \"omga\" in a theme; did you mean \"omega\"?");
    EXPECT_EQ(said("omega = \"redd\"\n"),
              "scenes/mine.toml:1:9: omega has \"redd\"; did you mean \"red\"?");
    EXPECT_NE(said("omega = 3\n").find("scenes/mine.toml:1:9: omega is an integer"),
              std::string::npos);
    EXPECT_EQ(said("[style]\nomega = \"red\"\n"),
              "scenes/mine.toml:1:2: [style] belongs to scenes; in a theme file its keys stand at "
              "the top level, so remove this heading and put them before any other");
    EXPECT_NE(said("title = \"x\"\n").find("unknown key \"title\" in a theme"), std::string::npos);
    EXPECT_NE(refusal("theme = \"none.toml\"\n" + a_scene).find("scenes/none.toml"),
              std::string::npos);
    EXPECT_NE(
        refusal("theme = \"../out.toml\"\n" + a_scene).find("does not lie in the scene's folder"),
        std::string::npos);
}

TEST(Marks, HaveAColourOrThatOfARole) {
    const auto mark = [](const std::string& colour) {
        return scene_of(a_scene + "[[marks]]\nat = [1, 0, 0]\ncolour = \"" + colour + "\"\n")
            .marks.at(0);
    };
    EXPECT_EQ(mark("omega").role, "omega");
    EXPECT_FALSE(mark("omega").srgb);
    EXPECT_EQ(mark("red").role, MarkSpec{}.role);
    EXPECT_EQ(mark("red").srgb, red);
    const Scene scene = scene_of(a_scene + "[[marks]]\nat = [1, 0, 0]\ncolour = \"omega\"\n");
    EXPECT_NE(to_toml(scene).find("colour = \"omega\""), std::string::npos);
    EXPECT_NE(refusal(a_scene + "[[marks]]\nat = [1, 0, 0]\ncolour = \"omgea\"\n").find("omgea"),
              std::string::npos);
}

TEST(Marks, NeedAPlace) {
    EXPECT_EQ(refusal(a_scene + "[[marks]]\nname = \"P\"\n"),
              "scenes/a.toml:6:1: marks[0].at is missing; say where the mark is, as in at = [1, 0, "
              "0]");
    EXPECT_NE(refusal(a_scene + "[[marks]]\nat = [0, 0, 0]\n").find("needs a direction"),
              std::string::npos);
    EXPECT_NE(refusal(a_scene + "[[marks]]\nat = [1, 0, 0]\non = \"bdy\"\n")
                  .find("did you mean \"body\"?"),
              std::string::npos);
}

}  // namespace
}  // namespace poinsot
