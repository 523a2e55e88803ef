// Colours and line styles as data: one symbol and one colour for one quantity in every view.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "shapes/camera.h"
#include "shapes/colour.h"

namespace poinsot {

struct Scene;

// Told apart in grey as well.
enum class LineStyle { solid, dashed, dotted };

// A colour with what a line of it looks like, where that is not as ever.
struct Ink : Colour {
    double weight = 1.0;  // times the usual
    std::optional<LineStyle> line;

    Ink() = default;
    constexpr Ink(const Colour& colour)  // NOLINT(google-explicit-constructor)
        : Colour(colour) {}
};

struct Theme {
    std::string_view name;
    std::string_view summary;

    Background background;
    Light light;
    Colour text;
    Colour halo;

    Colour ellipsoid;
    double ellipsoid_opacity = 0.8;
    Colour ellipsoid_lines;
    Colour plane;
    Colour grid;
    double plane_opacity = 0.9;

    Ink polhode;
    Ink herpolhode;
    double herpolhode_weight = 1.0;  // its width over the polhode's; a broken line means hidden
    Ink momentum;
    Ink omega;
    Ink axes[3];
    Ink contact;
    Ink body_cone;
    Ink space_cone;
    Ink annulus;

    Ink separatrix;
    Ink ghost{Colour{0.36, 0.40, 0.45}};  // the motion beside
    Ink sphere;                           // |m| = L in the space of momenta
    Ink solid;                            // real bodies
    Ink solid_lines;                      // marks on them that show how they turn
    Ink angles[3];                        // θ, φ, ψ
    Ink energy;                           // E and T
    Ink potential;                        // V
    Ink rule;                             // axes and grids of plots

    // What a scene says in `hidden` and `crossings`, where it says nothing.
    std::string_view hidden = "pale";
    std::string_view crossings = "through";
};

std::span<const Theme> themes();

// Throws InputError with the nearest name.
const Theme& theme_named(std::string_view name);

// A scene's theme with what its [style] says otherwise. Throws SceneError for an unknown theme.
Theme theme_of(const Scene& scene);

}  // namespace poinsot
