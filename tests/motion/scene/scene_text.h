// Scenes as text for the tests of this folder.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "scene/files/load_scene.h"
#include "scene/scene_error.h"
#include "scene/toml/toml_document.h"

namespace poinsot {

// A complete scene; lines 1 to 5 of the file "scenes/a.toml".
inline const std::string a_body = "[body]\nmoments_kg_m2 = [3.0, 2.0, 1.0]\n";
inline const std::string a_start = "\n[start]\nomega_rad_s = [0.5, 2.0, 0.25]\n";
inline const std::string a_scene = a_body + a_start;

inline Scene scene_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return parse_scene(text, "scenes/a.toml", overrides_of(overrides), files_of_folder());
}

// Returns the message about a scene that is refused.
inline std::string refusal(const std::string& text,
                           const std::vector<std::string>& overrides = {}) {
    try {
        scene_of(text, overrides);
    } catch (const SceneError& error) {
        return error.what();
    }
    ADD_FAILURE() << "accepted:\n" << text;
    return "";
}

inline std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

// Exact comparison; an integer equals the same number as a float.
inline bool same(const TomlValue& a, const TomlValue& b) {
    using Type = TomlValue::Type;
    const auto is_number = [](const TomlValue& value) {
        return value.type == Type::integer || value.type == Type::number;
    };
    if (is_number(a) && is_number(b)) return bits(a.number) == bits(b.number);
    if (a.type != b.type || a.items.size() != b.items.size()) return false;
    for (std::size_t i = 0; i < a.items.size(); ++i)
        if (!same(a.items[i], b.items[i])) return false;
    return a.boolean == b.boolean && a.text == b.text;
}

}  // namespace poinsot
