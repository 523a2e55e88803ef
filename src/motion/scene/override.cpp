#include "scene/override.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/scene_error.h"

namespace poinsot {

std::string Override::assignment() const { return key + "=" + value; }

std::string Override::as_typed() const {
    const bool shows_key = origin == "--set" || origin == "--sweep";
    return fmt::format("{} {}", origin, shows_key ? assignment() : value);
}

Override override_of(std::string_view assignment, std::string_view origin) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos)
        throw SceneError({fmt::format("{} {}", origin, assignment), 0, 0},
                         "no \"=\"; write --set key=value");
    std::string_view key = assignment.substr(0, equals);
    key.remove_prefix(std::min(key.find_first_not_of(" \t"), key.size()));
    key = key.substr(0, key.find_last_not_of(" \t") + 1);
    return {std::string(key), std::string(assignment.substr(equals + 1)), std::string(origin)};
}

std::vector<Override> overrides_of(std::span<const std::string> assignments) {
    std::vector<Override> overrides;
    overrides.reserve(assignments.size());
    for (const std::string& assignment : assignments) overrides.push_back(override_of(assignment));
    return overrides;
}

bool is_given(std::span<const Override> overrides, std::string_view key) {
    return std::any_of(overrides.begin(), overrides.end(),
                       [key](const Override& given) { return given.key == key; });
}

}  // namespace poinsot
