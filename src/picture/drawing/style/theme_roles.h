// The member of a theme that holds the look of each role of [style].
#pragma once

#include <span>
#include <string_view>

#include "drawing/style/theme.h"

namespace poinsot {

// The look of one role: a role without a line style or an opacity has null there.
struct RoleLook {
    Colour* colour = nullptr;
    LineStyle* line = nullptr;
    double* opacity = nullptr;
};

struct ThemeRole {
    std::string_view name;  // as in style_roles()
    RoleLook (*look)(Theme& theme);
};

std::span<const ThemeRole> theme_roles();

// The line style of a role, or a line in its colour. Precondition: there is such a role.
LineStyle line_of(const Theme& theme, std::string_view role);

// Precondition: there is such a role.
RoleLook look_of(Theme& theme, std::string_view role);

}  // namespace poinsot
