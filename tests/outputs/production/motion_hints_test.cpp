// What check says of flips and of loops nearby.
#include "production/session/motion_hints.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scene/parse_scene.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot::motion_hints_tests {
namespace {

const std::string racket =
    "[body]\nmoments_kg_m2 = [3.0, 2.0, 1.0]\n[start]\nomega_rad_s = [0.01, 2.0, 0.01]\n";

Session session_with(const std::string& text) {
    return session_of(parse_scene(text, "a.toml"), {.fonts = installed_fonts()});
}

std::string json_of(const Session& session, const std::string& key) {
    for (const SummaryLine& line : summarise(session, false).lines)
        if (line.key == key) return line.json;
    return "";
}
std::string text_of_line(const Session& session, const std::string& key) {
    for (const SummaryLine& line : summarise(session, false).lines)
        if (line.key == key) return line.label + ": " + line.text;
    return "";
}

TEST(MotionHints, SayWhenTheBodyFlips) {
    // Twice as slow, from t = 1 s: a flip at t is at second 2(t − 1) of the film.
    const Session session =
        session_with(racket + "[film]\nstart_s = 1\nduration_s = 20\nspeed = 0.5\n");
    const std::string times = json_of(session, "flips_s");
    const std::string film_times = json_of(session, "flips_film_s");
    const double first_s = std::stod(times.substr(1));
    EXPECT_NEAR(session.motion.at(first_s).omega_body[1], 0.0, 1e-12);
    EXPECT_NEAR(std::stod(film_times.substr(1)), 2.0 * (first_s - 1.0), 1e-9);
    EXPECT_NEAR(std::stod(json_of(session, "flip_interval_s")),
                0.5 * *session.motion.free_constants().polhode_period_s, 1e-12);
    const std::string text = text_of_line(session, "flips_s");
    EXPECT_EQ(text.find("flips (\u03c9 along e2, the middle axis, changes its sign): at t = "), 0u)
        << text;
    // A wobble about another axis does not flip.
    EXPECT_EQ(json_of(session_with("[body]\nmoments_kg_m2 = [1.0, 2.0, 3.0]\n[start]\n"
                                   "omega_rad_s = [0.5, 0.3, 2.5]\n"),
                      "flips_s"),
              "");
}

// A body that air drags: its flips, and what is left of T, against the motion's own samples.
TEST(MotionHints, SayWhatAStepTakenMotionLosesAndWhenItFlips) {
    const Session session = session_with(racket +
                                         "[torque]\nkind = \"drag\"\nlinear_1_s = "
                                         "[0.02, 0.02, 0.02]\n[motion]\nmethod = \"rkmk4\"\n"
                                         "[film]\nduration_s = 30\n");
    std::vector<double> wanted;
    constexpr int n = 30000;
    const double last_s = film_plan(session).last_time_s();
    double before = 2.0;
    for (int k = 1; k <= n; ++k) {
        const double now = session.motion.at(last_s * k / n).omega_body[1];
        if (now * before < 0.0) wanted.push_back(last_s * (k - 0.5) / n);
        before = now;
    }
    ASSERT_GE(wanted.size(), 2u);
    const std::string times = json_of(session, "flips_s");
    EXPECT_EQ(std::count(times.begin(), times.end(), ','),
              static_cast<std::ptrdiff_t>(wanted.size() - 1))
        << times;
    EXPECT_NEAR(std::stod(times.substr(1)), wanted.front(), 1e-3);
    // Equal drag about all axes leaves the polhode and takes exp(−2ct) of T.
    const double energy_J = 0.5 * (3.0 * 1e-4 + 2.0 * 4.0 + 1e-4);
    const double left = std::exp(-0.04 * last_s);
    EXPECT_NEAR(std::stod(json_of(session, "end_kinetic_energy_J")), energy_J * left, 1e-6);
    const std::string text = text_of_line(session, "end_kinetic_energy_J");
    EXPECT_NE(text.find(fmt::format("{:.3g} % of T at t = 0 lost", 100.0 * (1.0 - left))),
              std::string::npos)
        << text;
}

TEST(MotionHints, NameLoopsNearby) {
    const std::string motion =
        "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.9]\n[start]\nomega_rad_s = [1.5, 0.3, 0.75]\n";
    const Session session = session_with(motion);
    const std::string text = text_of_line(session, "near_loops");
    EXPECT_NE(text.find("\"7/4\" (omega_"), std::string::npos) << text;
    // A loop named there is accepted, and then there is nothing more to name.
    const Session loop = session_with(motion + "[film]\nloop = \"7/4\"\n");
    ASSERT_TRUE(loop.loop);
    EXPECT_EQ(json_of(loop, "near_loops"), "");
}

}  // namespace
}  // namespace poinsot::motion_hints_tests
