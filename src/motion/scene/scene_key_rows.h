// The rows of the table of scene keys, section by section, and the functions that make rows. A row
// names the member that holds the value and the type; reading and writing follow from these.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "scene/given_value.h"
#include "scene/scene_draft.h"
#include "scene/scene_keys.h"
#include "scene/toml/toml_text.h"

namespace poinsot {

// In the order in which they are listed and written.
std::span<const SceneKey> picture_keys();
std::span<const SceneKey> name_keys();
std::span<const SceneKey> body_keys();
std::span<const SceneKey> motion_keys();
std::span<const SceneKey> film_keys();
std::span<const SceneKey> camera_keys();
std::span<const SceneKey> story_keys();
std::span<const SceneKey> panel_keys();
std::span<const SceneKey> style_keys();
std::span<const SceneKey> mark_keys();

// A default-constructed draft with one item in every array of tables.
const SceneDraft& draft_by_default();

// The ranges of every camera. Beyond the largest distance of a camera the figure would be
// invisible; a target much farther away would exhaust double precision.
inline constexpr Bounds elevations_deg = within(-90.0, 90.0);
inline constexpr Bounds distances = within(0.01, 10000.0);
inline constexpr Bounds fields_deg = within(0.1, 150.0);
inline constexpr Bounds coordinates = within(-10000.0, 10000.0);  // of the target

// The path of members from a Scene or a SceneDraft to a value. At an array of tables the path goes
// through the item with the given index.
template <typename Root, typename... Members>
class Place {
 public:
    explicit constexpr Place(Members... members) : members_(members...) {}

    // Creates optional members on the path.
    auto& in(SceneDraft& draft, std::size_t item) const {
        return std::apply(
            [&](auto... members) -> auto& {
                if constexpr (std::is_same_v<Root, Scene>)
                    return made(draft.scene, item, members...);
                else
                    return made(draft, item, members...);
            },
            members_);
    }
    // Null if an optional member on the path is absent.
    const auto* in(const Root& root, std::size_t item) const {
        return std::apply([&](auto... members) { return found(root, item, members...); }, members_);
    }

 private:
    template <typename Whole, typename Member, typename... Rest>
    static auto& made(Whole& whole, std::size_t item, Member member, Rest... rest) {
        if constexpr (requires { whole.at(item).*member; })
            return made(whole.at(item).*member, item, rest...);
        else if constexpr (requires { (*whole).*member; }) {
            if (!whole) whole.emplace();
            return made((*whole).*member, item, rest...);
        } else
            return made(whole.*member, item, rest...);
    }
    template <typename Value>
    static auto& made(Value& value, std::size_t) {
        return value;
    }

    template <typename Whole, typename Member, typename... Rest>
    static const auto* found(const Whole& whole, std::size_t item, Member member, Rest... rest) {
        if constexpr (requires { whole.at(item).*member; })
            return found(whole.at(item).*member, item, rest...);
        else if constexpr (requires { (*whole).*member; }) {
            using Found = decltype(found((*whole).*member, item, rest...));
            return whole ? found((*whole).*member, item, rest...) : Found{nullptr};
        } else
            return found(whole.*member, item, rest...);
    }
    template <typename Value>
    static const Value* found(const Value& value, std::size_t) {
        return &value;
    }

    std::tuple<Members...> members_;
};

template <typename Root, typename Value, typename... Members>
constexpr auto in(Value Root::*first, Members... members) {
    return Place<Root, Value Root::*, Members...>(first, members...);
}

// A number of one kind of torque.
template <typename Kind, typename Value>
class TorquePlace {
 public:
    static constexpr std::size_t kind = index_of_torque<Kind>;

    explicit constexpr TorquePlace(Value Kind::*member) : member_(member) {}

    Value& in(SceneDraft& draft, std::size_t /*item*/) const {
        return std::get<Kind>(draft.torques).*member_;
    }
    const Value* in(const SceneDraft& draft, std::size_t /*item*/) const {
        return &(std::get<Kind>(draft.torques).*member_);
    }
    // Null if the torque is of another kind.
    const Value* in(const Scene& scene, std::size_t /*item*/) const {
        const Kind* torque = std::get_if<Kind>(&scene.torque);
        return torque != nullptr ? &(torque->*member_) : nullptr;
    }

 private:
    Value Kind::*member_;
};

namespace key_rows {

template <typename Kind, typename Value>
constexpr auto place_of(const TorquePlace<Kind, Value>& place) {
    return place;
}
template <typename Root, typename... Members>
constexpr auto place_of(const Place<Root, Members...>& place) {
    return place;
}
template <typename Root, typename Value>
constexpr auto place_of(Value Root::*member) {
    return in(member);
}

// Reads a value of the row's type.
inline void take(const GivenValue& given, bool& value) { value = given.boolean(); }
inline void take(const GivenValue& given, double& value) { value = given.number(); }
inline void take(const GivenValue& given, int& value) { value = given.integer(); }
inline void take(const GivenValue& given, std::string& value) { value = given.text(); }
inline void take(const GivenValue& given, std::vector<std::string>& value) {
    value = given.texts();
}
inline void take(const GivenValue& given, std::vector<double>& value) { value = given.numbers(); }
inline void take(const GivenValue& given, Eigen::Matrix3d& value) { value = given.matrix(); }
template <int n>
void take(const GivenValue& given, Eigen::Matrix<double, n, 1>& value) {
    value = Eigen::Map<const Eigen::Matrix<double, n, 1>>(given.numbers().data());
}
template <typename Value>
void take(const GivenValue& given, std::optional<Value>& value) {
    Value taken{};
    take(given, taken);
    value = std::move(taken);
}

// Returns a value as TOML text.
template <typename Value>
std::string text_of(const Value& value) {
    if constexpr (std::is_same_v<Value, std::string>)
        return toml_text(std::string_view(value));
    else if constexpr (std::is_same_v<Value, std::vector<std::string>>)
        return toml_text(std::span<const std::string>(value));
    else if constexpr (std::is_same_v<Value, std::vector<double>>)
        return toml_text(std::span<const double>(value));
    else
        return toml_text(value);
}
template <typename Value>
std::string text_of(const std::optional<Value>& value) {
    return value ? text_of(*value) : "";
}

// Returns a function that writes the value at this place.
template <typename Where>
auto from(Where where) {
    return [place = place_of(where)](const Scene& scene, std::size_t item) {
        const auto* value = place.in(scene, item);
        return value != nullptr ? text_of(*value) : "";
    };
}

// A row of any type.
template <typename Where>
SceneKey row(std::string_view path, Where where, const ValueType& type, std::string_view example,
             std::string_view summary) {
    const auto place = place_of(where);
    SceneKey key{path, type, example, summary};
    key.read = [place](const GivenValue& given, SceneDraft& draft) {
        take(given, place.in(draft, given.item()));
    };
    const auto initial = [&place](const auto& root) {
        const auto* value = place.in(root, 0);
        return value != nullptr ? text_of(*value) : "";
    };
    if constexpr (requires { decltype(place)::kind; }) {
        key.value = from(place);
        key.initial = initial(draft_by_default());
        key.torque_kind = decltype(place)::kind;
    } else if constexpr (requires(const Scene& scene) { place.in(scene, 0); }) {
        key.value = from(place);
        key.initial = initial(draft_by_default().scene);
    } else
        key.initial = initial(draft_by_default());
    key.omits_initial = key.initial == "\"\"" || key.initial == "[]";
    return key;
}

// A row without a member, for read_by and written_by.
inline SceneKey row(std::string_view path, const ValueType& type, std::string_view example,
                    std::string_view summary) {
    return {path, type, example, summary};
}

template <typename Where>
SceneKey boolean(std::string_view path, Where where, std::string_view example,
                 std::string_view summary) {
    return row(path, where, {.kind = ValueType::Kind::boolean}, example, summary);
}

template <typename Where>
SceneKey number(std::string_view path, Where where, Bounds bounds, std::string_view unit,
                std::string_view example, std::string_view summary) {
    return row(path, where, {.kind = ValueType::Kind::number, .bounds = bounds, .unit = unit},
               example, summary);
}

template <typename Where>
SceneKey integer(std::string_view path, Where where, Bounds bounds, std::string_view example,
                 std::string_view summary) {
    return row(path, where, {.kind = ValueType::Kind::integer, .bounds = bounds}, example, summary);
}

template <typename Where>
SceneKey text(std::string_view path, Where where, std::string_view example,
              std::string_view summary) {
    return row(path, where, {.kind = ValueType::Kind::text}, example, summary);
}

template <typename Where>
SceneKey one_of(std::string_view path, Where where, std::span<const std::string_view> names,
                std::string_view example, std::string_view summary) {
    return row(path, where, {.kind = ValueType::Kind::text, .names = names}, example, summary);
}

template <typename Where>
SceneKey texts(std::string_view path, Where where, std::string_view example,
               std::string_view summary) {
    return row(path, where, {.kind = ValueType::Kind::text, .size = ValueType::Size{}}, example,
               summary);
}

// The member's C++ type gives the number of values: a vector, a matrix or a list of any size.
template <typename Where>
SceneKey numbers(std::string_view path, Where where, Bounds bounds, std::string_view unit,
                 std::string_view example, std::string_view summary) {
    using Value = std::remove_cvref_t<decltype(place_of(where).in(std::declval<SceneDraft&>(), 0))>;
    const auto count = [](auto is) {
        using Is = typename decltype(is)::type;
        return std::is_same_v<Value, Is> || std::is_same_v<Value, std::optional<Is>>;
    };
    ValueType type{.kind = ValueType::Kind::number, .bounds = bounds, .unit = unit};
    type.size = ValueType::Size{};
    if (count(std::type_identity<Eigen::Vector3d>())) type.size = {3, 3};
    if (count(std::type_identity<Eigen::Vector4d>())) type.size = {4, 4};
    if (count(std::type_identity<Eigen::Matrix3d>())) {
        type.size = {3, 3};
        type.n_rows = 3;
    }
    return row(path, where, type, example, summary);
}

}  // namespace key_rows

}  // namespace poinsot
