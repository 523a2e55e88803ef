// A theme with the changes of a scene's [style].
#include <string>
#include <string_view>

#include "drawing/style/theme.h"
#include "drawing/style/theme_roles.h"
#include "scene/scene_error.h"

namespace poinsot {

namespace {

DashPattern line_of(std::string_view name) {
    if (name == "dashed") return DashPattern::dashed;
    return name == "dotted" ? DashPattern::dotted : DashPattern::solid;
}

void apply(const std::string& role, const LookSpec& spec, Theme& theme) {
    const RoleLook look = look_of(theme, role);
    if (spec.srgb) {
        const auto [r, g, b] = *spec.srgb;
        *look.colour = Colour{r, g, b};
    }
    if (look.line != nullptr && spec.weight) look.line->weight = *spec.weight;
    if (look.line != nullptr && !spec.line.empty()) look.line->line = line_of(spec.line);
    if (look.opacity != nullptr && spec.opacity_percent)
        *look.opacity = *spec.opacity_percent / 100.0;
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
