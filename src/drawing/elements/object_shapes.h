// The body of a scene as meshes in body axes.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "drawing/panel.h"

namespace poinsot {

// A part of the body with its colour.
struct BodyPart {
    const MeshGeometry* geometry = nullptr;
    Colour colour;
};

// The body's parts in units of its reach, the largest distance of any of its points from the
// origin, and how far it extends along its principal axes in the same units.
struct BodyShape {
    std::vector<BodyPart> parts;
    std::vector<Curve> edges;  // of a box, in body axes
    Eigen::Vector3d extents = Eigen::Vector3d::Ones();
    double reach_m = 1.0;  // of the body itself; of a stand-in for moments, its size for 1 kg
};

// The scene's object or mesh; the solid that it names; point masses as balls with volumes as their
// masses, on thin rods from the centre of mass; for moments or a tensor alone the uniform box that
// has them.
BodyShape body_shape(Panel& panel);

// Adds the body to a sheet, at a placement of body axes in units of its reach.
void add_body(const BodyShape& shape, const Eigen::Affine3d& placement, bool casts_shadow,
              Sheet& sheet);

// Edges of the uniform box of 1 kg with these principal moments: a² = 6(I₂ + I₃ − I₁) and so on. An
// edge that the triangle inequality leaves no length gets a hundredth of the longest.
Eigen::Vector3d box_of_moments(const Eigen::Vector3d& moments_kg_m2);

}  // namespace poinsot
