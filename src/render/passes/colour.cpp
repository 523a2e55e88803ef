#include "render/passes/colour.h"

#include <cmath>

namespace poinsot {

double linear_from_srgb(double encoded) {
    if (encoded <= 0.04045) return encoded / 12.92;
    return std::pow((encoded + 0.055) / 1.055, 2.4);
}

Eigen::Vector3f linear_from_srgb(const Colour& colour) {
    return Eigen::Vector3d(linear_from_srgb(colour.r), linear_from_srgb(colour.g),
                           linear_from_srgb(colour.b))
        .cast<float>();
}

Eigen::Vector4f linear_from_srgb(const Colour& colour, double fourth) {
    return Eigen::Vector4d(linear_from_srgb(colour.r), linear_from_srgb(colour.g),
                           linear_from_srgb(colour.b), fourth)
        .cast<float>();
}

Colour mixed(const Colour& a, const Colour& b, double part_of_b) {
    const double keep = 1.0 - part_of_b;
    return {keep * a.r + part_of_b * b.r, keep * a.g + part_of_b * b.g,
            keep * a.b + part_of_b * b.b};
}

}  // namespace poinsot
