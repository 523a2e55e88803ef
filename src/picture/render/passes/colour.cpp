#include "render/passes/colour.h"

#include "numerics/srgb.h"

namespace poinsot {

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
