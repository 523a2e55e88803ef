#include "library/mechanics/given_torque.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "error/error.h"
#include "mechanics/torque_kinds.h"

namespace poinsot::library {

namespace {

void put(double& number, const std::string& name, const std::vector<double>& values) {
    if (values.size() != 1) throw InputError("torque: " + name + " is one number");
    number = values.front();
}
void put(Eigen::Vector3d& vector, const std::string& name, const std::vector<double>& values) {
    if (values.size() != 3) throw InputError("torque: " + name + " is three numbers");
    vector = Eigen::Map<const Eigen::Vector3d>(values.data());
}

template <typename Kind>
Torque of_kind(const std::map<std::string, std::vector<double>>& numbers) {
    Kind torque;
    std::size_t n_taken = 0;
    std::string names;
    std::apply(
        [&](const auto&... number) {
            [[maybe_unused]] const auto take = [&](const auto& one) {
                const std::string name(one.name);
                names += (names.empty() ? "" : ", ") + name;
                const auto found = numbers.find(name);
                if (found == numbers.end()) return;
                put(torque.*one.member, name, found->second);
                ++n_taken;
            };
            (take(number), ...);
        },
        KindOfTorque<Kind>::numbers);
    if (n_taken < numbers.size()) {
        const auto unknown = std::find_if(numbers.begin(), numbers.end(), [&](const auto& given) {
            return (", " + names + ",").find(", " + given.first + ",") == std::string::npos;
        });
        throw InputError("torque: a torque of kind \"" + std::string(KindOfTorque<Kind>::row.key) +
                         "\" has no " + unknown->first +
                         (names.empty() ? "" : "; it takes " + names));
    }
    if (n_taken == 0 && !names.empty())
        throw InputError("torque: a torque of kind \"" + std::string(KindOfTorque<Kind>::row.key) +
                         "\" needs its numbers: " + names);
    return torque;
}

}  // namespace

Torque given_torque(std::string_view kind,
                    const std::map<std::string, std::vector<double>>& numbers) {
    std::optional<Torque> made;
    std::string kinds;
    [&]<std::size_t... k>(std::index_sequence<k...>) {
        const auto try_kind = [&]<typename Kind>(std::type_identity<Kind>) {
            kinds += (kinds.empty() ? "" : ", ") + std::string(KindOfTorque<Kind>::row.key);
            if (KindOfTorque<Kind>::row.key == kind) made = of_kind<Kind>(numbers);
        };
        (try_kind(std::type_identity<std::variant_alternative_t<k, Torque>>()), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Torque>>());
    if (!made)
        throw InputError("torque: unknown kind \"" + std::string(kind) + "\"; give one of " +
                         kinds);
    return *made;
}

}  // namespace poinsot::library
