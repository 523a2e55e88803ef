// Torques and the equations of motion that the stepping methods solve.
//
// With a torque the motion of a general body is not integrable: except for Lagrange's top there is
// no closed form, and the motion must be integrated numerically.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "mechanics/inertia.h"
#include "mechanics/motion_problem.h"

namespace poinsot {

// The potential in J, for gravity mgl (n·z) with a unit arm, else 0; `space_from_axes` turns the
// axes of the torque's vectors.
double potential_J(const Torque& torque, const Eigen::Quaterniond& space_from_axes);

// The variables of a stepping method: momentum L in kg m²/s in principal axes, and the attitude.
struct StepState {
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
    Eigen::Quaterniond space_from_principal = Eigen::Quaterniond::Identity();
    double time_s = 0.0;  // of the motion, for a torque that changes with time
};

// dL/dt in principal axes, and the angular velocity at which the principal axes turn.
struct RotationRates {
    Eigen::Vector3d momentum_rate;
    Eigen::Vector3d turning;
};

// Euler's equations dL/dt = L × Ω + N in principal axes, dq/dt = ½ q Ω, for one body and torque.
//
// Gravity: N = Mgl (z × n), z the upward vertical and n the arm, both in principal axes.
// Drag of the air: N_i = −(a_i + b_i |ω_i|) e^(gt) L_i, so that both T and |L| fall, d|L|²/dt = 2
// L·N and dT/dt = ω·N. Internal friction: no torque acts and L is kept in space, but the
// axes turn at Ω = ω + κ (L × ω)/L² with ω = I⁻¹L and κ = rate · tr(I)/3, so that dL/dt = L × ω + κ
// L × (L × ω)/L² keeps |L| and dT/dt = −κ |L × ω|²/L²: the spin tends to the axis of the highest
// moment. This is the double bracket of Bloch, Krishnaprasad, Marsden & Ratiu, Commun. Math. Phys.
// 175 (1996) 1. As L in space is known, the attitude alone is stepped (stepped/friction.h).
class RotationDynamics {
 public:
    // Throws InputError if a number of the torque is not finite, the arm is zero, or the rate of
    // internal friction or a rate of the drag is negative.
    RotationDynamics(const InertiaTensor& inertia, const Torque& torque);

    const Eigen::Vector3d& moments_kg_m2() const { return moments_; }
    const Torque& torque() const { return torque_; }  // in principal axes
    // Whether a torque acts; internal friction is not a torque.
    bool has_torque() const { return kind_of(torque_).acts; }

    // ω = I⁻¹L in principal axes, rad/s.
    Eigen::Vector3d omega(const Eigen::Vector3d& momentum) const {
        return momentum.cwiseQuotient(moments_);
    }
    // N in N m, principal axes.
    Eigen::Vector3d torque_on(const StepState& state) const;
    RotationRates rates(const StepState& state) const;
    // Kinetic energy, and for gravity Mgl (n·z), in joules.
    double energy_J(const StepState& state) const;

    // Largest |ω| of the torque-free motion from this momentum, rad/s.
    double greatest_free_omega(const Eigen::Vector3d& momentum) const;
    // Largest rotation rate that friction adds to ω: the bound κ (1/I_min − 1/I_max)/2 of
    // κ |L × ω|/L², in rad/s.
    double greatest_friction_turning_rad_s() const;
    // An upper bound in 1/s of the rate at which the drag of the air slows a component of ω between
    // these times, after a start with this momentum; 0 without drag, infinite beyond doubles.
    double greatest_drag_rate_1_s(const Eigen::Vector3d& momentum, double first_time_s,
                                  double last_time_s) const;
    // An upper bound of |N| in N m; 0 for the drag of the air, which depends on ω.
    double greatest_torque_N_m() const;

 private:
    Eigen::Vector3d moments_;
    Eigen::Vector3d least_over_moments_;
    Torque torque_;
    double friction_1_s_ = 0.0;  // κ over the least moment
};

}  // namespace poinsot
