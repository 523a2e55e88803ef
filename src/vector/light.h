// How surfaces are lit, by the formulas of shaders/light.glsl: paper and screen show one tone.
#pragma once

#include <Eigen/Core>
#include <span>

#include "shapes/views.h"
#include "vector/page.h"

namespace poinsot::vector {

// sRGB (IEC 61966-2-1) ↔ linear light, component by component.
Eigen::Vector3d linear(const Colour& colour);
Colour encoded(const Eigen::Vector3d& linear_light);

// Paper mixes encoded colours, the screen light: the ink that looks over `behind` as `colour` with
// this opacity does in light. Its opacity is the one asked for, unless no colour would do.
Ink as_in_light(const Colour& colour, double opacity, const Colour& behind);

// The most transparent ink that does so: it darkens what else lies there in the same ratio, as a
// shadow does.
Ink as_shade(const Colour& colour, double opacity, const Colour& behind);

// The colour of an ink of this opacity that makes `wanted` over `behind`, as nearly as there is
// one.
Colour colour_making(const Colour& wanted, double alpha, const Colour& behind);

// The colour that as_in_light's ink makes over another.
Colour over(const Ink& ink, const Colour& behind);

// What a place is to look like, and what lies behind it.
struct ColourOver {
    Colour wanted, behind;
};
// The one ink that makes all of them as nearly as one can (least squares over all components).
// Precondition: at least one.
Ink ink_for(std::span<const ColourOver> places);

// The lights of a view.
struct Lights {
    explicit Lights(const View& view);

    Eigen::Vector3d towards, up;  // unit: to the key light, to the middle of the sky
    double key = 0.0, sky = 0.0;
};

// Light that leaves a point, linear. normal, to_eye: unit; the normal on the eye's side.
struct SurfacePoint {
    Eigen::Vector3d normal, to_eye;
};
// Of an ellipsoid's outer surface and its inner one, mixed: `lines` 1 is the colour of its lines.
struct Layer {
    Eigen::Vector3d light;
    double alpha = 1.0;
};
Layer outer_surface(const Ellipsoid& ellipsoid, const Lights& lights, const SurfacePoint& point,
                    double lines);
Layer inner_surface(const Ellipsoid& ellipsoid, const Lights& lights, const SurfacePoint& point,
                    double lines);
// The lines of a cone: their tone beside its colour in linear light, and their opacities.
struct ConeLines {
    double tone, rim_opacity, generator_opacity;
};
ConeLines cone_lines();
Layer cone_surface(const Cone& cone, const Lights& lights, const SurfacePoint& point);
Eigen::Vector3d arrow_surface(const Colour& colour, const Lights& lights,
                              const SurfacePoint& point);
Eigen::Vector3d mesh_surface(const Colour& colour, const Lights& lights, const SurfacePoint& point);

}  // namespace poinsot::vector
