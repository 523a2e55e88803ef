#include "render/passes/colour.h"

#include "numerics/srgb.h"

namespace poinsot {

glm::vec3 linear_from_srgb(const Colour& colour) {
    return {linear_from_srgb(colour.r), linear_from_srgb(colour.g), linear_from_srgb(colour.b)};
}

glm::vec4 linear_from_srgb(const Colour& colour, double fourth) {
    return {linear_from_srgb(colour), fourth};
}

Colour mixed(const Colour& a, const Colour& b, double part_of_b) {
    const double keep = 1.0 - part_of_b;
    return {keep * a.r + part_of_b * b.r, keep * a.g + part_of_b * b.g,
            keep * a.b + part_of_b * b.b};
}

}  // namespace poinsot
