// The table of the keys of [style], and the syntax of a look: "#9a247d 1.5 dashed".
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace poinsot {

// The kinds of roles: a line has a colour, a weight and a line style; a surface, and the ground, a
// colour and an opacity; all others have only a colour.
enum class StyleKind { line, surface, colour };

struct StyleRole {
    std::string_view name;  // as in [style]
    StyleKind kind;
    std::string_view what;
};

std::span<const StyleRole> style_roles();

// "solid", "dashed", "dotted".
std::span<const std::string_view> line_kinds();

// A colour as it is written: "#9a247d".
std::string colour_text(const std::array<double, 3>& srgb);

// The places where a user's mark may lie.
std::span<const std::string_view> mark_places();

}  // namespace poinsot
