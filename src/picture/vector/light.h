// Lighting of surfaces by the formulas of shaders/light.glsl, so that paper and screen show the
// same tones.
#pragma once

#include <Eigen/Core>
#include <span>

#include "shapes/views.h"
#include "vector/sheet_of_paper.h"

namespace poinsot::vector {

// sRGB (IEC 61966-2-1) ↔ linear light, component by component.
Eigen::Vector3d linear(const Colour& colour);
Colour encoded(const Eigen::Vector3d& linear_light);

// Paper blends encoded colours, the screen blends light. Returns the ink that gives over `behind`
// the colour that `colour` with this opacity gives in light. It has this opacity, unless no colour
// would give the result.
PaperInk as_in_light(const Colour& colour, double opacity, const Colour& behind);

// The most transparent such ink: it darkens other colours in the same ratio, as a shadow does.
PaperInk as_shade(const Colour& colour, double opacity, const Colour& behind);

// The colour of an ink of this opacity that gives `wanted` over `behind`, or the nearest possible.
Colour colour_making(const Colour& wanted, double alpha, const Colour& behind);

// The colour that an ink gives over another colour.
Colour over(const PaperInk& ink, const Colour& behind);

// The wanted colour at a place, and the colour behind it.
struct ColourOver {
    Colour wanted, behind;
};
// The single ink that gives all wanted colours as nearly as possible (least squares over all
// components). Precondition: at least one place.
PaperInk ink_for(std::span<const ColourOver> places);

// The lights of a view.
struct Lights {
    explicit Lights(const View& view);

    Eigen::Vector3d towards, up;  // unit vectors to the key light and to the middle of the sky
    double key = 0.0, sky = 0.0;
};

// A surface point for lighting. normal, to_eye: unit vectors; the normal points to the eye's side.
struct SurfacePoint {
    Eigen::Vector3d normal, to_eye;
};
// Light and opacity of a surface layer.
struct Layer {
    Eigen::Vector3d light;
    double alpha = 1.0;
};
Layer outer_surface(const Ellipsoid& ellipsoid, const Lights& lights, const SurfacePoint& point,
                    double lines);
Layer inner_surface(const Ellipsoid& ellipsoid, const Lights& lights, const SurfacePoint& point,
                    double lines);
// The colour of a surface's contour where nothing is filled: its own, changed as little as a
// contrast of 3 with the colour behind it requires.
Colour contour_colour(const Colour& surface, const Colour& behind);
// The lines of a cone: their tone relative to its colour in linear light, and their opacities.
struct ConeLines {
    double tone, rim_opacity, generator_opacity;
};
ConeLines cone_lines();
Layer cone_surface(const Cone& cone, const Lights& lights, const SurfacePoint& point);
Eigen::Vector3d arrow_surface(const Colour& colour, const Lights& lights,
                              const SurfacePoint& point);
Eigen::Vector3d mesh_surface(const Colour& colour, const Lights& lights, const SurfacePoint& point);

}  // namespace poinsot::vector
