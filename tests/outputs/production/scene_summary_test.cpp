// Output of `check` for a heavy top, compared with closed forms for a start with no rate but the
// spin.
#include "production/session/scene_summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "production/session/motion_hints.h"
#include "scene/files/load_scene.h"
#include "scene/scene.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

constexpr double A = 1.0, C = 0.5, Mgl = 1.0;

using Found = std::map<std::string, std::string>;

// Facts as JSON, by key.
Found found_of(const std::string& scene) {
    Found found;
    for (const SummaryLine& fact :
         summarise(session_of(parse_scene(scene, "scene.toml"), {installed_fonts()}), false).lines)
        found[fact.key] = fact.json;
    return found;
}

Found top(const std::string& start, const std::string& more = "") {
    return found_of(
        "[body]\nmoments_kg_m2 = [1.0, 1.0, 0.5]\n[torque]\nkind = \"gravity\"\nmgl_N_m = 1.0\n"
        "[start]\n" +
        start + "\n[film]\nduration_s = 0.5\n" + more);
}

double number(const Found& found, const std::string& key) { return std::stod(found.at(key)); }

// A top released at θ₀ with only its spin falls until p_ψ²(u₀ − u) = 2A·Mgl(1 − u²), where u = cos
// θ: by conservation of energy and p_φ.
TEST(SceneSummary, OfAReleasedTopAreItsLimits) {
    const double theta = 0.7, omega3 = 8.0, p = C * omega3, u0 = std::cos(theta);
    const double q = p * p / (2.0 * A * Mgl);
    const double u = q / 2.0 - std::sqrt(q * q / 4.0 - q * u0 + 1.0);
    for (const char* method : {"", "[motion]\nmethod = \"rkmk4\"\n"}) {
        const Found found = top("theta_rad = 0.7\nomega3_rad_s = 8.0", method);
        EXPECT_EQ(found.at("top_regime"), "\"cuspidal nutation\"");
        EXPECT_NEAR(number(found, "p_psi_kg_m2_s"), p, 1e-14);
        EXPECT_NEAR(number(found, "p_phi_kg_m2_s"), p * u0, 1e-14);
        EXPECT_NEAR(number(found, "energy_J"), 0.5 * C * omega3 * omega3 + Mgl * u0, 1e-13);
        const std::string& angles = found.at("theta_rad");  // "[0.7, 0.99]"
        EXPECT_NEAR(std::stod(angles.substr(1)), theta, 1e-14);
        EXPECT_NEAR(std::stod(angles.substr(angles.find(',') + 1)), std::acos(u), 1e-13);
        EXPECT_NEAR(number(found, "start_kinetic_energy_J"), 0.5 * C * omega3 * omega3, 1e-13);
        EXPECT_NEAR(number(found, "start_momentum_kg_m2_s"), p, 1e-14);
    }
}

// An upright top is stable depending on (Cω₃)² compared with 4A·Mgl.
TEST(SceneSummary, OfASleepingTopSayWhetherItIsStable) {
    EXPECT_EQ(top("theta_rad = 0.0\nomega3_rad_s = 4.0").at("top_regime"), "\"sleeping\"");
    EXPECT_EQ(top("theta_rad = 0.0\nomega3_rad_s = 3.9").at("top_regime"),
              "\"sleeping, unstable\"");
}

// The sentence about a free motion begins with whether the body turns over, and the interval is
// that of the changes of sign of ω along the middle axis, counted in the motion.
TEST(SceneSummary, OfAFreeBodySayFirstWhetherItTurnsOver) {
    const auto words_of = [](const std::string& moments, const std::string& omega) {
        const Session session =
            session_of(parse_scene("[body]\nmoments_kg_m2 = " + moments +
                                       "\n[start]\nomega_rad_s = " + omega + "\n",
                                   "scene.toml"),
                       {installed_fonts()});
        int n_changes = 0;
        double sign = 0.0;
        for (int k = 0; k <= 20000; ++k) {
            const double along = session.motion.at(0.01 * k).omega_body[1];
            if (along * sign < 0.0) ++n_changes;
            if (along != 0.0) sign = along;
        }
        return std::pair(motion_in_words(session.motion), n_changes);
    };
    const auto [flips, n_changes] = words_of("[4.0, 3.0, 1.5]", "[0.3, 2.0, 0.5]");
    ASSERT_TRUE(flips.starts_with("turns over every ")) << flips;
    EXPECT_NEAR(200.0 / std::stod(flips.substr(17)), n_changes, 1.0) << flips;
    EXPECT_NE(flips.find("(elliptic)"), std::string::npos) << flips;
    EXPECT_TRUE(words_of("[4.0, 3.0, 1.5]", "[0.1, 0.1, 2.0]").first.starts_with("does not turn"));
    EXPECT_TRUE(words_of("[2.0, 2.0, 1.5]", "[0.1, 0.1, 2.0]").first.starts_with("symmetric"));
}

// For a body without two equal moments no closed form is reported.
TEST(SceneSummary, OfAnAsymmetricBodyHaveNoClosedForm) {
    const Found found = found_of(
        "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.9]\n[start]\nomega_rad_s = [3.0, 0.0, 4.0]\n"
        "[torque]\nkind = \"constant_body\"\ntorque_body_N_m = [0.0, 0.1, 0.0]\n"
        "[motion]\nmethod = \"rkmk4\"\n[film]\nduration_s = 0.5\n");
    EXPECT_NEAR(number(found, "start_kinetic_energy_J"), 0.5 * (9.0 + 2.9 * 16.0), 1e-13);
    EXPECT_NEAR(number(found, "start_momentum_kg_m2_s"), std::hypot(3.0, 2.9 * 4.0), 1e-14);
    EXPECT_FALSE(found.contains("p_phi_kg_m2_s"));
}

}  // namespace
}  // namespace poinsot
