// Estimates of the time that stepping takes.
#include "production/session/stepping_estimate.h"

#include <gtest/gtest.h>

#include <string>

#include "error/error.h"
#include "mechanics/motion.h"
#include "mechanics/step_choice.h"
#include "scene/files/load_scene.h"
#include "scene/scene.h"

namespace poinsot {
namespace {

// A clock by which each stepping takes a microsecond, and some take half a second more: time that a
// host takes from its virtual machine, or that other processes use.
double interrupted_clock_s() {
    static int looks = 0;
    static double now_s = 0.0;
    ++looks;
    now_s += 1e-6;
    if (looks % 14 == 0) now_s += 0.5;
    return now_s;
}

// A clock by which setup takes one or two hundredths of a second, and stepping takes no measurable
// time.
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

// A single interruption of a short part must not inflate the estimate from a second to hours.
TEST(SteppingEstimate, IsIndependentOfOtherLoad) {
    EXPECT_LT(stepping_estimate_s(problem_of(stepped_scene()), interrupted_clock_s), 1.0);
}

// This once took minutes of stepping before it was refused: the estimate takes a limited number of
// steps.
TEST(SteppingEstimate, IsBoundedWhateverTheMotion) {
    MotionProblem fast = problem_of(stepped_scene());
    fast.torque = NoTorque{};
    fast.start.omega_body.setConstant(1e20);
    EXPECT_GT(stepping_estimate_s(fast), longest_stepping_s);
    MotionProblem stiff = problem_of(stepped_scene());
    stiff.torque = InternalFriction{1e12};
    EXPECT_GT(stepping_estimate_s(stiff), longest_stepping_s);
    MotionProblem fine = problem_of(stepped_scene());
    fine.method = {.name = "rk4", .step_s = 1e-200, .tolerance = {}, .order = {}};
    EXPECT_GT(stepping_estimate_s(fine), longest_stepping_s);
    // A stopped clock gives no estimate and does not block.
    EXPECT_EQ(stepping_estimate_s(fast, [] { return 0.0; }), 0.0);
}

// Stepping checks its time limit.
TEST(SteppingEstimate, IsKeptByStoppingWhatTakesLonger) {
    MotionProblem problem = problem_of(stepped_scene());
    problem.method = {.name = "rk4", .step_s = 1e-7, .tolerance = {}, .order = {}};
    const StopCheck is_over = [] { return true; };
    try {
        const Motion motion(problem, is_over);
        ADD_FAILURE() << "stepped to the end";
    } catch (const InputError& error) {
        // After the first thousand steps.
        EXPECT_NE(std::string(error.what()).find("had come to t = 0.0001"), std::string::npos)
            << error.what();
    }
    EXPECT_THROW(choose_step(problem, 1e-6, most_chosen_steps, is_over), InputError);
}

// Multiplied with the part that was stepped, it would be 350 years.
TEST(SteppingEstimate, CountsSettingUpOnce) {
    EXPECT_LT(stepping_estimate_s(problem_of(stepped_scene()), setting_up_clock_s), 1.0);
}

}  // namespace
}  // namespace poinsot
