// What the numbers of all rows of a table of samples share. Used only by the table.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "construction/poinsot_construction.h"
#include "production/sampling/sample_table.h"

namespace poinsot {

struct SampledMotion {
    bool has_angles = false;  // whether the motion itself has Euler angles
    Eigen::Matrix3d tensor_body = Eigen::Matrix3d::Identity();  // kg m²
    std::optional<PoinsotConstruction> construction;            // if a column needs it
};

}  // namespace poinsot
