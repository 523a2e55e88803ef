// The faces of a body by name: the principal axis e₁ points out of the face "+e1".
#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>

namespace poinsot {

// "+e1", "-e1", "+e2", …
std::span<const std::string_view> body_faces();

struct BodyFace {
    int axis = 0;       // 0, 1, 2: column of body_from_principal
    double sign = 1.0;  // +1 or -1
    // The outward normal, body axes.
    Eigen::Vector3d outward(const Eigen::Matrix3d& body_from_principal) const {
        return sign * body_from_principal.col(axis);
    }
};

// Precondition: the name is one of body_faces().
BodyFace body_face_named(std::string_view name);

}  // namespace poinsot
