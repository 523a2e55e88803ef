// Jacobi's solution as rapidly converging series with coefficients in double, which are evaluated
// at every instant.
//
// Both series are theta functions of a small nome: directly, q = exp(−πK′/K) ≤ 0.086, for k′ ≥ ½,
// and after Jacobi's imaginary transformation, q′ = exp(−πK/K′) ≤ 0.018, below; the separatrix is
// the limit q′ = 0. Source: DLMF 20.2, 20.7(viii), 22.2; the integral of the third kind is the
// argument of a theta function Θ of periods 2K and 4iK′ that vanishes at u = −iβ.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "mechanics/free/jacobi_solution.h"
#include "numerics/turn_functions.h"

namespace poinsot {

// The direction of the momentum along a, b, c times a weight, and the rotation about it as a rotor
// ∝ exp(iψ/2). The weight avoids a division before the quaternion's length is known.
struct SeriesPoint {
    Pair weight_a;
    Pair b_c;
    Pair rotor;  // (re, im), of squared length κ·(weight + a), κ a constant of the motion
};

// Theta functions of v = πu/2K as polynomials in x = sin²v; a symmetric body is the case q = 0.
struct TrigonometricSeries {
    // The pairs of a SeriesPoint without the factors sin v of b, cos v of c and both of im; column
    // n has the coefficients of xⁿ. The rotor is
    // Θ = 1 − ρe^{2iv} − ρ′e^{−2iv} + q⁴(ρ²e^{4iv} + ρ′²e^{−4iv}) − …, conjugated for s = +1;
    // ρ = e^{−πβ/K}, ρ′ = q⁴/ρ.
    using Polynomial = std::array<Pair, 4>;
    Polynomial weight_a{}, b_c{}, rotor{};
    DoubleDouble kappa = 1.0;  // |Θ|² over weight + a

    // Evaluates the series at (sin v, cos v).
    SeriesPoint at(Pair sin_cos) const {
        const Pair sin = both(sin_cos[0]);
        const Pair x = sin * sin;
        const Pair x2 = x * x;
        const auto sum = [=](const Polynomial& p) {
            return (p[0] + p[1] * x) + (p[2] + p[3] * x) * x2;
        };
        return {sum(weight_a), sum(b_c) * sin_cos, sum(rotor) * Pair{1.0, sin_cos[0] * sin_cos[1]}};
    }
};

// Theta functions in X = E² and Y = F², where E = exp(−π|r|/2K′), F = exp(−π(K − |r|)/2K′) = Q/E,
// and r is u minus its nearest multiple of 2K.
struct HyperbolicSeries {
    double exponent_high = 0.0;  // −128 log₂ of E at r = K, in two words, the first of 26 bits
    double exponent_low = 0.0;
    double root_nome_up = 0.0;      // 2^512 Q, Q = √q′: normal even where Q is subnormal
    double phase_per_period = 0.0;  // quarter turns that Θ's argument gains in 2K; also conjugated
    double a = 0.0, b = 0.0, c = 0.0;
    // Powers of q′, and the factors of the series over 1 − X and 1 − Y, each twice.
    Pair q1{}, q2{}, q4{}, q6{}, q9{};
    Pair zero_0 = both(1.0), zero_1{}, zero_2{};
    // Θ ∝ Σ Qⁿ²Fⁿ e^{∓i(2n+1)δ} + Σ Qⁿ²⁺ⁿEⁿ⁺¹ e^{±i(2n+1)δ}, conjugated for s = +1, as (re, im);
    // δ = πF(φ,k′)/4K′.
    std::array<Pair, 5> in_F{};
    std::array<Pair, 4> in_E{};
    bool is_short = false;     // Q⁴ is negligible beside 1
    DoubleDouble kappa = 1.0;  // |Θ|² over weight + a

    // r from the phase, which is u in units of K: the side of the nearest even multiple of K that r
    // is on, whether that multiple is an odd multiple of 2K, and r/2K.
    struct Place {
        double side;
        double parity;
        double periods;
        bool nearer_odd;
    };
    static Place place(const QuarterTurns& phase) {
        const bool odd = (phase.whole & 1U) != 0;
        const double sign = std::copysign(1.0, phase.rest.hi);
        const double flip = (phase.whole & 2U) != 0 ? -1.0 : 1.0;
        if (odd) return {-sign, -sign * flip, 0.5 * (phase.rest.hi - sign), true};
        return {sign, flip, 0.5 * phase.rest.hi, false};
    }

    [[gnu::always_inline]] SeriesPoint at(const QuarterTurns& phase, const Place& place) const {
        // The larger of E and F is the exponential of the distance to the nearest multiple of K, so
        // that 1 − X and 1 − Y keep their relative accuracy at the zeros of sn and cn.
        const DoubleDouble h = abs(phase.rest);
        const DoubleDouble halves = split(h.hi);
        const PowersOfHalf near = powers_of_half(
            halves.hi * exponent_high,
            halves.hi * exponent_low + (halves.lo + h.lo) * (exponent_high + exponent_low),
            root_nome_up);
        return place.nearer_odd
                   ? sum(swapped(near.powers), swapped(near.complements), place.side, place.parity)
                   : sum(near.powers, near.complements, place.side, place.parity);
    }

    // On the separatrix u is not reduced; E and 1 − E are given.
    SeriesPoint at_separatrix(double E, double one_less_E, double side) const {
        return sum_short(Pair{E, 0.0}, Pair{one_less_E, 1.0}, side, 1.0);
    }

 private:
    // At (E, F) with (1 − E, 1 − F).
    [[gnu::always_inline]] SeriesPoint sum(Pair powers, Pair complements, double side,
                                           double parity) const {
        if (is_short) return sum_short(powers, complements, side, parity);
        const Pair seen = visible(powers);
        const Pair z = seen * seen;
        const Pair other = swapped(z);
        const Pair q6_z = q6 * z;
        const Pair q9_other = q9 * other;
        const Pair weight_dn =
            1.0 + (z * (1.0 + z * (q2 + q6_z)) + other * (q1 + other * (q4 + q9_other)));
        // sn's and cn's series over 1 − X and 1 − Y, with XY = q′.
        const Pair over_zero =
            zero_0 + (other * (zero_1 + other * (q4 - q9_other)) + z * (zero_2 + q6_z));
        const Pair E = both(seen[0]);
        const Pair F = both(seen[1]);
        const Pair X = both(z[0]);
        const Pair Y = both(z[1]);
        const Pair rotor = ((in_F[0] + F * in_F[1]) + Y * ((in_F[2] + F * in_F[3]) + Y * in_F[4])) +
                           E * ((in_E[0] + E * in_E[1]) + X * (in_E[2] + E * in_E[3]));
        return joined(powers, complements, weight_dn, over_zero, rotor, side, parity);
    }
    [[gnu::always_inline]] SeriesPoint sum_short(Pair powers, Pair complements, double side,
                                                 double parity) const {
        const Pair seen = visible(powers);
        const Pair z = seen * seen;
        const Pair other = swapped(z);
        const Pair q1_other = q1 * other;
        const Pair E = both(seen[0]);
        const Pair F = both(seen[1]);
        const Pair rotor = (in_F[0] + F * in_F[1]) + E * (in_E[0] + E * in_E[1]);
        return joined(powers, complements, 1.0 + (z + q1_other), 1.0 - q1_other, rotor, side,
                      parity);
    }

    // Sets powers below 2^−60 to zero: they are negligible beside 1 and would give slow subnormal
    // numbers.
    static Pair visible(Pair powers) { return powers > 0x1p-60 ? powers : both(0.0); }

    // dn's, sn's and cn's outer factors.
    [[gnu::always_inline]] SeriesPoint joined(Pair powers, Pair complements, Pair weight_dn,
                                              Pair over_zero, Pair rotor, double side,
                                              double parity) const {
        const Pair sn_cn = complements * (1.0 + powers) * over_zero;
        return {weight_dn * Pair{1.0, a * powers[0]},
                sn_cn * Pair{parity * side * b, parity * (c * powers[0])}, rotor * Pair{1.0, side}};
    }
};

// The coefficients of one motion. Precondition: the series suits its k′.
TrigonometricSeries trigonometric_series(const JacobiSolution& solution);
HyperbolicSeries hyperbolic_series(const JacobiSolution& solution);

// From k′ = ½ up the trigonometric series converges faster.
inline bool suits_trigonometric(const JacobiSolution& solution) {
    return !(solution.complementary_modulus < 0.5);
}

// (re, im) of exp(iψ/2) at the start without the mean rotation, of unit length, in double-double.
std::array<DoubleDouble, 2> start_rotor(const JacobiSolution& solution);

}  // namespace poinsot
