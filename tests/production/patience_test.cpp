// What a stepped motion will take, told before it is stepped.
#include "production/patience.h"

#include <gtest/gtest.h>

#include "scene/load_scene.h"
#include "scene/scene.h"

namespace poinsot {
namespace {

// A clock by which each stepping takes a microsecond, but some of them half a second more: what a
// host takes away from its virtual machine, or others between two looks.
double interrupted_clock_s() {
    static int looks = 0;
    static double now_s = 0.0;
    ++looks;
    now_s += 1e-6;
    if (looks % 14 == 0) now_s += 0.5;
    return now_s;
}

// A clock by which setting up takes a hundredth of a second or two, and stepping nothing that it
// could tell.
double setting_up_clock_s() {
    static int looks = 0;
    static double now_s = 0.0;
    return now_s += ++looks > 20 ? 0.02 : 0.01;
}

const Scene& stepped_scene() {
    static const Scene scene = parse_scene(
        "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.9]\n[start]\nomega_rad_s = [6.0, 0.1, 0.3]\n"
        "[torque]\nkind = \"dissipation\"\nrate_1_s = 0.01\n[motion]\nmethod = \"dopri5\"\n"
        "[film]\nduration_s = 27.0\n",
        "a.toml");
    return scene;
}

// One such interruption of a short part made a second of stepping look like hours, and the scene
// was refused.
TEST(SteppingEstimate, IsOfTheMotionAndNotOfABusyMachine) {
    EXPECT_LT(stepping_estimate_s(problem_of(stepped_scene()), interrupted_clock_s), 1.0);
}

// Multiplied with the part that was stepped, it would be 350 years.
TEST(SteppingEstimate, CountsSettingUpOnce) {
    EXPECT_LT(stepping_estimate_s(problem_of(stepped_scene()), setting_up_clock_s), 1.0);
}

}  // namespace
}  // namespace poinsot
