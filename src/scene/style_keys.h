// The table of what [style] may name, and how a look is said: "#9a247d 1.5 dashed".
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace poinsot {

// What a role is: a line has a colour, a weight and a line style; a surface, and the ground, a
// colour and an opacity; the others a colour alone.
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

// Where a mark of the user's own may be.
std::span<const std::string_view> mark_places();

}  // namespace poinsot
