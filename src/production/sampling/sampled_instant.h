// What the numbers of one row of a table of samples are taken from. Known to the table alone.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "construction/poinsot_construction.h"
#include "production/sampling/sample_table.h"

namespace poinsot {

struct SampledInstant {
    double time_s = 0.0;  // as asked
    MotionSample sample;
    bool has_angles = false;  // whether the motion itself gives Euler's angles
    Eigen::Matrix3d tensor_body = Eigen::Matrix3d::Identity();  // kg m²
    std::optional<PoinsotConstruction> construction;            // where a column asks for it
};

}  // namespace poinsot
