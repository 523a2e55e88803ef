// Points of the user's own, [[marks]]: on the ellipsoid, on the body or in space.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "drawing/panel.h"

namespace poinsot {

// Where a mark is in the panel's axes, for a state in the stage's space axes; nothing where the
// panel does not show such marks.
using MarkPlace =
    std::function<std::optional<Eigen::Vector3d>(const MarkSpec&, const RotationState&)>;

// Where a mark on the ellipsoid is, body axes, in the lengths of the construction's picture.
Eigen::Vector3d on_ellipsoid(const ConstructionPicture& picture, const MarkSpec& mark);

// Where a mark on the body is from the centre of mass, m, body axes.
Eigen::Vector3d on_body_m(const Scene& scene, const MarkSpec& mark);

// The marks that the panel shows, with their names and, where they move, their trails over the
// stage's span. They fade by the name "marks". Nothing where the scene has none.
Drawer make_own_marks(Panel& panel, const MarkPlace& place);

}  // namespace poinsot
