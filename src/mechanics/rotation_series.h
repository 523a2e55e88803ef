// Jacobi's solution as rapidly converging series with coefficients in double: what is evaluated at
// every instant.
//
// Both series are theta functions of a small nome: directly, q = exp(−πK′/K) ≤ 0.086, for k′ ≥ ½,
// and after Jacobi's imaginary transformation, q′ = exp(−πK/K′) ≤ 0.018, below; the separatrix is
// the plain case q′ = 0. Source: DLMF 20.2, 20.7(viii), 22.2; the integral of the third kind is the
// argument of a theta function Θ of periods 2K and 4iK′ that vanishes at u = −iβ.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "mechanics/jacobi_solution.h"
#include "mechanics/turn_functions.h"

namespace poinsot {

// Direction of the momentum along a, b, c times a weight, which spares a division before the
// quaternion's length is known, and the turn about it as a rotor ∝ exp(iψ/2).
struct SeriesPoint {
    double weight;
    double a;
    double b;
    double c;
    double re;
    double im;
};

// Theta functions of v = πu/2K as polynomials in x = sin²v; a symmetric body is the case q = 0.
struct TrigonometricSeries {
    // Row by row what a SeriesPoint holds, with sin v taken out of b, cos v out of c and both out
    // of im; column n has the factors of xⁿ. The rotor is
    // Θ = 1 − ρe^{2iv} − ρ′e^{−2iv} + q⁴(ρ²e^{4iv} + ρ′²e^{−4iv}) − …, conjugated for s = +1;
    // ρ = e^{−πβ/K}, ρ′ = q⁴/ρ.
    using Values = Eigen::Array<double, 6, 1>;
    Eigen::Array<double, 6, 4> factors = Eigen::Array<double, 6, 4>::Zero();

    SeriesPoint at(SinCos v) const {
        const double x = v.sin * v.sin;
        const double x2 = x * x;
        const Values p =
            (factors.col(0) + factors.col(1) * x) + (factors.col(2) + factors.col(3) * x) * x2;
        return {p[0], p[1], v.sin * p[2], v.cos * p[3], p[4], v.sin * v.cos * p[5]};
    }
};

// Theta functions in X = E² and Y = F², where E = exp(−π|r|/2K′), F = exp(−π(K − |r|)/2K′) = Q/E,
// and r is u less its nearest multiple of 2K.
struct HyperbolicSeries {
    double exponent_high = 0.0;  // −log₂ of E at r = K, in two words, the first of 26 bits
    double exponent_low = 0.0;
    double root_nome_up = 0.0;      // 2^512 Q, Q = √q′: a normal number even where Q is not
    double phase_per_period = 0.0;  // quarter turns that Θ's argument gains in 2K, conjugated too
    double a = 0.0, b = 0.0, c = 0.0;
    double q1 = 0.0, q2 = 0.0, q4 = 0.0, q6 = 0.0, q9 = 0.0;  // powers of q′
    double zero_0 = 1.0, zero_1 = 0.0, zero_2 = 0.0;
    // Θ ∝ Σ Qⁿ²Fⁿ e^{∓i(2n+1)δ} + Σ Qⁿ²⁺ⁿEⁿ⁺¹ e^{±i(2n+1)δ}, conjugated for s = +1; δ =
    // πF(φ,k′)/4K′.
    std::array<double, 5> cos_F{}, sin_F{};
    std::array<double, 4> cos_E{}, sin_E{};

    // What the phase, u in units of K, says of r: the side of the nearest even multiple of K it is
    // on, whether that is an odd multiple of 2K, and r/2K.
    struct Place {
        double side;
        double parity;
        double periods;
        bool nearer_odd;
    };
    static Place place(const QuarterTurns& phase) {
        const bool odd = (phase.whole & 1U) != 0;
        const double sign = std::copysign(1.0, phase.rest);
        const double flip = (phase.whole & 2U) != 0 ? -1.0 : 1.0;
        if (odd) return {-sign, -sign * flip, 0.5 * (phase.rest - sign), true};
        return {sign, flip, 0.5 * phase.rest, false};
    }

    SeriesPoint at(const QuarterTurns& phase, const Place& place) const {
        // The larger of E and F is the exponential of the distance to the nearest multiple of K, so
        // that 1 − X and 1 − Y keep their relative accuracy at the zeros of sn and cn.
        const double h = std::abs(phase.rest);
        const double h_low = std::copysign(1.0, phase.rest) * phase.rest_low;
        const DoubleDouble halves = split(h);
        const PowerOfHalf near = power_of_half(
            halves.hi * exponent_high,
            halves.hi * exponent_low + (halves.lo + h_low) * (exponent_high + exponent_low));
        const double far = 0x1p-512 * (root_nome_up / near.power);
        return place.nearer_odd
                   ? sum(far, near.power, 1.0 - far, near.complement, place.side, place.parity)
                   : sum(near.power, far, near.complement, 1.0 - far, place.side, place.parity);
    }

    // On the separatrix u is not reduced; x is |u|/ln 2.
    SeriesPoint at_separatrix(DoubleDouble x, double side) const {
        const PowerOfHalf near = power_of_half(x.hi, x.lo);
        return sum(near.power, 0.0, near.complement, 1.0, side, 1.0);
    }

 private:
    SeriesPoint sum(double E, double F, double one_less_E, double one_less_F, double side,
                    double parity) const {
        // Beside 1, what is below 2^−60 is nothing; as zero it makes no slow subnormal numbers.
        const double E_seen = E > 0x1p-60 ? E : 0.0;
        const double F_seen = F > 0x1p-60 ? F : 0.0;
        const double X = E_seen * E_seen;
        const double Y = F_seen * F_seen;
        const auto near_sum = [this](double z) { return z * (1.0 + z * (q2 + q6 * z)); };
        const auto far_sum = [this](double z) { return z * (q1 + z * (q4 + q9 * z)); };
        // sn's and cn's series over 1 − X and 1 − Y, with XY = q′.
        const auto zero_near = [this](double z) { return z * (zero_1 + z * (q4 - q9 * z)); };
        const auto zero_far = [this](double z) { return z * (zero_2 + q6 * z); };
        const double weight = 1.0 + near_sum(X) + far_sum(Y);
        const double dn = E * (1.0 + (near_sum(Y) + far_sum(X)));
        const double sn = one_less_E * (1.0 + E) * (zero_0 + (zero_near(Y) + zero_far(X)));
        const double cn = E * (one_less_F * (1.0 + F)) * (zero_0 + (zero_near(X) + zero_far(Y)));

        const auto in_F = [=](const std::array<double, 5>& p) {
            return p[0] + F_seen * (p[1] + F_seen * (p[2] + F_seen * (p[3] + F_seen * p[4])));
        };
        const auto in_E = [=](const std::array<double, 4>& p) {
            return E_seen * (p[0] + E_seen * (p[1] + E_seen * (p[2] + E_seen * p[3])));
        };
        return {weight,
                a * dn,
                parity * side * (b * sn),
                parity * (c * cn),
                in_F(cos_F) + in_E(cos_E),
                side * (in_F(sin_F) + in_E(sin_E))};
    }
};

// The coefficients of one motion. Precondition: the series suits its k′.
TrigonometricSeries trigonometric_series(const JacobiSolution& solution);
HyperbolicSeries hyperbolic_series(const JacobiSolution& solution);

// From k′ = ½ up the trigonometric series converges faster.
inline bool suits_trigonometric(const JacobiSolution& solution) {
    return !(solution.complementary_modulus < 0.5);
}

// (re, im) of exp(iψ/2) at the start but for the mean turn, of unit length, in double-double.
std::array<DoubleDouble, 2> start_rotor(const JacobiSolution& solution);

}  // namespace poinsot
