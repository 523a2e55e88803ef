// What the table says of each kind, of a motion under it.
#include "mechanics/torque_kinds.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "mechanics/motion.h"
#include "mechanics/torque.h"

namespace poinsot {

namespace {

void fill(double& number) { number = 0.3; }
void fill(Eigen::Vector3d& vector) { vector = {0.2, 0.3, 0.4}; }

// A torque of each kind, whose numbers are not zero.
template <std::size_t k>
Torque some_torque() {
    using Kind = std::variant_alternative_t<k, Torque>;
    Kind torque;
    std::apply([&torque](const auto&... number) { (fill(torque.*number.member), ...); },
               KindOfTorque<Kind>::numbers);
    return torque;
}
template <std::size_t... k>
std::vector<Torque> some_torques(std::index_sequence<k...>) {
    return {some_torque<k>()...};
}
std::vector<Torque> some_torques() {
    return some_torques(std::make_index_sequence<std::variant_size_v<Torque>>());
}

// T, T + V and L in space at an instant.
struct Instant {
    double kinetic_J, energy_J;
    Eigen::Vector3d momentum_space;
};
Instant instant_of(const Motion& motion, double time_s) {
    const MotionProblem& problem = motion.problem();
    const RotationState state = motion.at(time_s);
    const Eigen::Vector3d momentum_body = problem.inertia.matrix_body() * state.omega_body;
    Torque torque = problem.torque;
    if (auto* gravity = std::get_if<Gravity>(&torque)) gravity->arm_body.normalize();
    const double kinetic = 0.5 * momentum_body.dot(state.omega_body);
    return {kinetic, kinetic + potential_J(torque, state.space_from_body),
            state.space_from_body * momentum_body};
}

}  // namespace

TEST(TorqueKinds, KeepAndTakeWhatTheTableSays) {
    for (const Torque& torque : some_torques()) {
        const TorqueKind& kind = kind_of(torque);
        MotionProblem problem;
        problem.inertia = InertiaTensor::from_principal_moments({1.0, 1.7, 2.2});
        problem.start.omega_body = {0.9, 1.1, 0.4};
        problem.torque = torque;
        problem.method = {"dopri5", {}, 1e-12, {}};
        problem.last_time_s = 3.0;
        const Motion motion(problem);
        const Instant first = instant_of(motion, 0.0);
        double moved = 0.0, gained = 0.0, most_gained = -1.0;
        double before_J = first.kinetic_J;
        for (int i = 1; i <= 30; ++i) {
            const Instant now = instant_of(motion, 0.1 * i);
            moved = std::max(moved, (now.momentum_space - first.momentum_space).norm());
            gained = std::max(gained, std::abs(now.energy_J - first.energy_J));
            most_gained = std::max(most_gained, now.kinetic_J - before_J);
            before_J = now.kinetic_J;
        }
        // The error of the method is some 1e-11; what the torques do is larger than 0.1.
        EXPECT_EQ(moved < 1e-9, kind.keeps_momentum) << kind.key << " moves L by " << moved;
        EXPECT_EQ(gained < 1e-9, kind.has_potential) << kind.key << " changes T + V by " << gained;
        EXPECT_EQ(most_gained < -1e-5, kind.takes_energy)
            << kind.key << " adds up to " << most_gained << " J to T in 0.1 s";
        EXPECT_EQ(RotationDynamics(problem.inertia, torque).has_torque(), kind.acts) << kind.key;
        EXPECT_EQ(is_free(torque), kind.key == "none");
        EXPECT_EQ(rolls(torque), is_free(torque) || dissipates(torque));
    }
}

TEST(TorqueKinds, HaveNamesOfTheirOwn) {
    std::set<std::string_view> keys, names;
    for (const TorqueKind& kind : torque_kinds) {
        keys.insert(kind.key);
        names.insert(kind.name);
    }
    EXPECT_EQ(keys.size(), torque_kinds.size());
    EXPECT_EQ(names.size(), torque_kinds.size());
    std::size_t k = 0;
    for (const Torque& torque : some_torques()) EXPECT_EQ(&kind_of(torque), &torque_kinds[k++]);
}

}  // namespace poinsot
