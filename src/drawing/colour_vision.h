// Whether colours can be seen and told apart: by eyes of every common kind, and in grey.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

#include "shapes/colour.h"

namespace poinsot {

// WCAG 2.1's contrast ratio, 1 to 21: 1.4.3 asks for 4.5 for text, 1.4.11 for 3 for graphical
// objects.
double contrast(const Colour& a, const Colour& b);

// CIELAB beside the white of sRGB, CIE 15:2004: L* from 0 to 100, a*, b*.
Eigen::Vector3d lab(const Colour& colour);

// What linear light becomes to an eye that lacks a pigment: Machado, Oliveira & Fernandes, "A
// physiologically-based model for simulation of color vision deficiency" (2009), severity 1. The
// first of the four lacks none.
struct Vision {
    std::string_view eye;  // " to an eye without …", as a sentence goes on
    Eigen::Matrix3d seen_from_linear;
};
const std::array<Vision, 4>& visions();

// How far two lines' colours are apart, in units of what half of all people notice between marks s
// degrees wide: Stone, Szafir & Setlur, "An engineering model for color difference as a function of
// size" (2014), ND(p, s) = p (A + B/s). A curve is 4 pixels of 1080 wide; from the middle of a
// lecture room the picture's height is seen under 20°, so s = 0.074°. The model was fitted down to
// a third of a degree; here it is asked for more than that, which asks for more difference, and
// lines are long, which makes them easier than marks.
double line_difference(const Colour& a, const Colour& b, const Vision& vision);

// The same of their greys alone.
double grey_difference(const Colour& a, const Colour& b);

}  // namespace poinsot
