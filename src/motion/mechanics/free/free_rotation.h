// The torque-free rotation of a rigid body, exact at any instant: Jacobi's solution by theta
// functions.
//
// For given doubles, the error of ω is at most 8e-16 of its norm, that of the attitude 1.1e-15 rad
// and that of the herpolhode 2e-15 of its length, in every regime and up to 1e15 rad of turning;
// the error then grows by 5e-32 per radian. docs/accuracy.md describes how far the rounding of the
// input changes the motion.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "mechanics/free/rotation_series.h"
#include "mechanics/inertia.h"
#include "mechanics/regime.h"
#include "mechanics/rotation_state.h"
#include "numerics/column_pairs.h"

namespace poinsot {

// Constants of a torque-free motion. A constant that the regime does not have is empty: there is no
// period on the separatrix (it is infinite), in permanent rotation or at rest.
struct FreeRotationConstants {
    double kinetic_energy_J = 0.0;  // T; infinite on overflow, zero on underflow
    double momentum_kg_m2_s = 0.0;  // |L|
    Eigen::Vector3d momentum_space = Eigen::Vector3d::Zero();  // L, kg m²/s, space axes
    int encircled_axis = 2;              // index of the principal axis that the polhode encircles
    double modulus = 0.0;                // k of the Jacobi functions
    double complementary_modulus = 1.0;  // k′, not formed from k: accurate when tiny
    std::optional<double> polhode_period_s;        // time in which ω returns in body axes
    double mean_advance_rate_rad_s = 0.0;          // mean rate of ω about L, space axes
    std::optional<double> advance_per_period_rad;  // herpolhode's angle in one polhode period
    // The instant nearest to the start's at which ω along the middle axis changes its sign; it does
    // so every half period, and once on the separatrix.
    std::optional<double> middle_axis_crossing_s;
    // Least and greatest |ω perpendicular to L|, rad/s: the annulus that the herpolhode fills.
    double least_herpolhode_radius_rad_s = 0.0;
    double greatest_herpolhode_radius_rad_s = 0.0;
};

// Immutable; every instant costs the same.
class FreeRotation {
 public:
    // Constructs the motion through a state at start.time_s. `on_separatrix`: see MotionProblem.
    // Throws InputError if ω, the attitude or the time is not finite, if the attitude is zero, if L
    // overflows, or if the moments differ by so much (1e288) that the motion cannot be followed.
    FreeRotation(const InertiaTensor& inertia, const RotationState& start,
                 bool on_separatrix = false);

    // Throws InputError if ω t overflows.
    RotationState at(double time_s) const;
    // Euler angles are those of the attitude, z-x-z, φ and ψ in (−π, π], not unwrapped.
    MotionSample sample(double time_s, const Quantities& wanted) const;

    Regime regime() const { return regime_; }
    // Whether an evaluation sums theta series (Jacobi's functions, or sine and cosine as their case
    // of nome 0); permanent rotation, the separatrix and rest need none.
    bool sums_theta_series() const {
        return series_ == Series::trigonometric || series_ == Series::hyperbolic;
    }
    const FreeRotationConstants& constants() const { return constants_; }

 private:
    enum class Series { none, permanent, trigonometric, hyperbolic, separatrix };

    double scaled_time(double time_s) const;
    void evaluate(double time_s, const Quantities& wanted, MotionSample& out) const;
    void steady(double time, const Quantities& wanted, MotionSample& out) const;
    SeriesPoint trigonometric_point(double time) const;
    SeriesPoint hyperbolic_point(double time) const;
    SeriesPoint separatrix_point(double time) const;
    template <Series series>
    void evaluate_series(double time, const Quantities& wanted, MotionSample& out) const;
    void finish(const SeriesPoint& point, const Quantities& wanted, MotionSample& out) const;
    void set_constants(const JacobiSolution& solution, const InertiaTensor& inertia,
                       const Eigen::Vector3d& omega_principal);
    // The last two with rates in units of 2^exponent rad/s.
    void set_output(const JacobiSolution& solution, const InertiaTensor& inertia,
                    DoubleDouble kappa, int exponent);
    void set_rates(const JacobiSolution& solution, int exponent);

    Regime regime_ = Regime::at_rest;
    Series series_ = Series::none;

    // Rates are taken in this unit, a power of two near |ω|, and times in its inverse, so that no
    // product over- or underflows.
    double unit_rad_s_ = 1.0;
    static constexpr int series_phase = 0;
    static constexpr int mean_turn = 1;
    PhasePair phases_;  // v or u, see the series (u/ln 2 on the separatrix), and Ωt/2
    TrigonometricSeries trigonometric_;
    HyperbolicSeries hyperbolic_;

    RotationState start_;  // as given, the attitude of unit length
    Eigen::Vector3d steady_axis_body_ = Eigen::Vector3d::Zero();  // ω/|ω| of permanent rotation
    // Linear maps from the evaluated directions to the output, in the unit of rates.
    ThreeRows<3> omega_from_direction_;  // of the momentum, along a, b, c: (L/I)·(the axis)
    QuaternionRows attitude_from_turn_;
    ThreeRows<2> plane_space_;      // the invariable plane's two directions over κ
    double herpolhode_a_ = 0.0;     // (L² − 2TI)/(I L) of a
    Pair herpolhode_bc_{0.0, 0.0};  // the same of b and c
    FreeRotationConstants constants_;
};

}  // namespace poinsot
