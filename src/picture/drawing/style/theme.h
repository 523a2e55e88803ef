// Colours and line styles as data: one symbol and one colour for one quantity in every view.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "shapes/camera.h"
#include "shapes/colour.h"

namespace poinsot {

struct Scene;

// Distinguishable in greyscale.
enum class DashPattern { solid, dashed, dotted };

// A colour with an optional line weight and line style.
struct LineStyle : Colour {
    double weight = 1.0;  // factor of the usual width
    std::optional<DashPattern> line;

    LineStyle() = default;
    constexpr LineStyle(const Colour& colour)  // NOLINT(google-explicit-constructor)
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

    LineStyle polhode;
    LineStyle herpolhode;
    // Widths of the two curves of the construction, in 4 pixels of 1080; dashes mean hidden lines.
    double polhode_weight = 1.0;
    double herpolhode_weight = 1.0;
    LineStyle momentum;
    LineStyle omega;
    LineStyle rho;
    LineStyle gradient;  // ∇F
    LineStyle torque;    // N
    LineStyle axes[3];
    LineStyle contact;
    LineStyle mark;      // points that the scene marks, and their paths
    LineStyle measured;  // the points and the track of a measured motion
    LineStyle body_cone;
    LineStyle space_cone;
    LineStyle annulus;

    LineStyle separatrix;
    LineStyle ghost{Colour{0.36, 0.40, 0.45}};  // the comparison motion
    LineStyle sphere;                           // |m| = L in the space of momenta
    LineStyle solid;                            // real bodies
    LineStyle solid_lines;                      // marks on them that show how they turn
    LineStyle angles[3];                        // θ, φ, ψ
    LineStyle energy;                           // E and T
    LineStyle potential;                        // V
    LineStyle rule;                             // axes and grids of plots

    // Defaults of the scene's `hidden`, `hidden_arrows` and `crossings`.
    std::string_view hidden = "pale";
    std::string_view hidden_arrows = "pale";
    std::string_view crossings = "gap";
};

std::span<const Theme> themes();

// Throws InputError with the nearest name.
const Theme& theme_named(std::string_view name);

// A scene's theme with the changes of its [style]. Throws SceneError for an unknown theme.
Theme theme_of(const Scene& scene);

}  // namespace poinsot
