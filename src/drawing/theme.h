// Colours and line styles as data: one symbol and one colour for one quantity in every view.
#pragma once

#include <span>
#include <string_view>

#include "shapes/camera.h"
#include "shapes/colour.h"

namespace poinsot {

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

    Colour polhode;
    Colour herpolhode;
    double herpolhode_weight = 1.0;  // its width over the polhode's; a broken line means hidden
    Colour momentum;
    Colour omega;
    Colour axes[3];
    Colour contact;
    Colour body_cone;
    Colour space_cone;
    Colour annulus;

    Colour separatrix;
    Colour ghost{0.36, 0.40, 0.45};  // the motion beside
    Colour sphere;                   // |m| = L in the space of momenta
    Colour solid;                    // real bodies
    Colour solid_lines;              // marks on them that show how they turn
    Colour angles[3];                // θ, φ, ψ
    Colour energy;                   // E and T
    Colour potential;                // V
    Colour rule;                     // axes and grids of plots

    // What a scene says in `hidden` and `crossings`, where it says nothing.
    std::string_view hidden = "pale";
    std::string_view crossings = "through";
};

std::span<const Theme> themes();

// Throws InputError with the nearest name.
const Theme& theme_named(std::string_view name);

}  // namespace poinsot
