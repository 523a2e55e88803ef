#include "drawing/style/theme_roles.h"

#include <cassert>

#include "text/nearest.h"

namespace poinsot {

namespace {

RoleLook look(LineStyle& line) { return {&line, &line, nullptr}; }
RoleLook look(Colour& colour, double* opacity = nullptr) { return {&colour, nullptr, opacity}; }

constexpr ThemeRole role_rows[] = {
    {"ground", [](Theme& theme) { return look(theme.background.bottom, &theme.background.alpha); }},
    {"ground_top", [](Theme& theme) { return look(theme.background.top); }},
    {"text", [](Theme& theme) { return look(theme.text); }},
    {"halo", [](Theme& theme) { return look(theme.halo); }},
    {"ellipsoid", [](Theme& theme) { return look(theme.ellipsoid, &theme.ellipsoid_opacity); }},
    {"ellipsoid_lines", [](Theme& theme) { return look(theme.ellipsoid_lines); }},
    {"plane", [](Theme& theme) { return look(theme.plane, &theme.plane_opacity); }},
    {"grid", [](Theme& theme) { return look(theme.grid); }},
    {"e1", [](Theme& theme) { return look(theme.axes[0]); }},
    {"e2", [](Theme& theme) { return look(theme.axes[1]); }},
    {"e3", [](Theme& theme) { return look(theme.axes[2]); }},
    {"theta", [](Theme& theme) { return look(theme.angles[0]); }},
    {"phi", [](Theme& theme) { return look(theme.angles[1]); }},
    {"psi", [](Theme& theme) { return look(theme.angles[2]); }},
    {"omega", [](Theme& theme) { return look(theme.omega); }},
    {"momentum", [](Theme& theme) { return look(theme.momentum); }},
    {"rho", [](Theme& theme) { return look(theme.rho); }},
    {"gradient", [](Theme& theme) { return look(theme.gradient); }},
    {"torque", [](Theme& theme) { return look(theme.torque); }},
    {"polhode", [](Theme& theme) { return look(theme.polhode); }},
    {"herpolhode", [](Theme& theme) { return look(theme.herpolhode); }},
    {"contact", [](Theme& theme) { return look(theme.contact); }},
    {"mark", [](Theme& theme) { return look(theme.mark); }},
    {"measured", [](Theme& theme) { return look(theme.measured); }},
    {"annulus", [](Theme& theme) { return look(theme.annulus); }},
    {"separatrix", [](Theme& theme) { return look(theme.separatrix); }},
    {"body_cone", [](Theme& theme) { return look(theme.body_cone); }},
    {"space_cone", [](Theme& theme) { return look(theme.space_cone); }},
    {"sphere", [](Theme& theme) { return look(theme.sphere); }},
    {"solid", [](Theme& theme) { return look(theme.solid); }},
    {"solid_lines", [](Theme& theme) { return look(theme.solid_lines); }},
    {"energy", [](Theme& theme) { return look(theme.energy); }},
    {"potential", [](Theme& theme) { return look(theme.potential); }},
    {"ghost", [](Theme& theme) { return look(theme.ghost); }},
    {"rule", [](Theme& theme) { return look(theme.rule); }},
};

}  // namespace

std::span<const ThemeRole> theme_roles() { return role_rows; }

LineStyle line_of(const Theme& theme, std::string_view role) {
    Theme copy = theme;
    const RoleLook look = look_of(copy, role);
    return look.line != nullptr ? *look.line : LineStyle(*look.colour);
}

RoleLook look_of(Theme& theme, std::string_view role) {
    const ThemeRole* row = find_row(role_rows, role);
    assert(row != nullptr);
    return row->look(theme);
}

}  // namespace poinsot
