// The user's points, [[marks]]: on the ellipsoid, on the body or in space.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "drawing/stage/panel.h"

namespace poinsot {

// Position of a mark in the panel's axes, for a state in the stage's space axes; empty if the panel
// does not show such marks.
using MarkPlace =
    std::function<std::optional<Eigen::Vector3d>(const MarkSpec&, const RotationState&)>;

// Position of a mark on the ellipsoid, body axes, in the lengths of the construction's picture.
Eigen::Vector3d on_ellipsoid(const ConstructionPicture& picture, const MarkSpec& mark);

// Position of a mark on the body relative to the centre of mass, m, body axes.
Eigen::Vector3d on_body_m(const Scene& scene, const MarkSpec& mark);

// Drawer of the marks that the panel shows, with their names and, if they move, their trails over
// the stage's span. They fade by the name "marks". Empty if the scene has no marks.
Drawer make_user_marks(Panel& panel, StageStore& store, const MarkPlace& place);

}  // namespace poinsot
