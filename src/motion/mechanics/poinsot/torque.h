// What acts on a body that turns, about its centre of mass or its fixed point.
//
//     #include <poinsot/torque.h>
//     const poinsot::Torque torque = poinsot::InternalFriction{.rate_1_s = 0.05};
//
// A motion refuses numbers that are not finite, negative rates, and a zero arm.
#pragma once

#include <Eigen/Core>
#include <variant>

namespace poinsot {

struct NoTorque {};
// The potential mgl (n·z), z being the upward vertical.
struct Gravity {
    double mgl_N_m = 0.0;  // weight times the distance of the centre of mass from the fixed point
    // n, the direction of the centre of mass from the fixed point, body axes; of any length.
    Eigen::Vector3d arm_body{0.0, 0.0, 1.0};
};
struct ConstantTorqueInBody {
    Eigen::Vector3d torque_body_N_m = Eigen::Vector3d::Zero();
};
struct ConstantTorqueInSpace {
    Eigen::Vector3d torque_space_N_m = Eigen::Vector3d::Zero();
};
// Friction inside the body: L is conserved, and T decreases until the body turns about the axis of
// the largest moment.
struct InternalFriction {
    double rate_1_s = 0.0;  // ≥ 0
};
// The drag of the air: the torque −(linear_i + quadratic_i |ω_i|) e^(growth·t) I_i ω_i along the
// principal axes.
struct Drag {
    Eigen::Vector3d linear_1_s = Eigen::Vector3d::Zero();       // ≥ 0
    Eigen::Vector3d quadratic_1_rad = Eigen::Vector3d::Zero();  // ≥ 0
    double growth_1_s = 0.0;
};
using Torque = std::variant<NoTorque, Gravity, ConstantTorqueInBody, ConstantTorqueInSpace,
                            InternalFriction, Drag>;

}  // namespace poinsot
