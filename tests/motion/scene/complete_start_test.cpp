// The start by T and L.
#include <gtest/gtest.h>

#include "scene/write_scene.h"
#include "scene_text.h"

namespace poinsot::complete_start_tests {
namespace {

const std::string by_energy = a_body + "[start]\nenergy_J = 2.0\n";

TEST(ConservedStart, RefusesContradictions) {
    EXPECT_EQ(refusal(by_energy),
              "scenes/a.toml:4:1: start.energy_J needs start.momentum_kg_m2_s or "
              "start.plane_distance beside it: T alone does not choose a polhode");
    EXPECT_EQ(
        refusal(a_body + "[start]\nplane_distance = 0.7\n"),
        "scenes/a.toml:4:1: start.plane_distance is given but start.energy_J is not; give the "
        "kinetic energy, as in energy_J = 2.0");
    EXPECT_EQ(refusal(by_energy + "momentum_kg_m2_s = 2.5\nplane_distance = 0.7\n"),
              "scenes/a.toml:6:1: start.plane_distance contradicts start.momentum_kg_m2_s (at line "
              "5); with energy_J give one of them");
    EXPECT_EQ(refusal(by_energy + "momentum_kg_m2_s = 4\n"),
              "scenes/a.toml:5:1: momentum_kg_m2_s = 4 is impossible for this body with energy_J = "
              "2: 2T I_min <= L^2 <= 2T I_max requires L between 2 and 3.46410162 kg m^2/s");
    EXPECT_NE(refusal(by_energy + "momentum_kg_m2_s = 2.5\ntheta_rad = 0.5\n"), "");
    EXPECT_NE(refusal(by_energy + "momentum_kg_m2_s = 2.5\nomega_rad_s = [0, 0, 0]\n"), "");
}

TEST(ConservedStart, RefusesADecimalCommaByName) {
    EXPECT_EQ(
        refusal(a_body + "[start]\nomega_rad_s = [\"9,5 rad/s\", 1, 2]\n"),
        "scenes/a.toml:4:16: start.omega_rad_s[0] is \"9,5 rad/s\"; numbers have a decimal point: "
        "write \"9.5 rad/s\"");
    EXPECT_EQ(
        refusal(a_body + "[start]\nenergy_J = \"2,5\"\n"),
        "scenes/a.toml:4:12: start.energy_J is \"2,5\"; numbers have a decimal point: write 2.5");
    EXPECT_NE(refusal(a_body + "[start]\nenergy_J = \"2,5 rads\"\n").find("not a number with"),
              std::string::npos);
}

TEST(ConservedStart, AcceptsUnitsAndIsWrittenAsGiven) {
    const Scene scene = scene_of(a_body +
                                 "[start]\nenergy_J = \"2000 mJ\"\nmomentum_kg_m2_s = "
                                 "2.5\nomega_rad_s = [1, 2, 3]\n");
    const std::string text = to_toml(scene);
    EXPECT_NE(text.find("omega_rad_s = [1.0, 2.0, 3.0]\nenergy_J = 2.0\nmomentum_kg_m2_s = 2.5\n"),
              std::string::npos)
        << text;
    EXPECT_EQ(scene_of(text).start.omega_rad_s, scene.start.omega_rad_s);
    // A start that was changed since is written as ω.
    Scene changed = scene;
    changed.start.omega_rad_s[0] += 0.1;
    EXPECT_EQ(to_toml(changed).find("energy_J"), std::string::npos);
    EXPECT_FALSE(problem_of(changed).on_separatrix);
}

TEST(ConservedStart, OnTheSeparatrixIsExact) {
    // L² = 2T·I₂ = 8 has no exact root; its nearest double stands for it.
    const Scene scene = scene_of(by_energy + "momentum_kg_m2_s = 2.8284271247461903\n");
    EXPECT_TRUE(problem_of(scene).on_separatrix);
    EXPECT_TRUE(problem_of(scene_of(to_toml(scene))).on_separatrix);
    EXPECT_FALSE(problem_of(scene_of(by_energy + "momentum_kg_m2_s = 2.83\n")).on_separatrix);
}

}  // namespace
}  // namespace poinsot::complete_start_tests
