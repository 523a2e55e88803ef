#include "construction/quantities.h"

#include <fmt/format.h>

#include <cmath>

#include "error/error.h"
#include "mechanics/euler_angles.h"
#include "numerics/power_of_two.h"

namespace poinsot {

namespace {

using Values = double*;
using Of = const QuantitySource&;
using At = const MotionSample&;
using Names = std::string_view[];

void put(const Eigen::Vector3d& vector, Values values) {
    for (int i = 0; i < 3; ++i) values[i] = vector[i];
}

Eigen::Vector3d space_of(At at, const Eigen::Vector3d& body) {
    return at.state.space_from_body * body;
}

// ρ = ω/√(2T) with the T of the instant, scaled by a power of two so that nothing overflows.
Eigen::Vector3d contact_body(Of of, At at) {
    const Eigen::Vector3d& omega = at.state.omega_body;
    const double largest = omega.cwiseAbs().maxCoeff();
    if (!(largest > 0.0))
        throw InputError("a body at rest touches no invariable plane; leave contact out");
    const Eigen::Vector3d scaled = ldexp(omega, -exponent_of(largest));
    return scaled / std::sqrt(scaled.dot(of.inertia.matrix_body() * scaled));
}

void put_quaternion(Of, At at, Values values) {
    const Eigen::Quaterniond& q = at.state.space_from_body;
    values[0] = q.w();
    put(q.vec(), values + 1);
}

void put_residuals(Of of, At at, Values values) {
    const RollingResiduals r = of.construction->residuals(at.state);
    values[0] = r.contact_plane_gap;
    values[1] = r.tangency_gap;
    values[2] = r.slip;
    values[3] = r.momentum;
    values[4] = r.energy;
    values[5] = r.unit_quaternion;
}

// φ and ψ of a heavy top are unwrapped; of any other motion they are those of its attitude.
void put_euler_angles(Of of, At at, Values values) {
    const EulerAngles angles = of.has_angles ? at.euler : euler_angles_of(at.state.space_from_body);
    values[0] = angles.theta_rad;
    values[1] = angles.phi_rad;
    values[2] = angles.psi_rad;
}

bool has_constants(const Motion& motion) { return turns_freely(motion.problem()); }

constexpr Quantities no_attitude{.attitude = false};
constexpr Quantities attitude{};
constexpr Quantities with_herpolhode{.attitude = true, .herpolhode = true};
constexpr Quantities with_angles{.attitude = true, .euler_angles = true};
constexpr QuantityUnit no_unit{}, second{"s", "s"}, rad{"rad", "rad"}, rad_s{"rad/s", "rad_s"},
    joule{"J", "J"}, kg_m2_s{"kg m²/s", "kg_m2_s"},
    // Lengths of the construction.
    per_sqrt_kg_m2{"1/√(kg m²)", "per_sqrt_kg_m2"};

constexpr Names time_names{"time"}, omega_names{"omega_1", "omega_2", "omega_3"},
    omega_body_names{"omega_body_1", "omega_body_2", "omega_body_3"},
    omega_space_names{"omega_space_x", "omega_space_y", "omega_space_z"},
    attitude_names{"q_w", "q_x", "q_y", "q_z"},
    herpolhode_names{"herpolhode_x", "herpolhode_y", "herpolhode_z"},
    angle_names{"theta", "phi", "psi"}, energy_names{"kinetic_energy"}, momentum_names{"momentum"},
    momentum_body_names{"momentum_body_1", "momentum_body_2", "momentum_body_3"},
    momentum_space_names{"momentum_space_x", "momentum_space_y", "momentum_space_z"},
    contact_body_names{"contact_body_1", "contact_body_2", "contact_body_3"},
    contact_space_names{"contact_space_x", "contact_space_y", "contact_space_z"},
    residual_names{"residual_contact_plane", "residual_tangency", "residual_slip",
                   "residual_momentum",      "residual_energy",   "residual_unit_quaternion"};

const Quantity rows[] = {
    {"time", "t", "the instant", time_names, second, no_attitude,
     [](Of, At at, Values v) { v[0] = at.state.time_s; }},
    {"omega", "", "ω along the principal axes", omega_names, rad_s, no_attitude,
     [](Of of, At at, Values v) { put(omega_principal(of.inertia, at), v); }},
    {"omega_body", "", "ω in body axes, in which the scene gives its numbers", omega_body_names,
     rad_s, no_attitude, [](Of, At at, Values v) { put(at.state.omega_body, v); }},
    {"q", "", "the attitude space_from_body as a unit quaternion", attitude_names, no_unit,
     attitude, put_quaternion},
    {"herpolhode", "", "ω's component perpendicular to L, in space axes", herpolhode_names, rad_s,
     with_herpolhode, [](Of, At at, Values v) { put(at.herpolhode_space, v); }},
    {"euler", "", "Euler's angles z-x-z of the attitude; a heavy top's φ and ψ are continuous",
     angle_names, rad, with_angles, put_euler_angles},
    {"omega_space", "", "ω in space axes", omega_space_names, rad_s, attitude,
     [](Of, At at, Values v) { put(space_of(at, at.state.omega_body), v); }},
    {"kinetic_energy", "T", "the kinetic energy", energy_names, joule, no_attitude,
     [](Of of, At at, Values v) { v[0] = kinetic_energy_J(of.inertia, at); }},
    {"momentum", "L", "the length |L| of the angular momentum", momentum_names, kg_m2_s,
     no_attitude, [](Of of, At at, Values v) { v[0] = norm_of(momentum_body(of.inertia, at)); }},
    {"momentum_body", "", "L in body axes", momentum_body_names, kg_m2_s, no_attitude,
     [](Of of, At at, Values v) { put(momentum_body(of.inertia, at), v); }},
    {"momentum_space", "", "L in space axes", momentum_space_names, kg_m2_s, attitude,
     [](Of of, At at, Values v) { put(space_of(at, momentum_body(of.inertia, at)), v); }},
    {"contact_body", "rho", "the contact point ρ = ω/√(2T) in body axes", contact_body_names,
     per_sqrt_kg_m2, no_attitude, [](Of of, At at, Values v) { put(contact_body(of, at), v); }},
    {"contact_space", "", "the contact point ρ in space axes", contact_space_names, per_sqrt_kg_m2,
     attitude, [](Of of, At at, Values v) { put(space_of(at, contact_body(of, at)), v); }},
    {"residuals", "", "relative errors against Poinsot's construction; see render --certify",
     residual_names, no_unit, attitude, put_residuals, has_constants,
     "a body that turns without torque"},
};

}  // namespace

std::span<const Quantity> quantities() { return rows; }

std::string name_with_unit(const Quantity& quantity, std::size_t component) {
    const std::string_view name = quantity.components[component];
    return quantity.unit.suffix.empty() ? std::string(name)
                                        : fmt::format("{}_{}", name, quantity.unit.suffix);
}

Eigen::Vector3d omega_principal(const InertiaTensor& inertia, const MotionSample& sample) {
    return inertia.body_from_principal().transpose() * sample.state.omega_body;
}

Eigen::Vector3d momentum_principal(const InertiaTensor& inertia, const MotionSample& sample) {
    return inertia.moments_kg_m2().cwiseProduct(omega_principal(inertia, sample));
}

Eigen::Vector3d momentum_body(const InertiaTensor& inertia, const MotionSample& sample) {
    return inertia.matrix_body() * sample.state.omega_body;
}

double kinetic_energy_J(const InertiaTensor& inertia, const MotionSample& sample) {
    return 0.5 * sample.state.omega_body.dot(momentum_body(inertia, sample));
}

}  // namespace poinsot
