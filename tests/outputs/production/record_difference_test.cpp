// What two records say that differs, in words.
#include "production/records/record_difference.h"

#include <gtest/gtest.h>

#include "error/error.h"

namespace poinsot {
namespace {

using Lines = std::vector<std::string>;

TEST(SceneDifferences, NameTheKeyAndBothValues) {
    EXPECT_EQ(scene_differences("a = 1\nb = 2.5\n[c]\nd = \"x\"\ne = [1, 2]\n",
                                "a = 1\nb = 3.0\n[c]\nd = \"y\"\ne = [1, 3]\n"),
              (Lines{"b: 2.5 → 3", "c.d: x → y", "c.e: [1, 2] → [1, 3]"}));
    EXPECT_EQ(scene_differences("a = 1", "a = 1"), Lines{});
    // 1 and 1.0 are the same number.
    EXPECT_EQ(scene_differences("a = 1", "a = 1.0"), Lines{});
}

TEST(SceneDifferences, SayWhichKeyIsAbsent) {
    EXPECT_EQ(scene_differences("[style]\nomega = \"red\"\n", "[style]\npolhode = \"#1060ff\"\n"),
              (Lines{"style.omega: red → default", "style.polhode: default → #1060ff"}));
    EXPECT_EQ(scene_differences("", "[body]\nmass_kg = 2\n"),
              (Lines{"body.mass_kg: not given → 2"}));
}

// An item that only one scene has is one line, however many keys it has.
TEST(SceneDifferences, SayWhichItemsAreAddedAndRemoved) {
    const std::string one = "[[panels]]\nkind = \"body\"\ncolumn = 0\n";
    const std::string two =
        one + "[[panels]]\nkind = \"space\"\ncolumn = 1\n[panels.camera]\nx = 1\n";
    EXPECT_EQ(scene_differences(one, two), (Lines{"panels[1]: added"}));
    EXPECT_EQ(scene_differences(two, one), (Lines{"panels[1]: removed"}));
    EXPECT_EQ(scene_differences(one, "[[panels]]\nkind = \"space\"\ncolumn = 0\n"),
              (Lines{"panels[0].kind: body → space"}));
    EXPECT_THROW(scene_differences("a = ", ""), InputError);
}

TEST(RecordDifferences, SayScenesThenSettingsThenVersions) {
    Record before, after;
    before.scene_name = after.scene_name = "generic";
    before.scene_toml = "theme = \"light\"\n[film]\nsize = [1, 2]\n";
    after.scene_toml = "theme = \"dark\"\n[film]\nsize = [3, 4]\n";
    before.time_s = 0.1, after.time_s = 0.25;
    before.version = "0.1.0", after.version = "0.2.0";
    before.renderer = "a", after.renderer = "b";
    before.width_px = 1, before.height_px = 2, after.width_px = 3, after.height_px = 4;
    before.pixels = "x", after.pixels = "y";
    // The size follows from the scene and is said once; hashes are not said.
    EXPECT_EQ(differences_in_words(before, after),
              (Lines{"theme: light → dark", "film.size: [1, 2] → [3, 4]", "time in s: 0.1 → 0.25",
                     "renderer: a → b", "program: 0.1.0 → 0.2.0"}));
    EXPECT_EQ(differences_in_words(before, before), Lines{});
    after = before;
    after.mesh_hash = "z";
    after.dpi = 300;
    EXPECT_EQ(
        differences_in_words(before, after),
        (Lines{"the contents of the scene's mesh, pictures or table differ", "dpi: none → 300"}));
}

// Two frames of one sequence are not the same picture; nor are 8 and 16 bits of one.
TEST(RecordDifferences, SayFramesAndBits) {
    Record before;
    before.frames = {0, 9};
    before.frame = 2;
    Record after = before;
    after.frame = 5;
    EXPECT_EQ(differences_in_words(before, after), (Lines{"frame: 2 → 5"}));
    after = before;
    after.bit_depth = 16;
    EXPECT_EQ(differences_in_words(before, after), (Lines{"bits per component: 8 → 16"}));
}

}  // namespace
}  // namespace poinsot
