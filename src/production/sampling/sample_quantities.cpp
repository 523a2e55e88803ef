// The table of quantities that can be sampled, each with its columns, and their selection by name.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "error/error.h"
#include "mechanics/euler_angles.h"
#include "production/sampling/sampled_motion.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace poinsot {

namespace {

using Values = double*;
using Of = const SampledMotion&;
using At = const MotionSample&;

void put(const Eigen::Vector3d& vector, Values values) {
    for (int i = 0; i < 3; ++i) values[i] = vector[i];
}

Eigen::Vector3d space_of(At at, const Eigen::Vector3d& body) {
    return at.state.space_from_body * body;
}

Eigen::Vector3d momentum_body(Of of, At at) { return of.tensor_body * at.state.omega_body; }

// ρ = ω/√(2T) with the T of the instant, scaled by a power of two so that nothing overflows.
Eigen::Vector3d contact_body(Of of, At at) {
    const Eigen::Vector3d& omega = at.state.omega_body;
    const double largest = omega.cwiseAbs().maxCoeff();
    if (!(largest > 0.0))
        throw InputError("a body at rest touches no invariable plane; leave contact out");
    int exponent = 0;
    std::frexp(largest, &exponent);
    const Eigen::Vector3d scaled =
        omega.unaryExpr([exponent](double w) { return std::ldexp(w, -exponent); });
    return scaled / std::sqrt(scaled.dot(of.tensor_body * scaled));
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

constexpr std::array<SampleColumn, 1> time_columns{{{"time", "s"}}};
constexpr std::array<SampleColumn, 3> omega_body_columns{
    {{"omega_body_1", "rad_s"}, {"omega_body_2", "rad_s"}, {"omega_body_3", "rad_s"}}};
constexpr std::array<SampleColumn, 3> omega_space_columns{
    {{"omega_space_x", "rad_s"}, {"omega_space_y", "rad_s"}, {"omega_space_z", "rad_s"}}};
constexpr std::array<SampleColumn, 4> attitude_columns{
    {{"q_w", ""}, {"q_x", ""}, {"q_y", ""}, {"q_z", ""}}};
constexpr std::array<SampleColumn, 3> herpolhode_columns{
    {{"herpolhode_x", "rad_s"}, {"herpolhode_y", "rad_s"}, {"herpolhode_z", "rad_s"}}};
constexpr std::array<SampleColumn, 3> angle_columns{
    {{"theta", "rad"}, {"phi", "rad"}, {"psi", "rad"}}};
constexpr std::array<SampleColumn, 1> energy_columns{{{"kinetic_energy", "J"}}};
constexpr std::array<SampleColumn, 1> momentum_columns{{{"momentum", "kg_m2_s"}}};
constexpr std::array<SampleColumn, 3> momentum_body_columns{{{"momentum_body_1", "kg_m2_s"},
                                                             {"momentum_body_2", "kg_m2_s"},
                                                             {"momentum_body_3", "kg_m2_s"}}};
constexpr std::array<SampleColumn, 3> momentum_space_columns{{{"momentum_space_x", "kg_m2_s"},
                                                              {"momentum_space_y", "kg_m2_s"},
                                                              {"momentum_space_z", "kg_m2_s"}}};
// Lengths of the construction are in 1/√(kg m²).
constexpr std::array<SampleColumn, 3> contact_body_columns{{{"contact_body_1", "per_sqrt_kg_m2"},
                                                            {"contact_body_2", "per_sqrt_kg_m2"},
                                                            {"contact_body_3", "per_sqrt_kg_m2"}}};
constexpr std::array<SampleColumn, 3> contact_space_columns{
    {{"contact_space_x", "per_sqrt_kg_m2"},
     {"contact_space_y", "per_sqrt_kg_m2"},
     {"contact_space_z", "per_sqrt_kg_m2"}}};
constexpr std::array<SampleColumn, 6> residual_columns{{{"residual_contact_plane", ""},
                                                        {"residual_tangency", ""},
                                                        {"residual_slip", ""},
                                                        {"residual_momentum", ""},
                                                        {"residual_energy", ""},
                                                        {"residual_unit_quaternion", ""}}};

bool turns_freely(const Motion& motion) {
    return std::holds_alternative<NoTorque>(motion.problem().torque) &&
           !motion.problem().start.omega_body.isZero(0.0);
}

constexpr Quantities no_attitude{.attitude = false};
constexpr Quantities attitude{};

const std::array<SampleQuantity, 13> sample_rows{{
    {"time", "the instant", time_columns, no_attitude, nullptr, "",
     [](Of, At at, Values v) { v[0] = at.state.time_s; }},
    {"omega_body", "ω in body axes; also called omega", omega_body_columns, no_attitude, nullptr,
     "", [](Of, At at, Values v) { put(at.state.omega_body, v); }},
    {"q", "the attitude space_from_body as a unit quaternion", attitude_columns, attitude, nullptr,
     "",
     [](Of, At at, Values v) {
         const Eigen::Quaterniond& q = at.state.space_from_body;
         v[0] = q.w();
         put(q.vec(), v + 1);
     }},
    {"herpolhode",
     "ω's component perpendicular to L, in space axes",
     herpolhode_columns,
     {.attitude = true, .herpolhode = true},
     nullptr,
     "",
     [](Of, At at, Values v) { put(at.herpolhode_space, v); }},
    {"euler",
     "Euler's angles z-x-z of the attitude; a heavy top's φ and ψ are continuous",
     angle_columns,
     {.attitude = true, .euler_angles = true},
     nullptr,
     "",
     put_euler_angles},
    {"omega_space", "ω in space axes", omega_space_columns, attitude, nullptr, "",
     [](Of, At at, Values v) { put(space_of(at, at.state.omega_body), v); }},
    {"kinetic_energy", "the kinetic energy; also called T", energy_columns, no_attitude, nullptr,
     "",
     [](Of of, At at, Values v) { v[0] = 0.5 * at.state.omega_body.dot(momentum_body(of, at)); }},
    {"momentum", "the length |L| of the angular momentum; also called L", momentum_columns,
     no_attitude, nullptr, "",
     [](Of of, At at, Values v) { v[0] = momentum_body(of, at).stableNorm(); }},
    {"momentum_body", "L in body axes", momentum_body_columns, no_attitude, nullptr, "",
     [](Of of, At at, Values v) { put(momentum_body(of, at), v); }},
    {"momentum_space", "L in space axes", momentum_space_columns, attitude, nullptr, "",
     [](Of of, At at, Values v) { put(space_of(at, momentum_body(of, at)), v); }},
    {"contact_body", "the contact point ρ = ω/√(2T) in body axes; also called rho",
     contact_body_columns, no_attitude, nullptr, "",
     [](Of of, At at, Values v) { put(contact_body(of, at), v); }},
    {"contact_space", "the contact point ρ in space axes", contact_space_columns, attitude, nullptr,
     "", [](Of of, At at, Values v) { put(space_of(at, contact_body(of, at)), v); }},
    {"residuals", "relative errors against Poinsot's construction; see render --certify",
     residual_columns, attitude, turns_freely, "a body that turns without torque", put_residuals},
}};

std::string heading_of(const SampleColumn& column) {
    return column.unit.empty() ? std::string(column.name)
                               : fmt::format("{}_{}", column.name, column.unit);
}

const SampleQuantity& quantity_named(std::string_view name) {
    return *std::find_if(sample_rows.begin(), sample_rows.end(),
                         [name](const SampleQuantity& quantity) { return quantity.name == name; });
}

// The lecture's symbols, accepted as names.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> symbols{
    {{"T", "kinetic_energy"}, {"L", "momentum"}, {"omega", "omega_body"}, {"rho", "contact_body"}}};

// The columns of a name: all of a quantity's, or one. Empty for an unknown name.
std::vector<ChosenColumn> columns_called(std::string_view name) {
    for (const auto& [symbol, meant] : symbols)
        if (name == symbol) name = meant;
    std::vector<ChosenColumn> found;
    for (const SampleQuantity& quantity : sample_rows) {
        for (std::size_t i = 0; i < quantity.columns.size(); ++i) {
            const SampleColumn& column = quantity.columns[i];
            if (name == quantity.name || name == column.name || name == heading_of(column))
                found.push_back({&quantity, i, heading_of(column)});
        }
        if (!found.empty()) return found;
    }
    return found;
}

[[noreturn]] void throw_unknown(std::string_view name) {
    std::vector<std::string_view> known;
    for (const SampleQuantity& quantity : sample_rows) {
        known.push_back(quantity.name);
        for (const SampleColumn& column : quantity.columns) known.push_back(column.name);
    }
    throw InputError(
        fmt::format("--columns: no column is called \"{}\"{}; poinsot list columns names all",
                    printable(name), did_you_mean(name, known)));
}

}  // namespace

std::span<const SampleQuantity> sample_quantities() { return sample_rows; }

std::vector<ChosenColumn> default_columns(const Motion& motion) {
    std::vector<ChosenColumn> columns;
    // These headings have no units, for compatibility with existing scripts.
    const auto take = [&columns](std::string_view name, bool with_unit) {
        const SampleQuantity& quantity = quantity_named(name);
        for (std::size_t i = 0; i < quantity.columns.size(); ++i)
            columns.push_back({&quantity, i,
                               with_unit ? heading_of(quantity.columns[i])
                                         : std::string(quantity.columns[i].name)});
    };
    take("time", true);
    take("omega_body", false);
    take("q", false);
    take("herpolhode", false);
    if (motion.regime() == Regime::heavy_top) take("euler", true);
    return columns;
}

std::vector<ChosenColumn> columns_named(const Motion& motion, std::span<const std::string> names) {
    std::vector<ChosenColumn> columns;
    for (const std::string& name : names) {
        const std::vector<ChosenColumn> called = columns_called(name);
        if (called.empty()) throw_unknown(name);
        for (const ChosenColumn& column : called) {
            const SampleQuantity& quantity = *column.quantity;
            if (quantity.offered != nullptr && !quantity.offered(motion))
                throw InputError(fmt::format("--columns: only {} has {}; leave it out",
                                             quantity.offered_by, quantity.name));
            const bool twice = std::any_of(
                columns.begin(), columns.end(),
                [&column](const ChosenColumn& other) { return other.heading == column.heading; });
            if (twice)
                throw InputError(
                    fmt::format("--columns: {} is given twice; leave one out", column.heading));
            columns.push_back(column);
        }
    }
    return columns;
}

}  // namespace poinsot
