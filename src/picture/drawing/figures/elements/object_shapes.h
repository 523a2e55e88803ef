// The body of a scene as meshes in body axes.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "drawing/stage/panel.h"

namespace poinsot {

// A part of the body with its colour.
struct BodyPart {
    const MeshGeometry* geometry = nullptr;
    Colour colour;
};

// The body's parts in units of its reach, which is the largest distance of any of its points from
// the origin; and its extent along its principal axes in the same units.
struct BodyShape {
    std::vector<BodyPart> parts;
    std::vector<Curve> edges;  // of a box, in body axes
    Eigen::Vector3d extents = Eigen::Vector3d::Ones();
    double reach_m = 1.0;  // for bodies given by moments alone, the reach of the 1 kg box
};

// The scene's object or mesh; the solid that the scene names; point masses as balls, with volumes
// proportional to their masses, on thin rods from the centre of mass; for moments or a tensor alone
// the uniform box with these moments.
BodyShape body_shape(const Panel& panel, StageStore& store);

// Adds the body to a builder; `placement`: of body axes, in units of the body's reach.
void add_body(const BodyShape& shape, const Eigen::Affine3d& placement, bool casts_shadow,
              ViewBuilder& builder);

// Rotation from space axes to those of the object panel: without torque L is up or, if a panel
// shows the construction, in the same direction as there.
Eigen::Quaterniond object_from_space(const StageContext& stage);

// Edges of the uniform box of 1 kg with these principal moments: a² = 6(I₂ + I₃ − I₁) and so on. An
// edge whose length is zero by the triangle inequality gets a hundredth of the longest one.
Eigen::Vector3d box_of_moments(const Eigen::Vector3d& moments_kg_m2);

}  // namespace poinsot
