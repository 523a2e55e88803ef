// Keys of the motion: its start, torque and method.
#include <array>
#include <numbers>
#include <string_view>

#include "scene/scene_key_rows.h"

namespace poinsot {

namespace {

constexpr auto names_of_torques = [] {
    std::array<std::string_view, torque_kinds.size()> names;
    for (std::size_t k = 0; k < names.size(); ++k) names[k] = torque_kinds[k].key;
    return names;
}();
constexpr Bounds not_negative{0.0, std::nullopt};
using std::numbers::pi;

constexpr auto top(double TopStart::*member) { return in(&SceneDraft::top, member); }
auto top_text(double TopStart::*member) {
    return key_rows::from(in(&Scene::start, &StartSpec::top, member));
}

// A number of one kind of torque.
template <typename Kind, typename Value>
constexpr auto of(Value Kind::*member) {
    return TorquePlace<Kind, Value>(member);
}

// ω, or what chooses it: its direction and the conserved quantities.
std::string omega_text(const Scene& scene, std::size_t) {
    if (scene.start.top) return "";
    const ConservedStartSpec* conserved = scene.start.given_by_conserved();
    if (conserved == nullptr) return toml_text(scene.start.omega_rad_s);
    return conserved->direction_rad_s ? toml_text(*conserved->direction_rad_s) : "";
}
template <typename Value>
auto conserved_text(Value ConservedQuantities::*value) {
    return [value](const Scene& scene, std::size_t) -> std::string {
        const ConservedStartSpec* conserved = scene.start.given_by_conserved();
        return conserved != nullptr ? key_rows::text_of(conserved->quantities.*value) : "";
    };
}

std::string torque_kind_text(const Scene& scene, std::size_t) {
    return toml_text(kind_of(scene.torque).key);
}

std::string attitude_text(const Scene& scene, std::size_t) {
    const Eigen::Quaterniond& q = scene.start.space_from_body;
    // As text, a component of −0 differs from the default.
    const std::string text = toml_text(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()));
    return scene.start.top || text == "[1.0, 0.0, 0.0, 0.0]" ? "" : text;
}

template <typename Value>
constexpr auto method(Value MethodChoice::*member) {
    return in(&Scene::method, member);
}
// The second method; its first key creates it.
template <typename Value>
constexpr auto beside(Value MethodChoice::*member) {
    return in(&Scene::beside, member);
}

}  // namespace

std::span<const SceneKey> motion_keys() {
    using namespace key_rows;
    constexpr Bounds tolerances = within(1e-300, 1.0), orders = within(1, 20);
    static const SceneKey rows[] = {
        // The state at t = 0, from ω or from the Euler angles of a top.
        numbers(
            "start.omega_rad_s", in(&Scene::start, &StartSpec::omega_rad_s), no_bounds, "rad/s",
            "[0.01, 2.0, 0.01]",
            "angular velocity at t = 0, in body axes; with energy_J, only its direction matters")
            .without_default()
            .written_by(omega_text),
        number("start.energy_J", &SceneDraft::energy_J, positive, "J", "2.0",
               "kinetic energy T at t = 0; with momentum_kg_m2_s or plane_distance it sets the "
               "polhode, and "
               "omega_rad_s sets only the point of the polhode where the motion starts")
            .default_is("that of omega_rad_s")
            .written_by(conserved_text(&ConservedQuantities::energy_J)),
        number("start.momentum_kg_m2_s", &SceneDraft::momentum_kg_m2_s, positive, "kg m²/s", "2.8",
               "length of the angular momentum L; needs energy_J")
            .without_default()
            .written_by(conserved_text(&ConservedQuantities::momentum_kg_m2_s)),
        number(
            "start.plane_distance", &SceneDraft::plane_distance, positive, "", "0.71",
            "distance √(2T)/L of the invariable plane from the centre, in 1/√(kg m²), instead of "
            "momentum_kg_m2_s; needs energy_J")
            .without_default()
            .written_by(conserved_text(&ConservedQuantities::plane_distance)),
        numbers("start.attitude", &SceneDraft::attitude, no_bounds, "", "[0.5, 0.5, 0.5, 0.5]",
                "rotation from body axes to space axes at t = 0, as a quaternion")
            .values_named("w, x, y, z")
            .default_is("no rotation")
            .written_by(attitude_text),
        numbers("start.attitude_matrix", &SceneDraft::attitude_matrix, no_bounds, "",
                "[[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]",
                "the same rotation as a matrix, instead of attitude")
            .written_by([](const Scene&, std::size_t) { return ""; }),  // start.attitude writes it
        number("start.theta_rad", top(&TopStart::theta_rad), within(0.0, pi), "rad", "0.7",
               "heavy top: tilt θ at t = 0, the angle of e3 from the vertical; φ and ψ are 0")
            .without_default()
            .written_by(top_text(&TopStart::theta_rad)),
        number("start.theta_dot_rad_s", top(&TopStart::theta_dot_rad_s), no_bounds, "rad/s", "0.0",
               "heavy top: rate of change of θ at t = 0")
            .written_by(top_text(&TopStart::theta_dot_rad_s)),
        number("start.phi_dot_rad_s", top(&TopStart::phi_dot_rad_s), no_bounds, "rad/s", "0.35",
               "heavy top: rate of precession at t = 0")
            .written_by(top_text(&TopStart::phi_dot_rad_s)),
        number("start.omega3_rad_s", top(&TopStart::omega3_rad_s), no_bounds, "rad/s", "8.0",
               "heavy top: spin, the component of ω along e3")
            .written_by(top_text(&TopStart::omega3_rad_s)),

        // The torque, one kind with its own keys.
        one_of("torque.kind", &SceneDraft::torque_kind, names_of_torques, R"("gravity")",
               "kind of torque on the body")
            .written_by(torque_kind_text)
            .omitted_if_default(),
        number("torque.mgl_N_m", of(&Gravity::mgl_N_m), no_bounds, "N m", "1.0",
               "gravity: weight times the distance of the centre of mass from the fixed point")
            .without_default()
            .needed_by_torque(),
        numbers("torque.arm_body", of(&Gravity::arm_body), no_bounds, "", "[0.0, 0.0, 1.0]",
                "gravity: direction from the fixed point to the centre of mass, in body axes")
            .default_is("e3"),
        numbers("torque.torque_body_N_m", of(&ConstantTorqueInBody::torque_body_N_m), no_bounds,
                "N m", "[0.0, 0.0, 0.1]", "constant_body: the torque in body axes")
            .without_default()
            .needed_by_torque(),
        numbers("torque.torque_space_N_m", of(&ConstantTorqueInSpace::torque_space_N_m), no_bounds,
                "N m", "[0.0, 0.0, 0.1]", "constant_space: the torque in space axes")
            .without_default()
            .needed_by_torque(),
        number("torque.half_life_s", &Scene::half_life_s, positive, "s", "8.0",
               "dissipation: time in which the energy that friction can take, T − L²/(2 I_max), "
               "falls to one half; L is conserved")
            .of_torque(index_of_torque<InternalFriction>)
            .needed_by_torque(),
        number("torque.rate_1_s", of(&InternalFriction::rate_1_s), positive, "1/s", "0.05",
               "dissipation, instead of half_life_s: friction constant κ divided by (I1 + I2 + "
               "I3)/3; the rate at which T falls depends on the start")
            .without_default()
            .needed_by_torque()
            .written_if([](const Scene& scene) { return !scene.half_life_s; }),
        numbers("torque.linear_1_s", of(&Drag::linear_1_s), not_negative, "1/s", "[0.2, 0.1, 0.1]",
                "drag of the air: rates a_i of the torque −(a_i + b_i|ω_i|) I_i ω_i along the "
                "principal axes e1, e2, e3")
            .default_is("0 if quadratic_1_rad is given")
            .needed_by_torque(),
        numbers("torque.quadratic_1_rad", of(&Drag::quadratic_1_rad), not_negative, "1/rad",
                "[0.02, 0.01, 0.01]", "drag of the air: its b_i")
            .default_is("0 if linear_1_s is given")
            .needed_by_torque(),
        number("torque.growth_1_s", of(&Drag::growth_1_s), no_bounds, "1/s", "1.5",
               "drag of the air: its torque grows as e^(growth·t), as that of a body that falls "
               "faster and faster; below 0 it falls")
            .default_is("0"),

        // How the motion is computed.
        text("motion.method", method(&MethodChoice::name), R"("exact")",
             "method that computes the motion")
            .from_list("methods"),
        number("motion.step_s", method(&MethodChoice::step_s), positive, "s", "0.01",
               "time step, for methods with a fixed step")
            .default_is("chosen to meet accuracy_px"),
        number("motion.tolerance", method(&MethodChoice::tolerance), tolerances, "", "1e-9",
               "relative error tolerance, for adaptive methods")
            .default_is("chosen to meet accuracy_px"),
        integer("motion.order", method(&MethodChoice::order), orders, "4",
                "order, for methods that offer several"),

        // The same motion by a second method, as a ghost.
        text("beside.method", beside(&MethodChoice::name), R"("euler")",
             "second method, whose motion is drawn as a ghost")
            .from_list("methods")
            .default_is("none"),
        number("beside.step_s", beside(&MethodChoice::step_s), positive, "s", "0.05",
               "time step of the second method")
            .default_is("1/200 of the shortest period of rotation"),
        number("beside.tolerance", beside(&MethodChoice::tolerance), tolerances, "", "1e-4",
               "relative error tolerance of the second method, if it is adaptive")
            .default_is("1e-9"),
        integer("beside.order", beside(&MethodChoice::order), orders, "4",
                "order of the second method, if it offers several"),

        // A motion that an instrument or another program recorded.
        text("measured.file", in(&Scene::measured, &MeasuredSpec::file), R"("gyro.csv")",
             "table (CSV) in the scene's folder with a measured motion, which is drawn beside that "
             "of the scene: columns as for `poinsot fit`, ω and attitude in the scene's body axes"),
    };
    return rows;
}

}  // namespace poinsot
