// The motion of a rigid body, exact at any instant.
//
//     #include <poinsot/motion.h>
//     const poinsot::library::Motion racket({1.0, 2.0, 3.0}, {0.01, 2.0, 0.01});
//     const poinsot::library::State state = racket.at(12.5);
//
// Units are SI. "Body axes" are the axes in which the moments or the tensor and ω are given; "space
// axes" are those in which the body axes lie at t = 0, unless an attitude is given. Functions throw
// poinsot::InputError (<poinsot/error.h>) for bad values, with a message that names the value. All
// functions that do not change an object may be called by several threads at once.
#pragma once

#include <poinsot/torque.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace poinsot::library {

// A quaternion of doubles without special alignment: programs may be compiled for any processor,
// whatever alignment Eigen then gives to Eigen::Quaterniond. It converts to that and from it.
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

// The body at one instant. All numbers are finite: a state beyond the range of double is refused.
struct State {
    double time_s = 0.0;
    Eigen::Vector3d omega_body = Eigen::Vector3d::Zero();  // angular velocity, rad/s, body axes
    // The attitude, of length 1: v_space = space_from_body * v_body. q and −q are the same
    // attitude.
    Quaternion space_from_body = Quaternion::Identity();
    // The component of ω perpendicular to L, rad/s, space axes: the herpolhode without its scale.
    Eigen::Vector3d herpolhode_space = Eigen::Vector3d::Zero();
};
static_assert(alignof(State) == alignof(double));

// z-x-z Euler angles: R = Rz(φ) Rx(θ) Rz(ψ).
struct EulerAngles {
    double theta_rad = 0.0;
    double phi_rad = 0.0;
    double psi_rad = 0.0;
};

// What acts on the body.
using poinsot::ConstantTorqueInBody;
using poinsot::ConstantTorqueInSpace;
using poinsot::Drag;
using poinsot::Gravity;
using poinsot::InternalFriction;
using poinsot::NoTorque;
using poinsot::Torque;

struct MotionOptions {
    Quaternion start_attitude = Quaternion::Identity();  // space_from_body at t = 0; any length
    Torque torque = NoTorque{};
    // "exact", or a stepping method: the names, orders and options of `poinsot list methods`.
    std::string method = "exact";
    // Of methods of fixed step; default: a 200th of the fastest turn.
    std::optional<double> step_s = {};
    std::optional<double> tolerance = {};  // of methods that choose their steps; default 1e-9
    std::optional<int> order = {};         // default: the highest order of the method
    // The interval that a stepping method covers; t = 0 is always part of it. Exact motions cover
    // all times.
    double first_time_s = 0.0;
    double last_time_s = 0.0;
    // Asked while a stepping method computes the motion: true ends it with an InputError.
    std::function<bool()> stop = {};
    // Accept moments that violate the triangle inequality, which no real body has.
    bool allow_unphysical = false;
};

// The start of a heavy symmetric top in z-x-z Euler angles; φ = ψ = 0 at t = 0.
struct TopStart {
    double theta_rad = 0.0;  // tilt of the symmetry axis from the upward vertical, 0 to π
    double theta_dot_rad_s = 0.0;
    double phi_dot_rad_s = 0.0;  // precession
    double omega3_rad_s = 0.0;   // ω along the symmetry axis
};

enum class Regime {
    at_rest,                 // ω = 0
    permanent,               // steady rotation about a principal axis, or any axis of a sphere
    symmetric,               // two equal moments
    elliptic_about_lowest,   // the polhode encircles the axis of the smallest moment
    elliptic_about_highest,  // … of the largest moment
    separatrix,              // ω approaches the middle axis and never returns
    heavy_top,               // Lagrange's top
    integrated,              // computed by a stepping method
};

// The constants of a torque-free motion. A value that the regime does not have is empty; one beyond
// the range of double is infinite or 0, as T is for |ω| = 1e160 rad/s. The states stay exact there.
struct Constants {
    double kinetic_energy_J = 0.0;                             // T
    double momentum_kg_m2_s = 0.0;                             // |L|
    Eigen::Vector3d momentum_space = Eigen::Vector3d::Zero();  // L, space axes
    std::optional<int> encircled_axis;  // the principal axis, 0 to 2, that the polhode encircles
    double modulus = 0.0;               // k of Jacobi's elliptic functions
    std::optional<double> polhode_period_s;        // ω returns in body axes
    std::optional<double> advance_per_period_rad;  // ω's turn about L in that time
    double precession_rad_s = 0.0;                 // mean rate of ω about L, space axes
    // Least and greatest length of State::herpolhode_space.
    double least_herpolhode_rad_s = 0.0;
    double greatest_herpolhode_rad_s = 0.0;
};

// The constants of a heavy symmetric top; one beyond the range of double is infinite or 0.
struct TopConstants {
    double p_phi_kg_m2_s = 0.0;  // L along the vertical
    double p_psi_kg_m2_s = 0.0;  // L along the symmetry axis
    double energy_J = 0.0;       // T + Mgl cos θ
    double theta_min_rad = 0.0;  // range of the nutation
    double theta_max_rad = 0.0;
    double nutation_period_s = 0.0;  // infinite on the separatrix; 0: the axis cannot nutate
    double precession_rad_s = 0.0;   // mean φ̇
};

// An immutable motion; copies share its data.
class __attribute__((visibility("default"))) Motion {
 public:
    // A body with these principal moments, in any order, which turns with ω at t = 0. Body axes are
    // the principal axes, in the order of the moments.
    Motion(const Eigen::Vector3d& moments_kg_m2, const Eigen::Vector3d& omega_body_rad_s,
           const MotionOptions& options = {});

    // A body with this symmetric inertia tensor in body axes.
    static Motion with_tensor(const Eigen::Matrix3d& tensor_kg_m2,
                              const Eigen::Vector3d& omega_body_rad_s,
                              const MotionOptions& options = {});

    // Lagrange's top: moments about the fixed point, the third along the symmetry axis, and the
    // potential Mgl cos θ. The options' torque and start attitude are not used.
    static Motion heavy_top(double moment_transverse_kg_m2, double moment_axial_kg_m2,
                            double mgl_N_m, const TopStart& start,
                            const MotionOptions& options = {});

    // The state at an instant. Exact motions cost the same at every instant; the values are those
    // of `poinsot sample`.
    State at(double time_s) const;

    // The states at many instants, in any order. `states` must have as many elements as `times_s`.
    void at(std::span<const double> times_s, std::span<State> states) const;

    // The Euler angles at an instant: for a heavy top φ and ψ are continuous in time, otherwise
    // they are within ±π.
    EulerAngles euler_angles(double time_s) const;

    Regime regime() const;
    // The regime in one sentence, as `poinsot check` prints it.
    std::string regime_sentence() const;

    // The principal moments I1, I2, I3 in kg m², and the principal axes as columns, in body axes.
    Eigen::Vector3d moments_kg_m2() const;
    Eigen::Matrix3d body_from_principal() const;

    // Throws InputError if there is a torque.
    Constants constants() const;
    // Throws InputError unless the body is a heavy symmetric top.
    TopConstants top_constants() const;

    // Copies only: a motion that was moved from would be empty.
    Motion(const Motion&) = default;
    Motion& operator=(const Motion&) = default;
    ~Motion() = default;

 private:
    struct Impl;
    friend struct MotionAccess;

    __attribute__((visibility("hidden"))) explicit Motion(std::shared_ptr<const Impl> inside);

    std::shared_ptr<const Impl> impl_;
};

// The regime in few words, as in "separatrix".
__attribute__((visibility("default"))) std::string_view name_of(Regime regime);

}  // namespace poinsot::library
