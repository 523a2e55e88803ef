#include "mechanics/free_rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "error/error.h"
#include "mechanics/elliptic_integrals.h"

namespace poinsot {

namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

using VectorDD = std::array<DoubleDouble, 3>;

// The two phases of a motion.
constexpr int series_phase = 0;
constexpr int mean_turn = 1;

// A quaternion in double-double.
struct QuaternionDD {
    DoubleDouble w;
    VectorDD v;
};

VectorDD cross(const VectorDD& a, const VectorDD& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

QuaternionDD operator*(const QuaternionDD& p, const QuaternionDD& q) {
    const VectorDD c = cross(p.v, q.v);
    QuaternionDD r;
    r.w = p.w * q.w - (p.v[0] * q.v[0] + p.v[1] * q.v[1] + p.v[2] * q.v[2]);
    for (std::size_t i = 0; i < 3; ++i) r.v[i] = p.w * q.v[i] + q.w * p.v[i] + c[i];
    return r;
}

VectorDD rotated(const QuaternionDD& q, const VectorDD& x) {
    const VectorDD once = cross(q.v, x);
    const VectorDD twice = cross(q.v, once);
    VectorDD result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = x[i] + (q.w * once[i] + twice[i]) * 2.0;
    return result;
}

QuaternionDD conjugate(const QuaternionDD& q) { return {q.w, {-q.v[0], -q.v[1], -q.v[2]}}; }

// Of unit length, with w ≥ 0. Precondition: finite and not zero.
QuaternionDD unit(const Quaterniond& q) {
    int exponent = 0;
    std::frexp(q.coeffs().cwiseAbs().maxCoeff(), &exponent);
    const Eigen::Vector4d c =
        q.coeffs().unaryExpr([=](double x) { return std::ldexp(x, -exponent); });
    DoubleDouble square;
    for (const double x : c) square = square + two_product(x, x);
    DoubleDouble length = sqrt(square);
    if (c[3] < 0.0) length = -length;
    return {
        DoubleDouble(c[3]) / length,
        {DoubleDouble(c[0]) / length, DoubleDouble(c[1]) / length, DoubleDouble(c[2]) / length}};
}

VectorDD times(const Matrix3d& m, const VectorDD& x) {
    VectorDD result;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            const auto j = static_cast<std::size_t>(k);
            result[static_cast<std::size_t>(i)] =
                result[static_cast<std::size_t>(i)] + x[j] * m(i, k);
        }
    }
    return result;
}

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
        throw InputError("omega_rad_s: the components of the angular velocity are finite numbers");
    }
    if (!attitude.coeffs().allFinite() || attitude.coeffs().isZero(0.0)) {
        throw InputError("the start's attitude is a quaternion that is finite and not zero");
    }
    if (!std::isfinite(time_s)) throw InputError("the start's time is a finite number");
}

// ω along the principal axes.
Vector3d principal(const InertiaTensor& inertia, const Vector3d& omega_body) {
    if (inertia.body_axes_are_principal()) return omega_body;
    VectorDD w;
    for (int i = 0; i < 3; ++i) w[static_cast<std::size_t>(i)] = omega_body[i];
    const VectorDD result = times(inertia.body_from_principal().transpose(), w);
    return {result[0].rounded(), result[1].rounded(), result[2].rounded()};
}

// √(x² + y²).
WideDouble length(const WideDouble& x, const WideDouble& y) { return sqrt(square(x) + square(y)); }

EulerAngles euler_angles(const Quaterniond& q) {
    // R = Rz(φ)Rx(θ)Rz(ψ): w, z = cos(θ/2)·cos, sin((φ+ψ)/2); x, y = sin(θ/2)·cos, sin((φ−ψ)/2).
    const double half_sum = std::atan2(q.z(), q.w());
    const double half_difference = std::atan2(q.y(), q.x());
    EulerAngles angles;
    angles.theta_rad = 2.0 * std::atan2(std::hypot(q.x(), q.y()), std::hypot(q.w(), q.z()));
    angles.phi_rad = std::remainder(half_sum + half_difference, 2.0 * std::numbers::pi);
    angles.psi_rad = std::remainder(half_sum - half_difference, 2.0 * std::numbers::pi);
    return angles;
}

// The rotor turned on by the mean turn.
void turn_on(SeriesPoint& point, SinCos mean) {
    const double re = point.re;
    point.re = mean.cos * re - mean.sin * point.im;
    point.im = mean.sin * re + mean.cos * point.im;
}

}  // namespace

FreeRotation::FreeRotation(const InertiaTensor& inertia, const RotationState& start, Tier tier)
    : tier_(tier), omega_start_body_(start.omega_body) {
    check_start(start.omega_body, start.space_from_body, start.time_s);
    const Vector3d omega = principal(inertia, start.omega_body);
    const JacobiSolution solution = solve_free_rotation(inertia.moments_kg_m2(), omega);
    regime_ = solution.regime;
    set_constants(solution, inertia, start);
    set_output(solution, inertia, start);
    if (regime_ == Regime::at_rest) return;

    set_rates(solution, start.time_s);
    if (regime_ == Regime::permanent) {
        series_ = Series::permanent;
    } else if (suits_trigonometric(solution)) {
        series_ = Series::trigonometric;
        trigonometric_ = trigonometric_series(solution);
    } else {
        series_ = regime_ == Regime::separatrix ? Series::separatrix : Series::hyperbolic;
        hyperbolic_ = hyperbolic_series(solution);
    }
}

void FreeRotation::set_constants(const JacobiSolution& j, const InertiaTensor& inertia,
                                 const RotationState& start) {
    FreeRotationConstants& k = constants_;
    k.kinetic_energy_J = ldexp(j.twice_energy, -1).rounded();
    k.momentum_kg_m2_s = j.momentum.rounded();
    if (!std::isfinite(k.momentum_kg_m2_s)) {
        throw InputError("omega_rad_s: the angular momentum I omega overflows; choose other units");
    }
    const Vector3d omega = principal(inertia, start.omega_body);
    const Vector3d momentum =
        inertia.body_from_principal() * inertia.moments_kg_m2().cwiseProduct(omega);
    k.momentum_space = start.space_from_body.normalized() * momentum;
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

void FreeRotation::set_rates(const JacobiSolution& j, double start_time_s) {
    const int exponent =
        std::clamp(WideDouble(omega_start_body_.cwiseAbs().maxCoeff()).exponent(), -1022, 1023);
    time_scale_ = std::ldexp(1.0, exponent);
    // Permanent: |ω|/2 in quarter turns is |ω|/π a second; otherwise Ω/2.
    WideDouble turn = j.mean_turn_rate;
    if (regime_ == Regime::permanent) {
        WideDouble square_sum;
        for (const double w : omega_start_body_) square_sum = square_sum + square(WideDouble(w));
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
    if (start_time_s != 0.0) {
        // The start's own time is taken off the phases, whole revolutions apart.
        const WideDouble t = start_time_s;
        const auto reduced = [](const WideDouble& x) {
            const DoubleDouble value = x.double_double();
            return DoubleDouble(std::fmod(value.hi, 4.0)) + std::fmod(value.lo, 4.0);
        };
        turn_at_0 = -reduced(turn * t);
        phase_at_0 = regime_ == Regime::separatrix ? (phase_start - phase * t).double_double()
                                                   : phase_at_0 - reduced(phase * t);
    }
    phases_.set(series_phase, phase.over_power_of_two(exponent), phase_at_0);
    phases_.set(mean_turn, turn.over_power_of_two(exponent), turn_at_0);
}

void FreeRotation::set_output(const JacobiSolution& j, const InertiaTensor& inertia,
                              const RotationState& start) {
    const QuaternionDD attitude = unit(start.space_from_body);
    QuaternionDD axes_at_start{1.0, {0.0, 0.0, 0.0}};
    if (regime_ == Regime::at_rest || regime_ == Regime::permanent) {
        body_from_axes_.setIdentity();
    } else {
        Matrix3d principal_from_axes = Matrix3d::Zero();
        for (int i = 0; i < 3; ++i) {
            const auto n = static_cast<std::size_t>(i);
            principal_from_axes(j.axis[n], i) = j.sign[n];
            omega_per_direction_[i] = (j.momentum / j.moments[n]).rounded();
            herpolhode_per_direction_[i] = (j.delta[n] / (j.moments[n] * j.momentum)).rounded();
        }
        body_from_axes_ = inertia.body_from_principal() * principal_from_axes;
        const auto [re, im] = start_rotor(j);
        axes_at_start = conjugate(QuaternionDD{re, {im, 0.0, 0.0}} * start_turn(j));
    }

    // The attitude is linear in the turn: start ∘ (a, b, c → body) ∘ (axes at the start) ∘ turn.
    for (int k = 0; k < 4; ++k) {
        QuaternionDD turn{0.0, {0.0, 0.0, 0.0}};
        (k == 3 ? turn.w : turn.v[static_cast<std::size_t>(k)]) = 1.0;
        const QuaternionDD inner = axes_at_start * turn;
        const QuaternionDD outer =
            attitude * QuaternionDD{inner.w, times(body_from_axes_, inner.v)};
        for (int i = 0; i < 3; ++i) {
            attitude_from_turn_(i, k) = outer.v[static_cast<std::size_t>(i)].rounded();
        }
        attitude_from_turn_(3, k) = outer.w.rounded();
    }
    // The two directions of the invariable plane that b and c have when a is along L.
    for (int k = 0; k < 2; ++k) {
        const VectorDD direction{0.0, k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0};
        const VectorDD in_space =
            rotated(attitude, times(body_from_axes_, rotated(axes_at_start, direction)));
        for (int i = 0; i < 3; ++i) {
            plane_space_(i, k) = in_space[static_cast<std::size_t>(i)].rounded();
        }
    }
}

// The scaled time, refused where ω t overflows.
double FreeRotation::scaled_time(double time_s) const {
    const double time = time_s * time_scale_;
    if (!std::isfinite(time)) {
        throw InputError(
            "time_s: omega t overflows or the time is not finite; choose a time nearer the start");
    }
    return time;
}

// The point functions are inlined, which spares writing a SeriesPoint word by word to memory and
// reading it back in pairs: that stalls.
[[gnu::always_inline]] inline SeriesPoint FreeRotation::trigonometric_point(double time) const {
    const QuarterTurnPair turns =
        tier_ == Tier::exact ? phases_.at(time) : phases_.at_in_one_word(time);
    SeriesPoint point = trigonometric_.at(sin_cos(turns[series_phase]));
    turn_on(point, sin_cos(turns[mean_turn]));
    return point;
}

[[gnu::always_inline]] inline SeriesPoint FreeRotation::hyperbolic_point(double time) const {
    const QuarterTurnPair turns =
        tier_ == Tier::exact ? phases_.at(time) : phases_.at_in_one_word(time);
    const QuarterTurns phase = turns[series_phase];
    const HyperbolicSeries::Place place = HyperbolicSeries::place(phase);
    SeriesPoint point = hyperbolic_.at(phase, place);
    const QuarterTurns turn =
        moved_on(turns[mean_turn], hyperbolic_.phase_per_period * place.periods);
    turn_on(point, sin_cos(turn));
    return point;
}

[[gnu::always_inline]] inline SeriesPoint FreeRotation::separatrix_point(double time) const {
    // Past |u| = 1400 nothing is left of the approach to the middle axis.
    const DoubleDouble rate = phases_.rate(series_phase);
    const DoubleDouble start = phases_.start(series_phase);
    const double near = rate.hi * time + start.hi;
    const DoubleDouble x =
        std::abs(near) > 2000.0 ? DoubleDouble(std::copysign(2000.0, near)) : rate * time + start;
    SeriesPoint point = hyperbolic_.at_separatrix(abs(x), x.hi < 0.0 ? -1.0 : 1.0);
    const QuarterTurns turn = phases_.at(time)[mean_turn];
    turn_on(point, sin_cos(turn));
    return point;
}

// Permanent rotation, and rest.
void FreeRotation::steady(double time, Quantities wanted, MotionSample& out) const {
    out.state.omega_body = omega_start_body_;
    if (!wanted.attitude && !wanted.euler_angles) return;
    if (series_ == Series::none) {
        out.state.space_from_body.coeffs() = attitude_from_turn_.col(3);
        return;
    }
    const QuarterTurns turn = phases_.at(time)[mean_turn];
    const SinCos half = sin_cos(turn);
    const Vector3d along = omega_start_body_.stableNormalized();
    const Eigen::Vector4d rotation(half.sin * along[0], half.sin * along[1], half.sin * along[2],
                                   half.cos);
    out.state.space_from_body.coeffs() = attitude_from_turn_ * rotation;
}

void FreeRotation::evaluate(double time_s, Quantities wanted, MotionSample& out) const {
    out.state.time_s = time_s;
    const double time = scaled_time(time_s);
    if (series_ == Series::none || series_ == Series::permanent) {
        steady(time, wanted, out);
        return;
    }
    const SeriesPoint p = series_ == Series::trigonometric ? trigonometric_point(time)
                          : series_ == Series::hyperbolic  ? hyperbolic_point(time)
                                                           : separatrix_point(time);
    const double per_weight = 1.0 / p.weight;
    const Vector3d n(p.a * per_weight, p.b * per_weight, p.c * per_weight);
    const Vector3d omega = n.cwiseProduct(omega_per_direction_);
    out.state.omega_body = body_from_axes_ * omega;

    // P = (1 + n_a, 0, n_c, −n_b) takes the momentum's direction to a; the rotor turns about a.
    const double p0 = p.weight + p.a;
    const double tilt2 = p0 * p0 + p.b * p.b + p.c * p.c;
    const double rotor2 = p.re * p.re + p.im * p.im;
    const double scale = 1.0 / std::sqrt(rotor2 * tilt2);
    if (wanted.attitude || wanted.euler_angles) {
        const double re = p.re * scale;
        const double im = p.im * scale;
        const Eigen::Vector4d turn(im * p0, re * p.c + im * p.b, im * p.c - re * p.b, re * p0);
        out.state.space_from_body.coeffs() = attitude_from_turn_ * turn;
    }
    if (wanted.herpolhode) {
        // h = ω_i(L² − 2T·I_i)/L² has no component along L: in the turned axes none along a.
        const Vector3d h = n.cwiseProduct(herpolhode_per_direction_);
        const double scale2 = scale * scale;
        const double h_a = h[0] * (2.0 * p.weight * rotor2 * scale2);
        const double h_b = h[1] - h_a * p.b;
        const double h_c = h[2] - h_a * p.c;
        const double per_rotor2 = tilt2 * scale2;
        const double cosine = (p.re * p.re - p.im * p.im) * per_rotor2;
        const double sine = 2.0 * p.re * p.im * per_rotor2;
        out.herpolhode_space = plane_space_.col(0) * (cosine * h_b - sine * h_c) +
                               plane_space_.col(1) * (sine * h_b + cosine * h_c);
    }
}

RotationState FreeRotation::at(double time_s) const {
    MotionSample out;
    evaluate(time_s, {.attitude = true, .herpolhode = false, .euler_angles = false}, out);
    return out.state;
}

MotionSample FreeRotation::sample(double time_s, Quantities wanted) const {
    MotionSample out;
    evaluate(time_s, wanted, out);
    if (wanted.euler_angles) {
        out.euler = euler_angles(out.state.space_from_body);
        if (!wanted.attitude) out.state.space_from_body = Quaterniond::Identity();
    }
    return out;
}

double attitude_conditioning_rad(const InertiaTensor& inertia, const RotationState& start,
                                 double time_s) {
    const Quaterniond here = FreeRotation(inertia, start).at(time_s).space_from_body;
    const auto moved = [&](const InertiaTensor& body, const RotationState& state) {
        const Quaterniond there = FreeRotation(body, state).at(time_s).space_from_body;
        return 2.0 * std::min((there.coeffs() - here.coeffs()).norm(),
                              (there.coeffs() + here.coeffs()).norm());
    };
    constexpr double up = std::numeric_limits<double>::infinity();
    double worst = 0.0;
    for (int i = 0; i < 3; ++i) {
        Vector3d moments = inertia.moments_kg_m2();
        moments[i] = std::nextafter(moments[i], up);
        worst =
            std::max(worst, moved(InertiaTensor::from_principal_axes(
                                      moments, inertia.body_from_principal(), Physicality::waived),
                                  start));
        RotationState other = start;
        other.omega_body[i] = std::nextafter(other.omega_body[i], up);
        worst = std::max(worst, moved(inertia, other));
    }
    return worst;
}

}  // namespace poinsot
