// Keys without effect are always reported.
#include "drawing/figures/panels/idle_keys.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "places.h"
#include "scene/files/load_scene.h"

namespace poinsot {
namespace {

std::vector<std::string> idle_in(const std::string& head, const std::string& more) {
    const std::string body =
        "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.9]\n[start]\nomega_rad_s = [1.4, 0.5, 1.6]\n";
    std::vector<std::string> keys;
    for (const IdleKey& idle : idle_keys(parse_scene(head + body + more, "a.toml")))
        keys.push_back(idle.key);
    return keys;
}
std::vector<std::string> idle_in(const std::string& more) { return idle_in("", more); }

using Keys = std::vector<std::string>;

TEST(IdleKeys, TrailsNeedAPanelWithPaths) {
    const std::string trails =
        "[trail]\npolhode = \"history\"\nherpolhode = \"whole\"\nlength_s = 2.0\n"
        "direction_marks = true\nticks = true\n";
    EXPECT_EQ(idle_in(trails), Keys{"trail.length_s"});
    EXPECT_EQ(idle_in(trails + "[[panels]]\nkind = \"plot\"\n"),
              (Keys{"trail.polhode", "trail.herpolhode", "trail.length_s", "trail.direction_marks",
                    "trail.ticks"}));
    EXPECT_EQ(idle_in(trails + "[[panels]]\nkind = \"plan\"\n"),
              (Keys{"trail.polhode", "trail.length_s", "trail.ticks"}));
    // With friction, the panels in body axes show the trail, too.
    EXPECT_EQ(idle_in("[trail]\npolhode = \"history\"\n[torque]\nkind = \"dissipation\"\n"
                      "half_life_s = 3.0\n[motion]\nmethod = \"dopri5\"\n"
                      "[[panels]]\nkind = \"body\"\n"),
              Keys{});
}

TEST(IdleKeys, UnitsBelongToANumberThatIsShown) {
    const auto units = [](const std::string& list) {
        return idle_in("units = " + list + "\n", "");
    };
    EXPECT_EQ(units(R"(["rpm", "deg", "ms", "mJ", "g cm²/s"])"), Keys{});
    EXPECT_EQ(units(R"(["U/min", "Grad"])"), Keys{});
    EXPECT_EQ(units(R"(["1/min"])"), Keys{"units"});  // a rate, but not of rotation
    EXPECT_EQ(units(R"(["deg", "g cm²", "cm"])"), (Keys{"units", "units"}));
}

TEST(IdleKeys, PathOfAnAxisNeedsATop) {
    const std::string fading = "[trail]\naxis = \"fading\"\nlength_s = 2.0\n";
    EXPECT_EQ(idle_in(fading), Keys{"trail.axis"});
    const auto idle_of_top = [](const std::string& more) {
        return idle_keys(
            parse_scene("[body]\nmoments_kg_m2 = [1.0, 1.0, 0.5]\n"
                        "[torque]\nkind = \"gravity\"\nmgl_N_m = 1.0\n"
                        "[start]\ntheta_rad = 0.7\nomega3_rad_s = 5.0\n" +
                            more,
                        "a.toml"));
    };
    EXPECT_TRUE(idle_of_top(fading).empty());
    EXPECT_TRUE(idle_of_top(fading + "[[panels]]\nkind = \"top\"\n").empty());
    const std::vector<IdleKey> in_a_chart = idle_of_top(fading + "[[panels]]\nkind = \"plot\"\n");
    ASSERT_EQ(in_a_chart.size(), 1u);
    EXPECT_EQ(in_a_chart[0].key, "trail.axis");
    // A top whose herpolhode is asked for gets the key of its own path.
    const std::vector<IdleKey> herpolhode =
        idle_of_top("[trail]\nherpolhode = \"fading\"\n[[panels]]\nkind = \"top\"\n");
    ASSERT_EQ(herpolhode.size(), 1u);
    EXPECT_NE(herpolhode[0].why.find("trail.axis"), std::string::npos) << herpolhode[0].why;
}

TEST(IdleKeys, ElementsAndStylesNeedTheirPanels) {
    const std::string plot = "[[panels]]\nkind = \"plot\"\n";
    EXPECT_EQ(idle_in("show = [\"title\", \"clock\"]\n", plot), Keys{});
    EXPECT_EQ(idle_in("show = [\"title\", \"levels\"]\n", plot), Keys{"show"});
    EXPECT_EQ(idle_in("show = [\"title\", \"levels\"]\n", ""), Keys{});
    EXPECT_EQ(idle_in("[page]\nelements = [\"plane\"]\n" + plot), Keys{"page.elements"});
    EXPECT_EQ(idle_in("[page]\nelements = [\"plane\"]\n"), Keys{});
    EXPECT_EQ(idle_in("[object]\nname = \"book\"\n" + plot), Keys{"object.name"});
    EXPECT_EQ(idle_in("[object]\nname = \"book\"\n[[panels]]\nkind = \"object\"\n"), Keys{});
}

TEST(IdleKeys, ElementsOfOtherPanelsNeedThosePanels) {
    const auto why = [](const std::string& element, const std::string& panel) -> std::string {
        const Scene scene = parse_scene("show = [\"" + element + "\"]\n[body]\n" +
                                            "moments_kg_m2 = [1.0, 2.0, 2.9]\n[start]\n"
                                            "omega_rad_s = [1.4, 0.5, 1.6]\n[[panels]]\nkind = \"" +
                                            panel + "\"\n",
                                        "a.toml");
        const std::vector<IdleKey> idle = idle_keys(scene);
        return idle.empty() ? "" : idle.front().why;
    };
    EXPECT_EQ(why("solid-angle", "momentum"), "");
    EXPECT_EQ(why("inertial-forces", "object"), "");
    EXPECT_EQ(why("solid-angle", "space"),
              "\"solid-angle\" is an element of panel \"momentum\"; add such a panel, or leave the "
              "element out");
    EXPECT_NE(why("inertial-forces", "momentum").find("panel \"object\""), std::string::npos);
    EXPECT_NE(why("polhode", "object").find("panel \"space\""), std::string::npos);
}

TEST(IdleKeys, KeysOfPanelsBelongToTheirKind) {
    EXPECT_EQ(idle_in("[[panels]]\nkind = \"space\"\nquantity = \"omega\"\ncurves = 3\n"
                      "title = \"Alone\"\n"),
              (Keys{"panels[0].quantity", "panels[0].curves", "panels[0].title"}));
    EXPECT_EQ(idle_in("[[panels]]\nkind = \"plot\"\nquantity = \"omega\"\n"), Keys{});
    EXPECT_EQ(idle_in("[[panels]]\nkind = \"body\"\ncurves = 3\n"), Keys{});
    EXPECT_EQ(idle_in("[[panels]]\nkind = \"body\"\ninset = \"top left\"\n"),
              Keys{"panels[0].inset"});
    // An inset shows the herpolhode, whatever its panel does.
    EXPECT_EQ(idle_in("show = [\"plane\"]\n",
                      "[trail]\nherpolhode = \"whole\"\n[[panels]]\ninset = \"top left\"\n"),
              Keys{});
}

TEST(IdleKeys, KeyframesNeedAPanelThatFollowsThem) {
    const std::string keyframe = "[[keyframes]]\nat_s = 2.0\nazimuth_deg = 3.0\ndistance = 4.0\n";
    EXPECT_EQ(idle_in(keyframe), Keys{});
    EXPECT_EQ(idle_in(keyframe + "[[panels]]\nkind = \"object\"\n"), Keys{"keyframes[0].distance"});
}

TEST(IdleKeys, NoSceneOfTheRepositoryHasOne) {
    for (const std::filesystem::path& file : supplied_scenes())
        for (const IdleKey& idle : idle_keys(load_scene(file)))
            ADD_FAILURE() << file.filename() << ": " << idle.key
                          << " changes nothing: " << idle.why;
}

}  // namespace
}  // namespace poinsot
