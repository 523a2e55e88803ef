// The free motion at an instant: what FreeRotation's setup is for.
#include <cmath>
#include <numbers>

#include "error/error.h"
#include "mechanics/free_rotation.h"

namespace poinsot {

namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

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

}  // namespace poinsot
