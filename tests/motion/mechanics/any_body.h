// Free bodies of any doubles: what a motion must be that is not refused. The 1e5 random bodies of a
// test and the fuzzer ask the same.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

#include "mechanics/inertia.h"

namespace poinsot::any_body {

struct Body {
    Eigen::Matrix3d tensor_kg_m2 = Eigen::Matrix3d::Identity();
    Eigen::Vector3d omega_rad_s = Eigen::Vector3d::UnitZ();
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
    Physicality physicality = Physicality::waived;
};

struct Outcome {
    std::string refusal;  // the message, if the body or its motion is refused
    std::string fault;    // what is wrong; empty if nothing is
    bool is_twin =
        false;  // whether the motion was also compared with that of the body in other units
};

// Moves the body and measures: states are finite; T and L are kept, by sums in long double; and the
// same body in units of mass and time that bring its largest element and |ω| to order one, by
// powers of two, has the same motion in them, wherever such units round nothing. A refusal must say
// what is refused.
Outcome moved(const Body& body);

}  // namespace poinsot::any_body
