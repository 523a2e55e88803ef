// Visibility of colours and of their differences, for all common kinds of colour vision and in
// greyscale.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

#include "shapes/colour.h"

namespace poinsot {

// Y of CIE 1931, from 0 to 1.
double relative_luminance(const Colour& colour);

// WCAG 2.1's contrast ratio, 1 to 21: 1.4.3 requires 4.5 for text, 1.4.11 requires 3 for graphical
// objects.
double contrast(const Colour& a, const Colour& b);

// CIELAB relative to the white of sRGB, CIE 15:2004: L* from 0 to 100, a*, b*.
Eigen::Vector3d lab(const Colour& colour);

// Linear light as perceived without one type of cone: Machado, Oliveira & Fernandes, "A
// physiologically-based model for simulation of color vision deficiency" (2009), severity 1. The
// first of the four is normal vision.
struct Vision {
    std::string_view eye;  // " to an eye without …", the end of a sentence
    Eigen::Matrix3d seen_from_linear;
};
const std::array<Vision, 4>& visions();

// Difference of two line colours, in units of the difference that half of all people notice between
// marks s degrees wide: Stone, Szafir & Setlur, "An engineering model for color difference as a
// function of size" (2014), ND(p, s) = p (A + B/s). A curve is 4 pixels of 1080 wide; from the
// middle of a lecture room the picture's height subtends 20°, so s = 0.074°. The model was fitted
// down to a third of a degree; extrapolating it requires a larger difference, and lines are long,
// which makes them easier to tell apart than marks.
double line_difference(const Colour& a, const Colour& b, const Vision& vision);

// The difference of their lightness alone, in the same units.
double grey_difference(const Colour& a, const Colour& b);

}  // namespace poinsot
