// Keys of the motion: its start, torque and method.
#include <array>
#include <cstring>
#include <numbers>
#include <string_view>
#include <variant>

#include "scene/given_value.h"
#include "scene/scene_draft.h"
#include "scene/scene_key_rows.h"
#include "scene/toml_text.h"

namespace poinsot {

namespace {

using std::size_t;

constexpr std::array<std::string_view, 5> torque_kinds{"none", "gravity", "constant_body",
                                                       "constant_space", "dissipation"};
using std::numbers::pi;

// Texts of values that only some scenes have.
std::string top_text(const Scene& scene, double TopStart::*angle) {
    return scene.start.top ? toml_text((*scene.start.top).*angle) : "";
}

template <typename Kind, typename Value>
std::string torque_text(const Scene& scene, Value Kind::*value) {
    const auto* torque = std::get_if<Kind>(&scene.torque);
    return torque != nullptr ? toml_text(torque->*value) : "";
}

std::string attitude_text(const Scene& scene) {
    const Eigen::Quaterniond& q = scene.start.space_from_body;
    const Eigen::Vector4d attitude(q.w(), q.x(), q.y(), q.z());
    // Compares bits: a component of −0 differs from the default.
    constexpr std::array<double, 4> by_default{1.0, 0.0, 0.0, 0.0};
    const bool is_default = std::memcmp(attitude.data(), by_default.data(), sizeof by_default) == 0;
    return scene.start.top || is_default ? "" : toml_text(attitude);
}

// The second method; its first key creates it.
MethodChoice& beside(SceneDraft& draft) {
    if (!draft.scene.beside) draft.scene.beside.emplace();
    return *draft.scene.beside;
}

template <typename Value>
std::string beside_text(const Scene& scene, std::optional<Value> MethodChoice::*value) {
    return scene.beside ? optional_text((*scene.beside).*value) : "";
}

const SceneKey motion_rows[] = {
    // The state at t = 0, from ω or from the Euler angles of a top.
    {"start.omega_rad_s", "three numbers", "rad/s", "[0.01, 2.0, 0.01]",
     "angular velocity at t = 0, in body axes",
     [](const GivenValue& g, SceneDraft& d) { d.scene.start.omega_rad_s = g.vector(); },
     [](const Scene& s, size_t) { return s.start.top ? "" : toml_text(s.start.omega_rad_s); }},
    {"start.attitude", "four numbers w, x, y, z", "", "[0.5, 0.5, 0.5, 0.5]",
     "space_from_body at t = 0 as a quaternion; default: body and space axes coincide",
     [](const GivenValue& g, SceneDraft& d) { d.attitude = g.four_numbers(); },
     [](const Scene& s, size_t) { return attitude_text(s); }},
    {"start.attitude_matrix", "three rows of three numbers", "",
     "[[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]",
     "space_from_body at t = 0 as a rotation matrix",
     [](const GivenValue& g, SceneDraft& d) { d.attitude_matrix = g.matrix(); },
     [](const Scene&, size_t) { return std::string(); }},  // written as start.attitude
    {"start.theta_rad", "a number from 0 to 3.141592653589793", "rad", "0.7",
     "a top's tilt at t = 0: angle of e3 from the vertical (φ = ψ = 0)",
     [](const GivenValue& g, SceneDraft& d) { d.top.theta_rad = g.number_between(0.0, pi); },
     [](const Scene& s, size_t) { return top_text(s, &TopStart::theta_rad); }},
    {"start.theta_dot_rad_s", "a number", "rad/s", "0.0", "its rate; default 0",
     [](const GivenValue& g, SceneDraft& d) { d.top.theta_dot_rad_s = g.number(); },
     [](const Scene& s, size_t) { return top_text(s, &TopStart::theta_dot_rad_s); }},
    {"start.phi_dot_rad_s", "a number", "rad/s", "0.35",
     "the top's rate of precession at t = 0; default 0",
     [](const GivenValue& g, SceneDraft& d) { d.top.phi_dot_rad_s = g.number(); },
     [](const Scene& s, size_t) { return top_text(s, &TopStart::phi_dot_rad_s); }},
    {"start.omega3_rad_s", "a number", "rad/s", "8.0",
     "the top's spin: component of ω along e3; default 0",
     [](const GivenValue& g, SceneDraft& d) { d.top.omega3_rad_s = g.number(); },
     [](const Scene& s, size_t) { return top_text(s, &TopStart::omega3_rad_s); }},

    // The torque, one kind with its own keys.
    {"torque.kind", "a string", "", R"("gravity")",
     "none, gravity, constant_body, constant_space or dissipation; default none",
     [](const GivenValue& g, SceneDraft& d) { d.torque_kind = g.one_of(torque_kinds); },
     [](const Scene& s, size_t) {
         return s.torque.index() == 0 ? "" : toml_text(torque_kinds.at(s.torque.index()));
     },
     torque_kinds},
    {"torque.mgl_N_m", "a number", "N m", "1.0",
     "gravity: weight times distance of the centre of mass from the fixed point",
     [](const GivenValue& g, SceneDraft& d) { d.gravity.mgl_N_m = g.number(); },
     [](const Scene& s, size_t) { return torque_text(s, &GravityTorque::mgl_N_m); }},
    {"torque.arm_body", "three numbers", "", "[0.0, 0.0, 1.0]",
     "gravity: direction from the fixed point to the centre of mass, body axes; default e3",
     [](const GivenValue& g, SceneDraft& d) { d.gravity.arm_body = g.vector(); },
     [](const Scene& s, size_t) { return torque_text(s, &GravityTorque::arm_body); }},
    {"torque.torque_body_N_m", "three numbers", "N m", "[0.0, 0.0, 0.1]",
     "constant_body: the torque in body axes",
     [](const GivenValue& g, SceneDraft& d) { d.constant_body.torque_body_N_m = g.vector(); },
     [](const Scene& s, size_t) { return torque_text(s, &ConstantBodyTorque::torque_body_N_m); }},
    {"torque.torque_space_N_m", "three numbers", "N m", "[0.0, 0.0, 0.1]",
     "constant_space: the torque in space axes",
     [](const GivenValue& g, SceneDraft& d) { d.constant_space.torque_space_N_m = g.vector(); },
     [](const Scene& s, size_t) { return torque_text(s, &ConstantSpaceTorque::torque_space_N_m); }},
    {"torque.half_life_s", "a positive number", "s", "8.0",
     "dissipation: time until half of the energy is gone that friction inside the body can take, "
     "T − L²/(2 I_max); L is kept",
     [](const GivenValue& g, SceneDraft& d) { d.scene.half_life_s = g.positive(); },
     [](const Scene& s, size_t) { return optional_text(s.half_life_s); }},
    {"torque.rate_1_s", "a positive number", "1/s", "0.05",
     "dissipation, instead: the friction constant κ over a third of the trace of the moments; how "
     "fast T then falls depends on the start, see half_life_s",
     [](const GivenValue& g, SceneDraft& d) { d.dissipation.rate_1_s = g.positive(); },
     [](const Scene& s, size_t) {
         return s.half_life_s ? "" : torque_text(s, &DissipationTorque::rate_1_s);
     }},

    // How the motion is computed.
    {"motion.method", "a string", "", R"("exact")",
     "how the motion is computed, see `poinsot list methods`; default exact",
     [](const GivenValue& g, SceneDraft& d) { d.scene.method.name = g.text(); },
     [](const Scene& s, size_t) { return toml_text(std::string_view(s.method.name)); }},
    {"motion.step_s", "a positive number", "s", "0.01",
     "step of a stepping method; default: chosen from accuracy_px",
     [](const GivenValue& g, SceneDraft& d) { d.scene.method.step_s = g.positive(); },
     [](const Scene& s, size_t) { return optional_text(s.method.step_s); }},
    {"motion.tolerance", "a number from 1e-300 to 1", "", "1e-9",
     "relative error of an adaptive method; default: chosen from accuracy_px",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.method.tolerance = g.number_between(1e-300, 1.0);
     },
     [](const Scene& s, size_t) { return optional_text(s.method.tolerance); }},
    {"motion.order", "an integer from 1 to 20", "", "4", "order of a method that comes in several",
     [](const GivenValue& g, SceneDraft& d) { d.scene.method.order = g.integer_between(1, 20); },
     [](const Scene& s, size_t) { return optional_text(s.method.order); }},

    // The same motion by a second method, as a ghost.
    {"beside.method", "a string", "", R"("euler")",
     "a second method whose motion is drawn beside the first as a ghost; default: none",
     [](const GivenValue& g, SceneDraft& d) { beside(d).name = g.text(); },
     [](const Scene& s, size_t) {
         return s.beside ? toml_text(std::string_view(s.beside->name)) : "";
     }},
    {"beside.step_s", "a positive number", "s", "0.05",
     "its step; default: a 200th of the shortest turn",
     [](const GivenValue& g, SceneDraft& d) { beside(d).step_s = g.positive(); },
     [](const Scene& s, size_t) { return beside_text(s, &MethodChoice::step_s); }},
    {"beside.tolerance", "a number from 1e-300 to 1", "", "1e-4",
     "its relative error if it is adaptive; default 1e-9",
     [](const GivenValue& g, SceneDraft& d) {
         beside(d).tolerance = g.number_between(1e-300, 1.0);
     },
     [](const Scene& s, size_t) { return beside_text(s, &MethodChoice::tolerance); }},
    {"beside.order", "an integer from 1 to 20", "", "4", "its order if it comes in several",
     [](const GivenValue& g, SceneDraft& d) { beside(d).order = g.integer_between(1, 20); },
     [](const Scene& s, size_t) { return beside_text(s, &MethodChoice::order); }},
};

}  // namespace

std::span<const SceneKey> motion_keys() { return motion_rows; }

}  // namespace poinsot
