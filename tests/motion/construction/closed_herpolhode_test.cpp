// The start of a loop closes the herpolhode and the attitude by the smallest change of one value.
#include "construction/closed_herpolhode.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "error/error.h"
#include "mechanics/free/free_rotation.h"

namespace poinsot {

namespace {

const InertiaTensor body = InertiaTensor::from_principal_moments({1.0, 2.0, 2.9});
const Eigen::Vector3d spin(1.5, 0.3, 0.75);

RotationState start_at(const Eigen::Vector3d& omega_body) {
    RotationState start;
    start.omega_body = omega_body;
    return start;
}

TEST(ClosedHerpolhode, ReturnsTheBodyToItsInitialState) {
    for (const Closure closure : {Closure{5, 3}, Closure{7, 4}, Closure{2, 1}, Closure{16, 9}}) {
        const ClosedStart closed = close_herpolhode(body, spin, closure);
        const FreeRotation motion(body, start_at(closed.omega_body));
        const double repeat_s = closure.periods * closed.polhode_period_s;
        for (const double t : {0.0, 1.7, 5.1}) {
            const Quantities all{.attitude = true, .herpolhode = true, .euler_angles = false};
            const MotionSample before = motion.sample(t, all);
            const MotionSample after = motion.sample(t + repeat_s, all);
            // The root is accurate to 1e-15 of a turn per period, and the motion to 1e-15: measured
            // 1e-14
            EXPECT_LT(before.state.space_from_body.angularDistance(after.state.space_from_body),
                      2e-12);
            EXPECT_LT((before.state.omega_body - after.state.omega_body).norm(), 2e-12);
            EXPECT_LT((before.herpolhode_space - after.herpolhode_space).norm(), 2e-12);
        }
        EXPECT_NEAR(closed.advance_turns, 1.0 * closure.turns / closure.periods, 1e-13);
    }
}

TEST(ClosedHerpolhode, DoesNotCloseEarlier) {
    const Closure closure{5, 3};
    const ClosedStart closed = close_herpolhode(body, spin, closure);
    const FreeRotation motion(body, start_at(closed.omega_body));
    for (int periods = 1; periods < closure.periods; ++periods) {
        const RotationState later = motion.at(periods * closed.polhode_period_s);
        EXPECT_GT(motion.at(0.0).space_from_body.angularDistance(later.space_from_body), 0.1);
    }
}

TEST(ClosedHerpolhode, MakesTheSmallestChangeOfOneComponent) {
    const Closure closure{5, 3};
    const ClosedStart closed = close_herpolhode(body, spin, closure);
    ASSERT_TRUE(closed.changed);
    double least = std::abs(closed.omega_body[*closed.changed] - spin[*closed.changed]);
    for (int i = 0; i < 3; ++i) {
        if (i != *closed.changed) {
            EXPECT_EQ(closed.omega_body[i], spin[i]);
        }
        // No smaller change of any component gives the ratio: the advance stays on one side of it.
        const double excess = [&] {
            return *FreeRotation(body, start_at(spin)).constants().advance_per_period_rad;
        }() / (2.0 * M_PI) - 5.0 / 3.0;
        for (int k = -200; k <= 200; ++k) {
            Eigen::Vector3d omega = spin;
            omega[i] += 0.999 * least * k / 200.0;
            const auto advance =
                FreeRotation(body, start_at(omega)).constants().advance_per_period_rad;
            ASSERT_TRUE(advance);
            EXPECT_GT((*advance / (2.0 * M_PI) - 5.0 / 3.0) * excess, 0.0) << i << " " << k;
        }
    }
}

TEST(ClosedHerpolhode, ChangesTheNamedComponent) {
    for (int i = 0; i < 3; ++i) {
        const ClosedStart closed = close_herpolhode(body, spin, {9, 5}, i);
        EXPECT_EQ(closed.changed, i);
        for (int j = 0; j < 3; ++j) {
            if (j != i) {
                EXPECT_EQ(closed.omega_body[j], spin[j]);
            }
        }
    }
}

TEST(ClosedHerpolhode, KeepsClosedMotions) {
    const ClosedStart once = close_herpolhode(body, spin, {5, 3});
    const ClosedStart again = close_herpolhode(body, once.omega_body, {5, 3});
    EXPECT_FALSE(again.changed);
    EXPECT_EQ(again.omega_body, once.omega_body);
}

TEST(ClosedHerpolhode, FindsManyTurnsNearTheSeparatrix) {
    // The advance grows without bound towards the separatrix, so that every number of turns occurs.
    const ClosedStart closed = close_herpolhode(body, {0.3, 1.5, 0.2}, {9, 1});
    EXPECT_NEAR(closed.advance_turns, 9.0, 1e-9);
}

TEST(ClosedHerpolhode, ClosesMotionsOfSymmetricBodies) {
    const InertiaTensor symmetric = InertiaTensor::from_principal_moments({2.0, 2.0, 1.0});
    const ClosedStart closed = close_herpolhode(symmetric, {0.5, 0.0, 1.0}, {2, 1});
    // L/I₁ over Ω = (I₃ − I₁) ω₃/I₁: turns per period, by hand.
    const Eigen::Vector3d L(2.0 * closed.omega_body[0], 2.0 * closed.omega_body[1],
                            closed.omega_body[2]);
    EXPECT_NEAR(L.norm() / 2.0 / (0.5 * std::abs(closed.omega_body[2])), 2.0, 1e-12);
}

std::string refusal(const InertiaTensor& inertia, const Eigen::Vector3d& omega,
                    const Closure& closure) {
    try {
        close_herpolhode(inertia, omega, closure);
    } catch (const InputError& error) {
        return error.what();
    }
    ADD_FAILURE() << "closed";
    return "";
}

TEST(ClosedHerpolhode, NamesTheNearestPossibleRatio) {
    const std::string message = refusal(body, spin, {1, 100});
    EXPECT_NE(message.find("no start near this one closes after 100 polhode periods with 1 turn:"),
              std::string::npos)
        << message;
    const std::size_t at = message.find("the nearest is \"");
    ASSERT_NE(at, std::string::npos) << message;
    int turns = 0;
    int periods = 0;
    ASSERT_EQ(std::sscanf(message.c_str() + at, "the nearest is \"%d/%d\"", &turns, &periods), 2);
    // The named ratio is possible.
    EXPECT_NEAR(close_herpolhode(body, spin, {turns, periods}).advance_turns, 1.0 * turns / periods,
                1e-12);
}

TEST(ClosedHerpolhode, RefusesMotionsWithoutAPeriod) {
    EXPECT_NE(refusal(body, {0.0, 0.0, 1.0}, {5, 3}).find("no polhode period"), std::string::npos);
}

}  // namespace

}  // namespace poinsot
