// The table of torques: what is known of each kind. Its law is in torque.cpp, and its numbers are
// in poinsot/torque.h.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "mechanics/poinsot/torque.h"

namespace poinsot {

struct TorqueKind {
    std::string_view key;         // torque.kind of a scene
    std::string_view name;        // in messages
    bool acts = false;            // N is not zero; internal friction is not a torque
    bool keeps_momentum = false;  // L in space is constant
    bool has_potential = false;   // T and the potential together are constant
    bool takes_energy = false;    // T falls, and the body turns ever more steadily
};

// A number of a torque or three, by the name that scenes and Python give it.
template <typename Kind, typename Value>
struct TorqueNumber {
    std::string_view name;
    Value Kind::*member;
};
// clang 14 needs it.
template <typename Kind, typename Value>
TorqueNumber(std::string_view, Value Kind::*) -> TorqueNumber<Kind, Value>;

// One row a kind, and its numbers: without them, the table of a new kind does not compile.
template <typename Kind>
struct KindOfTorque;
template <>
struct KindOfTorque<NoTorque> {
    static constexpr TorqueKind row{
        .key = "none", .name = "none", .keeps_momentum = true, .has_potential = true};
    static constexpr std::tuple<> numbers{};
};
template <>
struct KindOfTorque<Gravity> {
    static constexpr TorqueKind row{
        .key = "gravity", .name = "gravity", .acts = true, .has_potential = true};
    static constexpr std::tuple numbers{TorqueNumber{"mgl_N_m", &Gravity::mgl_N_m},
                                        TorqueNumber{"arm_body", &Gravity::arm_body}};
};
template <>
struct KindOfTorque<ConstantTorqueInBody> {
    static constexpr TorqueKind row{
        .key = "constant_body", .name = "constant in the body", .acts = true};
    static constexpr std::tuple numbers{
        TorqueNumber{"torque_body_N_m", &ConstantTorqueInBody::torque_body_N_m}};
};
template <>
struct KindOfTorque<ConstantTorqueInSpace> {
    static constexpr TorqueKind row{
        .key = "constant_space", .name = "constant in space", .acts = true};
    static constexpr std::tuple numbers{
        TorqueNumber{"torque_space_N_m", &ConstantTorqueInSpace::torque_space_N_m}};
};
template <>
struct KindOfTorque<InternalFriction> {
    static constexpr TorqueKind row{.key = "dissipation",
                                    .name = "internal friction",
                                    .keeps_momentum = true,
                                    .takes_energy = true};
    static constexpr std::tuple numbers{TorqueNumber{"rate_1_s", &InternalFriction::rate_1_s}};
};
template <>
struct KindOfTorque<Drag> {
    static constexpr TorqueKind row{
        .key = "drag", .name = "drag of the air", .acts = true, .takes_energy = true};
    static constexpr std::tuple numbers{TorqueNumber{"linear_1_s", &Drag::linear_1_s},
                                        TorqueNumber{"quadratic_1_rad", &Drag::quadratic_1_rad},
                                        TorqueNumber{"growth_1_s", &Drag::growth_1_s}};
};

// In the order of the variant.
inline constexpr auto torque_kinds = []<std::size_t... k>(std::index_sequence<k...>) {
    return std::array{KindOfTorque<std::variant_alternative_t<k, Torque>>::row...};
}
(std::make_index_sequence<std::variant_size_v<Torque>>());

// The row of a kind.
template <typename Kind>
inline constexpr std::size_t index_of_torque = []<std::size_t... k>(std::index_sequence<k...>) {
    return ((std::is_same_v<Kind, std::variant_alternative_t<k, Torque>> ? k : 0) + ...);
}
(std::make_index_sequence<std::variant_size_v<Torque>>());

inline const TorqueKind& kind_of(const Torque& torque) { return torque_kinds[torque.index()]; }

// Nothing acts, neither from outside nor inside the body.
inline bool is_free(const Torque& torque) {
    const TorqueKind& kind = kind_of(torque);
    return !kind.acts && !kind.takes_energy;
}
// Gravity: a torque of a potential.
inline bool has_weight(const Torque& torque) {
    return kind_of(torque).acts && kind_of(torque).has_potential;
}
// L stays, and T falls.
inline bool has_friction(const Torque& torque) {
    return kind_of(torque).takes_energy && kind_of(torque).keeps_momentum;
}
// Friction or drag: T falls.
inline bool dissipates(const Torque& torque) { return kind_of(torque).takes_energy; }
// Drag of the air: |L| falls too.
inline bool is_slowed(const Torque& torque) {
    return kind_of(torque).takes_energy && !kind_of(torque).keeps_momentum;
}
// There is an invariable plane on which the ellipsoid rolls, at a distance that friction or drag
// changes.
inline bool rolls(const Torque& torque) { return is_free(torque) || dissipates(torque); }

}  // namespace poinsot
