// The rows of the table of scene keys, section by section, and functions that write values.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <span>
#include <string>

#include "scene/given_value.h"
#include "scene/scene_error.h"
#include "scene/scene_keys.h"
#include "scene/toml_text.h"

namespace poinsot {

// In the order in which they are listed and written.
std::span<const SceneKey> picture_keys();
std::span<const SceneKey> body_keys();
std::span<const SceneKey> motion_keys();
std::span<const SceneKey> film_keys();
std::span<const SceneKey> camera_keys();
std::span<const SceneKey> told_keys();
std::span<const SceneKey> panel_keys();
std::span<const SceneKey> style_keys();
std::span<const SceneKey> mark_keys();

// Texts of values that only some scenes have.
template <typename Value>
std::string optional_text(const std::optional<Value>& value) {
    return value ? toml_text(*value) : "";
}

inline std::string text_unless_empty(const std::string& text) {
    return text.empty() ? "" : toml_text(std::string_view(text));
}

// Checks the name of a table's row; an unknown name is refused at its own place.
template <typename Find>
std::string name_in_table(const GivenValue& given, Find find) {
    std::string name = given.text();
    try {
        find(name);
    } catch (const InputError& error) {
        throw SceneError(given.value().where, error.what());
    }
    return name;
}

// A point that a camera looks at. Beyond the largest distance of a camera the figure would be
// invisible, and beyond a double's digits nothing could be computed.
inline Eigen::Vector3d target_of(const GivenValue& given) {
    constexpr double farthest = 10000.0;
    Eigen::Vector3d target = given.vector();
    if (target.cwiseAbs().maxCoeff() > farthest)
        given.refuse(fmt::format("[{}, {}, {}]", target.x(), target.y(), target.z()),
                     fmt::format("give a point within {} of the centre", farthest));
    return target;
}

}  // namespace poinsot
