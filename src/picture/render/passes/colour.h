// sRGB-encoded colours and linear light.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "shapes/colour.h"

namespace poinsot {

// Linear light of an encoded colour.
glm::vec3 linear_from_srgb(const Colour& colour);
// The same with a fourth component.
glm::vec4 linear_from_srgb(const Colour& colour, double fourth);

// Blends the encoded values of two colours, which is perceptually more even than linear light.
Colour mixed(const Colour& a, const Colour& b, double part_of_b);

}  // namespace poinsot
