#include "mechanics/free/free_rotation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "error/error.h"
#include "numerics/elliptic_integrals.h"
#include "numerics/power_of_two.h"
#include "numerics/quaternion_dd.h"

namespace poinsot {

namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

// The turn that takes the momentum's direction to a, at the start: (1 + n_a, 0, n_c, −n_b) scaled
// to unit length.
QuaternionDD start_turn(const JacobiSolution& j) {
    VectorDD n;
    for (std::size_t i = 0; i < 3; ++i) n[i] = (j.start[i] / j.momentum).double_double();
    const DoubleDouble p = n[0] + 1.0;
    const DoubleDouble length = sqrt(p * p + n[1] * n[1] + n[2] * n[2]);
    return {p / length, {0.0, n[2] / length, -n[1] / length}};
}

void check_start(const Vector3d& omega, const Quaterniond& attitude, double time_s) {
    if (!omega.allFinite()) {
        throw InputError(
            "omega_rad_s: the components of the angular velocity must be finite numbers");
    }
    if (!attitude.coeffs().allFinite() || attitude.coeffs().isZero(0.0)) {
        throw InputError("the start's attitude must be a finite quaternion other than zero");
    }
    if (!std::isfinite(time_s)) throw InputError("the start's time must be a finite number");
}

// ω along the principal axes. Throws where a component overflows.
Vector3d principal(const InertiaTensor& inertia, const Vector3d& omega_body) {
    if (inertia.body_axes_are_principal()) return omega_body;
    // Double-double multiplies numbers below 2^996. No smaller ones are scaled, because the
    // smallest doubles would lose digits.
    constexpr int most_exponent = 990;
    const int down = std::max(0, exponent_of(omega_body) - most_exponent);
    VectorDD w;
    for (int i = 0; i < 3; ++i) w[static_cast<std::size_t>(i)] = std::ldexp(omega_body[i], -down);
    Vector3d omega = ldexp(rounded(times(inertia.body_from_principal().transpose(), w)), down);
    if (!omega.allFinite())
        throw InputError(
            "omega_rad_s: the angular velocity along a principal axis overflows; choose other "
            "units");
    return omega;
}

// The exponent of the unit of ω, near its greatest component: products with it are normal numbers.
int exponent_of_unit(const Vector3d& omega) {
    constexpr int farthest = 1000;
    return std::clamp(exponent_of(omega), -farthest, farthest);
}

// Throws where a rate, in the unit of ω, is farther from one than doubles can follow: it, or the
// directions of L that belong to it, would underflow. None is of a body whose moments differ by
// less than 1e288.
void check_rates(const JacobiSolution& j, int exponent) {
    constexpr int slowest = -960, fastest = 990;
    const auto is_followed = [=](const WideDouble& rate, int least) {
        const int e = rate.exponent() - exponent;
        return rate.is_zero() || (e >= least && e <= fastest);
    };
    constexpr int any = std::numeric_limits<int>::min();
    bool follows = is_followed(j.rate, any) && is_followed(j.mean_turn_rate, any);
    for (const WideDouble& I : j.moments) follows = follows && is_followed(j.momentum / I, slowest);
    if (follows) return;
    throw InputError(fmt::format(
        "omega_rad_s: the motion of a body whose moments {}, {}, {} differ so much has rates that "
        "double-precision numbers cannot follow; choose moments that are nearer to each other",
        j.moments[0].rounded(), j.moments[1].rounded(), j.moments[2].rounded()));
}

// √(x² + y²).
WideDouble length(const WideDouble& x, const WideDouble& y) { return sqrt(square(x) + square(y)); }

}  // namespace

FreeRotation::FreeRotation(const InertiaTensor& inertia, const RotationState& start,
                           bool on_separatrix)
    : start_(start) {
    check_start(start.omega_body, start.space_from_body, start.time_s);
    const Vector3d omega = principal(inertia, start.omega_body);
    const JacobiSolution solution =
        solve_free_rotation(inertia.moments_kg_m2(), omega, on_separatrix);
    regime_ = solution.regime;
    const int exponent = exponent_of_unit(start.omega_body);
    unit_rad_s_ = std::ldexp(1.0, exponent);
    if (regime_ != Regime::at_rest && regime_ != Regime::permanent) check_rates(solution, exponent);
    set_constants(solution, inertia, omega);
    DoubleDouble kappa = 1.0;
    if (regime_ == Regime::permanent) {
        series_ = Series::permanent;
        steady_axis_body_ = start.omega_body.stableNormalized();
    } else if (regime_ != Regime::at_rest && suits_trigonometric(solution)) {
        series_ = Series::trigonometric;
        trigonometric_ = trigonometric_series(solution);
        kappa = trigonometric_.kappa;
    } else if (regime_ != Regime::at_rest) {
        series_ = regime_ == Regime::separatrix ? Series::separatrix : Series::hyperbolic;
        hyperbolic_ = hyperbolic_series(solution);
        kappa = hyperbolic_.kappa;
    }
    set_output(solution, inertia, kappa, exponent);
    if (regime_ != Regime::at_rest) set_rates(solution, exponent);
}

void FreeRotation::set_constants(const JacobiSolution& j, const InertiaTensor& inertia,
                                 const Vector3d& omega) {
    FreeRotationConstants& k = constants_;
    k.kinetic_energy_J = ldexp(j.twice_energy, -1).rounded();
    k.momentum_kg_m2_s = j.momentum.rounded();
    const Vector3d momentum =
        inertia.body_from_principal() * inertia.moments_kg_m2().cwiseProduct(omega);
    k.momentum_space = start_.space_from_body.normalized() * momentum;
    if (!std::isfinite(k.momentum_kg_m2_s) || !k.momentum_space.allFinite()) {
        throw InputError("omega_rad_s: the angular momentum I omega overflows; choose other units");
    }
    k.encircled_axis = j.axis[0];
    if (regime_ == Regime::at_rest || regime_ == Regime::permanent) return;

    k.modulus = j.modulus.rounded();
    k.complementary_modulus = j.complementary_modulus.rounded();
    const WideDouble L2 = square(j.momentum);
    WideTriple h;
    for (std::size_t i = 0; i < 3; ++i) h[i] = j.amplitude[i] / j.moments[i] * j.delta[i] / L2;
    const double at_c = length(h[0], h[2]).rounded();
    const double at_b = length(h[0] * j.complementary_modulus, h[1]).rounded();
    k.least_herpolhode_radius_rad_s = std::min(at_b, at_c);
    k.greatest_herpolhode_radius_rad_s = std::max(at_b, at_c);

    // sn u vanishes at u = 0, which lies at most a quarter of a period from the start.
    if (regime_ != Regime::symmetric) {
        const WideDouble half =
            regime_ == Regime::separatrix ? WideDouble(1.0) : ldexp(j.quarter_period, 1);
        const double before_s = (j.start_phase * half / j.rate).rounded();
        k.middle_axis_crossing_s = start_.time_s - before_s;
    }

    // In a polhode period ω turns once about a, backwards for s = +1, in the axes that follow a.
    WideDouble advance = j.mean_turn_rate;
    if (regime_ != Regime::separatrix) {
        const WideDouble period = ldexp(j.quarter_period, 2) / j.rate;
        const WideDouble turn = ldexp(WideDouble(pi_dd), 1) / period;
        advance = j.s > 0 ? advance - turn : advance + turn;
        k.polhode_period_s = period.rounded();
        k.advance_per_period_rad = (advance * period).rounded();
    }
    k.mean_advance_rate_rad_s = advance.rounded();
}

void FreeRotation::set_rates(const JacobiSolution& j, int exponent) {
    // Permanent: |ω|/2 in quarter turns is |ω|/π a second; otherwise Ω/2.
    WideDouble turn = j.mean_turn_rate;
    if (regime_ == Regime::permanent) {
        WideDouble square_sum;
        for (const double w : start_.omega_body) square_sum = square_sum + square(WideDouble(w));
        turn = sqrt(square_sum);
    }
    turn = turn / WideDouble(pi_dd);
    // v = πu/2K in quarter turns is u/K; on the separatrix u/ln 2 is wanted.
    WideDouble phase;
    WideDouble phase_start;
    if (regime_ == Regime::separatrix) {
        phase = j.rate / WideDouble(ln2_dd);
        phase_start = j.start_phase / WideDouble(ln2_dd);
    } else if (regime_ != Regime::permanent) {
        phase = j.rate / j.quarter_period;
        phase_start = ldexp(j.start_phase, 1);
    }
    DoubleDouble phase_at_0 = phase_start.double_double();
    DoubleDouble turn_at_0;
    if (start_.time_s != 0.0) {
        // The phases at the start's time are subtracted, with whole revolutions kept separate.
        const WideDouble t = start_.time_s;
        const auto reduced = [](const WideDouble& x) {
            const DoubleDouble value = x.double_double();
            return DoubleDouble(std::fmod(value.hi, 4.0)) + std::fmod(value.lo, 4.0);
        };
        turn_at_0 = -reduced(turn * t);
        phase_at_0 = regime_ == Regime::separatrix ? (phase_start - phase * t).double_double()
                                                   : phase_at_0 - reduced(phase * t);
    }
    if (!std::isfinite(turn_at_0.hi) || !std::isfinite(phase_at_0.hi))
        throw InputError("the start's time: omega t overflows; choose a time nearer zero");
    phases_.set(series_phase, phase.over_power_of_two(exponent), phase_at_0);
    phases_.set(mean_turn, turn.over_power_of_two(exponent), turn_at_0);
}

void FreeRotation::set_output(const JacobiSolution& j, const InertiaTensor& inertia,
                              DoubleDouble kappa, int exponent) {
    const QuaternionDD attitude = unit(start_.space_from_body);
    start_.space_from_body = rounded(attitude);
    const auto in_units = [=](const WideDouble& rate) { return ldexp(rate, -exponent).rounded(); };
    QuaternionDD axes_at_start{1.0, {0.0, 0.0, 0.0}};
    Matrix3d body_from_axes = Matrix3d::Identity();  // a, b, c
    if (regime_ != Regime::at_rest && regime_ != Regime::permanent) {
        for (std::size_t n = 0; n < 3; ++n) {
            const Vector3d axis = j.sign[n] * inertia.body_from_principal().col(j.axis[n]);
            body_from_axes.col(static_cast<int>(n)) = axis;
            omega_from_direction_.set(n, in_units(j.momentum / j.moments[n]) * axis);
        }
        const auto herpolhode = [&](std::size_t n) {
            return in_units(j.delta[n] / (j.moments[n] * j.momentum));
        };
        herpolhode_a_ = herpolhode(0);
        herpolhode_bc_ = Pair{herpolhode(1), herpolhode(2)};
        const auto [re, im] = start_rotor(j);
        axes_at_start = conjugate(QuaternionDD{re, {im, 0.0, 0.0}} * start_turn(j));
    }

    // The attitude is linear in the turn: start ∘ (a, b, c → body) ∘ (axes at the start) ∘ turn.
    for (std::size_t k = 0; k < 4; ++k) {
        QuaternionDD turn{0.0, {0.0, 0.0, 0.0}};
        (k == 0 ? turn.w : turn.v[k - 1]) = 1.0;
        const QuaternionDD inner = axes_at_start * turn;
        const QuaternionDD outer = attitude * QuaternionDD{inner.w, times(body_from_axes, inner.v)};
        attitude_from_turn_.set(k, rounded(outer));
    }
    // The two directions of the invariable plane that b and c have when a is along L, over κ.
    for (std::size_t k = 0; k < 2; ++k) {
        VectorDD direction{0.0, 0.0, 0.0};
        direction[k + 1] = DoubleDouble(1.0) / kappa;
        const VectorDD in_space =
            rotated(attitude, times(body_from_axes, rotated(axes_at_start, direction)));
        plane_space_.set(k, rounded(in_space));
    }
}

}  // namespace poinsot
