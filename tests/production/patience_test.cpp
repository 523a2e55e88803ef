// What a stepped motion will take, told before it is stepped.
#include "production/patience.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "scene/load_scene.h"
#include "scene/scene.h"

namespace poinsot {
namespace {

// Others who have the processor between two looks at the clock made a second of stepping look like
// hours, and the scene was refused.
TEST(SteppingEstimate, IsOfTheMotionAndNotOfABusyMachine) {
    const Scene scene = parse_scene(
        "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.9]\n[start]\nomega_rad_s = [6.0, 0.1, 0.3]\n"
        "[torque]\nkind = \"dissipation\"\nrate_1_s = 0.01\n[motion]\nmethod = \"dopri5\"\n"
        "[film]\nduration_s = 27.0\n",
        "a.toml");
    const MotionProblem problem = problem_of(scene);
    std::atomic<bool> busy{true};
    std::vector<std::thread> others(8);
    for (std::thread& other : others)
        other = std::thread([&busy] {
            while (busy) {
            }
        });
    double longest_s = 0.0;
    for (int k = 0; k < 300; ++k) longest_s = std::max(longest_s, stepping_estimate_s(problem));
    busy = false;
    for (std::thread& other : others) other.join();
    EXPECT_LT(longest_s, 60.0);  // 0.05 s of processor time
}

}  // namespace
}  // namespace poinsot
