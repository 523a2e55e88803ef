// Lagrange's top: a symmetric body with one point fixed, in uniform gravity, solved by theta
// functions, so that every instant costs the same.
#pragma once

#include <Eigen/Geometry>
#include <complex>
#include <optional>
#include <string_view>

#include "mechanics/inertia.h"
#include "mechanics/motion_problem.h"
#include "mechanics/rotation_state.h"
#include "mechanics/top/heavy_top_series.h"

namespace poinsot {

// A top and its start in z-x-z Euler angles, R = Rz(φ) Rx(θ) Rz(ψ), φ = ψ = 0 at t = 0. θ is the
// angle of the symmetry axis e3 from the upward vertical; the potential is Mgl cos θ.
struct HeavyTopProblem {
    double moment_transverse_kg_m2 = 1.0;  // A = I1 = I2, about the fixed point
    double moment_axial_kg_m2 = 1.0;       // C = I3
    double mgl_N_m = 0.0;                  // negative: the centre of mass lies towards −e3
    double theta_rad = 0.0;
    double theta_dot_rad_s = 0.0;
    double phi_dot_rad_s = 0.0;
    double omega3_rad_s = 0.0;  // ω along e3, conserved
};

// Returns the state at t = 0 for the problem's Euler angles and rates; body axes are principal.
// Throws InputError if θ lies outside of [0, π].
RotationState start_of(const HeavyTopProblem& problem);

// The kinds of motion of a heavy symmetric top. "Upper" is the end of the nutation with the higher
// centre of mass.
enum class TopRegime {
    sleeping,           // upright and stable: (Cω3)² ≥ 4A·Mgl
    sleeping_unstable,  // upright but unstable: (Cω3)² < 4A·Mgl
    hanging,            // vertical, centre of mass below the fixed point
    steady_slow,        // θ constant, the slower of the two precessions
    steady_fast,        // θ constant, the faster one
    wavy,               // φ̇ keeps its sign
    cusp,               // φ̇ vanishes at the upper end of the nutation
    looping,            // φ̇ changes sign within the nutation
    through_vertical,   // passes through the upright or the hanging position
    planar_pendulum,    // no spin and no precession: motion in a vertical plane
    separatrix,         // tends to the upright position for t → ±∞
    no_gravity,         // Mgl = 0: the free symmetric body
};

std::string_view name_of(TopRegime regime);

// Constants of the motion. p_φ is the vertical component of L, p_ψ = Cω3 that along e3.
struct TopInvariants {
    double p_phi_kg_m2_s = 0.0;
    double p_psi_kg_m2_s = 0.0;
    double energy_J = 0.0;  // kinetic + Mgl cos θ
};

// The range of the nutation and the mean rates over one nutation. The period is infinite on the
// separatrix, where the rates are those of the limit, and for steady motion it is that of small
// nutation (0 if there is none: a vertical or torque-free axis).
struct TopNutation {
    double theta_min_rad = 0.0;
    double theta_max_rad = 0.0;
    double period_s = 0.0;
    double precession_rate_rad_s = 0.0;  // mean φ̇
};

// The exact motion of a heavy symmetric top; immutable. Setup is done once in wide double-double,
// whose range also holds θ0 = 1e-300; an evaluation is in double with a two-word phase. At the
// start the given state is returned; elsewhere the error of ω is at most 1.1e-15 of the larger of
// |ω| and √(|Mgl|/A), the rate at which gravity turns the body, for moments that a body can have.
//
// Source: Klein & Sommerfeld, Über die Theorie des Kreisels, ch. VI (Cayley–Klein parameters as
// theta quotients); DLMF §20, §22. The quaternion is the primary result and stays regular through
// the vertical; the angles follow from it. Departures: the cubic's roots are kept as differences
// from the start and as products, so that none is a difference of large numbers, and Mgl < 0 is the
// mirrored top with e3 reversed.
class HeavyTop {
 public:
    // Throws InputError if a number is not finite, a moment is not positive, θ lies outside of
    // [0, π] or L overflows.
    explicit HeavyTop(const HeavyTopProblem& problem);

    // Constructs the motion through a state at start.time_s. Throws InputError if a number of the
    // state is not finite, the attitude is zero or L overflows, and unless two principal moments
    // are equal and the arm lies along the third axis (any arm for three equal moments). The Euler
    // angles are those of that axis. If the state was rounded from Euler angles, give these as
    // well: the motion is then exact for them. They are used where the third body axis is the
    // symmetry axis.
    HeavyTop(const InertiaTensor& inertia, const Gravity& gravity, const RotationState& start,
             const std::optional<TopStart>& unrounded = std::nullopt);

    // True if the second constructor accepts this body and arm.
    static bool accepts(const InertiaTensor& inertia, const Gravity& gravity);

    // State at a time, in the body axes of the start. Throws InputError if the phase overflows.
    RotationState at(double time_s) const;

    // Euler angles, φ and ψ continuous in time from their values at the start. Where the axis
    // passes exactly through the vertical, φ and ψ jump by π there and back at the next passage;
    // while it stays vertical only φ+ψ has a meaning and φ−ψ is zero.
    EulerAngles euler_angles(double time_s) const;

    MotionSample sample(double time_s, Quantities wanted) const;

    TopRegime regime() const { return regime_; }
    const TopInvariants& invariants() const { return invariants_; }
    const TopNutation& nutation() const { return nutation_; }

    // V(θ) = (p_φ − p_ψ cos θ)²/(2A sin²θ) + p_ψ²/(2C) + Mgl cos θ in joules; the motion takes
    // place where V ≤ E. Infinite at a vertical that p_φ ≠ ±p_ψ forbids.
    double effective_potential_J(double theta_rad) const;

 private:
    struct Phase;
    struct Factors;

    Phase phase_at(double time_s) const;
    bool is_start(double time_s) const { return time_s == given_.time_s; }
    Factors factors_at(const Phase& phase) const;
    void fit_start(std::complex<double> omega_transverse);
    void check_momentum(bool from_angles) const;
    DoubleDouble unwrapped(int which, const Phase& phase, const Factors& factors) const;
    RotationState state_from(double time_s, const Phase& phase, const Factors& factors) const;
    EulerAngles angles_from(const Phase& phase, const Factors& factors) const;

    RotationState given_;  // the start, the attitude of unit length
    EulerAngles given_angles_;
    // Within the series times are in units of 2^−n s near the time of the fastest turn, so that no
    // product over- or underflows.
    int rate_exponent_ = 0;
    double moment_transverse_ = 1.0;
    double moment_axial_ = 1.0;
    double mgl_ = 0.0;
    double omega3_ = 0.0;
    double p_phi_minus_p_psi_ = 0.0;  // kept apart: small near the upright position
    TopSeries series_;
    std::complex<double> start_[2];                 // α and β at t = 0
    std::complex<double> start_phase_[2] = {1, 1};  // factors that make the series match the start
    DoubleDouble start_angle_[2];                   // the series' own continuous phase at t = 0
    double angle_start_[2] = {0.0, 0.0};            // φ+ψ and φ−ψ at t = 0
    TopRegime regime_ = TopRegime::wavy;
    TopInvariants invariants_;
    TopNutation nutation_;
    Eigen::Quaterniond body_from_top_ = Eigen::Quaterniond::Identity();

    friend struct TopSetup;  // heavy_top_setup.h: the wide solution
};

}  // namespace poinsot
