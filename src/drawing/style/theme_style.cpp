// A theme with the changes of a scene's [style].
#include <array>
#include <utility>

#include "drawing/style/theme.h"
#include "scene/scene_error.h"
#include "scene/style_keys.h"

namespace poinsot {

namespace {

// The line of a role in a theme; null for surfaces and the background.
LineStyle* ink_of(Theme& theme, std::string_view role) {
    const std::array<std::pair<std::string_view, LineStyle*>, 22> places{{
        {"omega", &theme.omega},
        {"momentum", &theme.momentum},
        {"e1", &theme.axes[0]},
        {"e2", &theme.axes[1]},
        {"e3", &theme.axes[2]},
        {"polhode", &theme.polhode},
        {"herpolhode", &theme.herpolhode},
        {"contact", &theme.contact},
        {"annulus", &theme.annulus},
        {"separatrix", &theme.separatrix},
        {"body_cone", &theme.body_cone},
        {"space_cone", &theme.space_cone},
        {"sphere", &theme.sphere},
        {"solid", &theme.solid},
        {"solid_lines", &theme.solid_lines},
        {"theta", &theme.angles[0]},
        {"phi", &theme.angles[1]},
        {"psi", &theme.angles[2]},
        {"energy", &theme.energy},
        {"potential", &theme.potential},
        {"ghost", &theme.ghost},
        {"rule", &theme.rule},
    }};
    for (const auto& [name, ink] : places)
        if (name == role) return ink;
    return nullptr;
}

Colour* colour_of(Theme& theme, std::string_view role) {
    if (role == "text") return &theme.text;
    if (role == "halo") return &theme.halo;
    if (role == "ground_top") return &theme.background.top;
    if (role == "ground") return &theme.background.bottom;
    if (role == "ellipsoid") return &theme.ellipsoid;
    if (role == "ellipsoid_lines") return &theme.ellipsoid_lines;
    if (role == "plane") return &theme.plane;
    if (role == "grid") return &theme.grid;
    return ink_of(theme, role);
}

double* opacity_of(Theme& theme, std::string_view role) {
    if (role == "ground") return &theme.background.alpha;
    if (role == "ellipsoid") return &theme.ellipsoid_opacity;
    if (role == "plane") return &theme.plane_opacity;
    return nullptr;
}

DashPattern line_of(std::string_view name) {
    if (name == "dashed") return DashPattern::dashed;
    return name == "dotted" ? DashPattern::dotted : DashPattern::solid;
}

void apply(const std::string& role, const LookSpec& look, Theme& theme) {
    if (look.srgb) {
        const auto [r, g, b] = *look.srgb;
        *colour_of(theme, role) = Colour{r, g, b};
    }
    LineStyle* const ink = ink_of(theme, role);
    if (ink != nullptr && look.weight) ink->weight = *look.weight;
    if (ink != nullptr && !look.line.empty()) ink->line = line_of(look.line);
    if (double* const opacity = opacity_of(theme, role); opacity != nullptr && look.opacity_percent)
        *opacity = *look.opacity_percent / 100.0;
}

}  // namespace

Theme theme_of(const Scene& scene) {
    Theme theme = at_scene_key(scene, "theme", [&] { return theme_named(scene.theme); });
    const auto& looks = scene.style.looks;
    // Sets a uniform background, unless its top has its own colour; text gets a halo of that
    // colour.
    if (const auto ground = looks.find("ground"); ground != looks.end()) {
        apply("ground", ground->second, theme);
        if (ground->second.srgb) {
            theme.background.top = theme.background.bottom;
            theme.halo = theme.background.bottom;
            if (!ground->second.opacity_percent) theme.background.alpha = 1.0;
        }
    }
    for (const auto& [role, look] : looks)
        if (role != "ground") apply(role, look, theme);
    return theme;
}

}  // namespace poinsot
