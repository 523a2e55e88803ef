// Evaluation of the free motion at an instant.
#include <cmath>

#include "error/error.h"
#include "mechanics/euler_angles.h"
#include "mechanics/free/free_rotation.h"

namespace poinsot {

// The scaled time. Throws where ω t overflows.
inline double FreeRotation::scaled_time(double time_s) const {
    const double time = time_s * unit_rad_s_;
    if (!std::isfinite(time)) {
        throw InputError(
            "time_s: omega t overflows or the time is not finite; choose a time nearer the start");
    }
    return time;
}

// The point functions and the finish are inlined, which keeps a SeriesPoint in registers.
[[gnu::always_inline]] inline SeriesPoint FreeRotation::trigonometric_point(double time) const {
    const SinCosPair turns = sin_cos(fine(phases_.at(time)));
    SeriesPoint point = trigonometric_.at(firsts(turns.sin, turns.cos));
    point.rotor = complex_product(point.rotor, seconds(turns.cos, turns.sin));
    return point;
}

[[gnu::always_inline]] inline SeriesPoint FreeRotation::hyperbolic_point(double time) const {
    const QuarterTurnPair turns = phases_.at(time);
    const QuarterTurns phase = turns[series_phase];
    const HyperbolicSeries::Place place = HyperbolicSeries::place(phase);
    SeriesPoint point = hyperbolic_.at(phase, place);
    const Pair turn = sin_cos(turns[mean_turn], hyperbolic_.phase_per_period * place.periods);
    point.rotor = complex_product(point.rotor, swapped(turn));
    return point;
}

[[gnu::always_inline]] inline SeriesPoint FreeRotation::separatrix_point(double time) const {
    const DoubleDouble rate = phases_.rate(series_phase);
    const DoubleDouble start = phases_.start(series_phase);
    DoubleDouble x = rate.hi * time + start.hi;
    const double side = x.hi < 0.0 ? -1.0 : 1.0;
    if (std::abs(x.hi) < 2000.0) x = rate * time + start;
    x = abs(DoubleDouble(128.0 * x.hi, 128.0 * x.lo));
    // Near the middle axis E decreases through the subnormal numbers to zero.
    double E = 0.0;
    double one_less_E = 1.0;
    if (x.hi <= 128'000.0) {
        const PowersOfHalf near = powers_of_half(x.hi, x.lo, 0.0);
        E = near.powers[0];
        one_less_E = near.complements[0];
    } else if (x.hi < 140'800.0) {
        E = 0x1p-600 * powers_of_half(x.hi - 76'800.0, x.lo, 0.0).powers[0];
    }
    SeriesPoint point = hyperbolic_.at_separatrix(E, one_less_E, side);
    const Pair turn = sin_cos(phases_.at(time)[mean_turn]);
    point.rotor = complex_product(point.rotor, swapped(turn));
    return point;
}

// P = (1 + n_a, 0, n_c, −n_b) takes the momentum's direction to a, and the rotor turns about a:
// |P|²·weight² = 2·weight·(weight + a), and |rotor|² = κ·(weight + a), because both sides of
// Θ(u)Θ(−u) ∝ θ₄(u)·(1 + A/L·dn u) have the same zeros, ±iβ, and no pole. The length of the
// quaternion is therefore known; it is computed all the same, which takes one rounding where these
// products take five.
[[gnu::always_inline]] inline void FreeRotation::finish(const SeriesPoint& point,
                                                        const Quantities& wanted,
                                                        MotionSample& out) const {
    const double weight = point.weight_a[0];
    const double a = point.weight_a[1];
    const double p0 = weight + a;
    // The processor computes the terms that need no quotient while the divisions run.
    const double g = 1.0 / (weight * p0);
    omega_from_direction_.product({a, point.b_c[0], point.b_c[1]}, g * (p0 * unit_rad_s_),
                                  out.state.omega_body);
    if (wanted.attitude || wanted.euler_angles) {
        const Pair across =
            both(point.b_c[1]) * point.rotor - both(point.b_c[0]) * times_i(point.rotor);
        const double scale =
            1.0 / std::sqrt((p0 * p0 + squared_length(point.b_c)) * squared_length(point.rotor));
        attitude_from_turn_.product(point.rotor * p0, across, scale, out.state.space_from_body);
    }
    if (wanted.herpolhode) {
        // h = ω_i(L² − 2T·I_i)/L² has no component along L: in the turned axes none along a.
        const Pair h = point.b_c * (herpolhode_bc_ * p0 - herpolhode_a_ * a);
        const Pair turned = complex_product(complex_product(point.rotor, point.rotor), h);
        plane_space_.product({turned[0], turned[1]}, g * g * (weight * unit_rad_s_),
                             out.herpolhode_space);
    }
}

// Permanent rotation, and rest.
void FreeRotation::steady(double time, const Quantities& wanted, MotionSample& out) const {
    out.state.omega_body = start_.omega_body;
    if (!wanted.attitude && !wanted.euler_angles) return;
    Pair half{0.0, 1.0};  // (sin, cos) of half the turn
    if (series_ != Series::none) half = sin_cos(phases_.at(time)[mean_turn]);
    const Eigen::Vector3d turn = half[0] * steady_axis_body_;
    attitude_from_turn_.product(Pair{half[1], turn[0]}, Pair{turn[1], turn[2]}, 1.0,
                                out.state.space_from_body);
}

// One function for each series, so that a series does not save registers that only another uses.
template <FreeRotation::Series series>
[[gnu::noinline]] void FreeRotation::evaluate_series(double time, const Quantities& wanted,
                                                     MotionSample& out) const {
    if constexpr (series == Series::trigonometric) {
        finish(trigonometric_point(time), wanted, out);
    } else if constexpr (series == Series::hyperbolic) {
        finish(hyperbolic_point(time), wanted, out);
    } else {
        finish(separatrix_point(time), wanted, out);
    }
}

inline void FreeRotation::evaluate(double time_s, const Quantities& wanted,
                                   MotionSample& out) const {
    out.state.time_s = time_s;
    const double time = scaled_time(time_s);
    switch (series_) {
        case Series::none:
        case Series::permanent:
            steady(time, wanted, out);
            break;
        case Series::trigonometric:
            evaluate_series<Series::trigonometric>(time, wanted, out);
            break;
        case Series::hyperbolic:
            evaluate_series<Series::hyperbolic>(time, wanted, out);
            break;
        case Series::separatrix:
            evaluate_series<Series::separatrix>(time, wanted, out);
            break;
    }
    // At the start the given state is returned; the series reproduce it only to rounding.
    if (time_s == start_.time_s) [[unlikely]] {
        out.state.omega_body = start_.omega_body;
        if (wanted.attitude || wanted.euler_angles) {
            out.state.space_from_body = start_.space_from_body;
        }
    }
}

RotationState FreeRotation::at(double time_s) const {
    MotionSample out;
    evaluate(time_s, {.attitude = true, .herpolhode = false, .euler_angles = false}, out);
    return out.state;
}

MotionSample FreeRotation::sample(double time_s, const Quantities& wanted) const {
    MotionSample out;
    evaluate(time_s, wanted, out);
    if (wanted.euler_angles) {
        out.euler = euler_angles_of(out.state.space_from_body);
        if (!wanted.attitude) out.state.space_from_body = Eigen::Quaterniond::Identity();
    }
    return out;
}

}  // namespace poinsot
