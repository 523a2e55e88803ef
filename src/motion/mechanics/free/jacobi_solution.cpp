#include "mechanics/free/jacobi_solution.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/elliptic_integrals.h"
#include "numerics/expansion.h"

namespace poinsot {

namespace {

using Eigen::Vector3d;

// value = significand·2^exponent with the significand in ±[½, 1).
struct Scaled {
    double significand;
    int exponent;
};
Scaled scaled(double value) {
    Scaled result{};
    result.significand = std::frexp(value, &result.exponent);
    return result;
}

// I ω² (I − J) as an expansion of significands, and its exponent.
struct ScaledTerm {
    Expansion significand{0.0};
    int exponent = 0;
    bool zero = true;
};
ScaledTerm momentum_term(double I, double w, double J) {
    ScaledTerm term;
    const DoubleDouble difference = two_sum(I, -J);
    if (w == 0.0 || difference.hi == 0.0) return term;
    const Scaled moment = scaled(I);
    const Scaled rate = scaled(w);
    const int e = scaled(difference.hi).exponent;
    term.significand = Expansion(moment.significand)
                           .times(rate.significand)
                           .times(rate.significand)
                           .times(ldexp(difference, -e));
    term.exponent = moment.exponent + 2 * rate.exponent + e;
    term.zero = false;
    return term;
}

}  // namespace

// The two terms cancel for the middle moment, so the sum is exact before it is rounded once.
WideDouble momentum_difference(const Vector3d& I, const Vector3d& w, int i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    ScaledTerm x = momentum_term(I[j], w[j], I[i]);
    ScaledTerm y = momentum_term(I[k], w[k], I[i]);
    if (x.exponent < y.exponent) std::swap(x, y);
    const WideDouble first(x.significand.value(), x.exponent);
    if (y.zero) return first;
    if (x.zero) return WideDouble(y.significand.value(), y.exponent);
    const int shift = y.exponent - x.exponent;
    // Terms of such different sizes do not cancel.
    if (shift < -60) return first + WideDouble(y.significand.value(), y.exponent);
    return WideDouble(x.significand.plus(y.significand.times(std::ldexp(1.0, shift))).value(),
                      x.exponent);
}

namespace {

WideDouble exact_difference(double x, double y) { return WideDouble(two_sum(x, -y)); }

// Principal axes from the lowest moment to the highest.
std::array<int, 3> ranked(const Vector3d& I) {
    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return I[i] < I[j]; });
    return order;
}

bool is_steady(const Vector3d& I, const Vector3d& w) {
    const auto pair_is_idle = [&](int i, int j) {
        return I[i] == I[j] || w[i] == 0.0 || w[j] == 0.0;
    };
    return pair_is_idle(0, 1) && pair_is_idle(1, 2) && pair_is_idle(0, 2);
}

// u₀/2K (u₀ on the separatrix), taken from whichever zero of sn or cn is nearer.
WideDouble start_phase(const JacobiSolution& j) {
    const bool infinite_period = j.complementary_modulus.is_zero();
    if (!(square(j.dn) < j.complementary_modulus)) {
        const WideDouble u = j.sn * carlson_rf(square(j.cn), square(j.dn), 1.0);
        return infinite_period ? u : u / ldexp(j.quarter_period, 1);
    }
    // sn(K − u) = cn/dn, cn(K − u) = k′ sn/dn, dn(K − u) = k′/dn (DLMF 22.4(iii)).
    const WideDouble dn = j.complementary_modulus / j.dn;
    const WideDouble to_quarter = j.cn / j.dn * carlson_rf(square(dn * j.sn), square(dn), 1.0);
    const WideDouble phase = WideDouble(0.5) - to_quarter / ldexp(j.quarter_period, 1);
    return j.sn.sign() < 0 ? -phase : phase;
}

// Chooses a, b, c and their signs.
void choose_axes(JacobiSolution& j, const Vector3d& I, const Vector3d& w, bool on_separatrix) {
    const auto [lowest, middle, highest] = ranked(I);
    const bool about_highest = on_separatrix || momentum_difference(I, w, middle).sign() >= 0;
    const int a = about_highest ? highest : lowest;
    const int c = about_highest ? lowest : highest;
    j.axis = {a, middle, c};
    j.s = about_highest ? -1 : 1;
    j.sign[0] = w[a] < 0.0 ? -1.0 : 1.0;
    j.sign[2] = j.s * w[c] < 0.0 ? -1.0 : 1.0;
    const bool cyclic = (middle - a + 3) % 3 == 1;
    j.sign[1] = (cyclic ? 1.0 : -1.0) * j.sign[0] * j.sign[2];
}

// Amplitudes, moduli and periods.
void set_periods(JacobiSolution& j, const WideDouble& ba, const WideDouble& bc,
                 const WideDouble& ca) {
    const auto& [Ia, Ib, Ic] = j.moments;
    const auto& [delta_a, delta_b, delta_c] = j.delta;
    j.amplitude = {sqrt(Ia * delta_c / -ca), sqrt(Ib * delta_a / ba), sqrt(Ic * delta_a / ca)};
    j.modulus = sqrt(delta_a * bc / (delta_c * ba));
    j.complementary_modulus = sqrt(delta_b * ca / (delta_c * ba));
    j.rate = sqrt(abs(delta_c * ba / (Ia * Ib * Ic)));
    j.sn = j.start[1] / j.amplitude[1];
    j.cn = abs(j.start[2]) / j.amplitude[2];
    j.dn = j.start[0] / j.amplitude[0];
    if (!j.complementary_modulus.is_zero()) {
        j.quarter_period = complete_first_kind(j.complementary_modulus);
    }
    if (j.modulus.is_zero()) return;
    j.complementary_quarter_period = complete_first_kind(j.modulus);

    // F(φ, k′) with tan²φ = Ic|Ib − Ia|/(Ia|Ic − Ib|), where sin²φ + cos²φ = 1 needs no difference.
    const WideDouble whole = Ib * abs(ca);
    const WideDouble sin2 = Ic * abs(ba) / whole;
    const WideDouble cos2 = Ia * abs(bc) / whole;
    j.third_kind_argument = sqrt(sin2) * carlson_rf(cos2, cos2 + square(j.modulus) * sin2, 1.0);
}

// The mean over a period of ψ̇ = L/Ia − (Δa/Ia)/(L + ma). With p = Ib(Ic − Ia)/(Ic(Ib − Ia)) and p
// − 1 = Ia(Ic − Ib)/(Ic(Ib − Ia)), the large term L/Ia of a needle cancels analytically.
WideDouble mean_turn_rate(const JacobiSolution& j, const WideDouble& ba, const WideDouble& bc,
                          const WideDouble& ca) {
    const auto& [Ia, Ib, Ic] = j.moments;
    if (j.complementary_modulus.is_zero()) return j.twice_energy / j.momentum;
    const WideDouble p = Ib * ca / (Ic * ba);
    const WideDouble kc = j.complementary_modulus;
    const WideDouble& K = j.quarter_period;
    const WideDouble along_c = j.momentum / Ic * bulirsch_cel(kc, p, 1.0, 1.0) / K;
    const WideDouble across = -j.momentum * bc / (Ic * ba) * bulirsch_cel(kc, p, 0.0, 1.0) / K;
    const WideDouble spin =
        j.amplitude[0] / Ia * sqrt(ba * ca / (Ib * Ic)) * WideDouble(pi_dd) / ldexp(K, 1);
    return along_c + across + (j.s > 0 ? spin : -spin);
}

// L and its differences on the separatrix, from 2T.
void put_momentum_on_separatrix(JacobiSolution& j) {
    j.momentum = sqrt(j.twice_energy * j.moments[1]);
    for (std::size_t i = 0; i < 3; ++i)
        j.delta[i] = i == 1 ? WideDouble() : j.twice_energy * (j.moments[1] - j.moments[i]);
}

// The start on the separatrix, where cn = dn, from the smaller of sn and cn.
void put_start_on_separatrix(JacobiSolution& j) {
    const double side = j.sn.sign() < 0 ? -1.0 : 1.0;
    if (abs(j.sn) < j.cn)
        j.cn = sqrt(WideDouble(1.0) - square(j.sn));
    else
        j.sn = sqrt(WideDouble(1.0) - square(j.cn)) * side;
    j.dn = j.cn;
    j.start = {j.amplitude[0] * j.dn, j.amplitude[1] * j.sn, j.amplitude[2] * j.cn * j.s};
}

}  // namespace

JacobiSolution solve_free_rotation(const Vector3d& moments_kg_m2, const Vector3d& omega_principal,
                                   bool on_separatrix) {
    const Vector3d& I = moments_kg_m2;
    const Vector3d& w = omega_principal;
    JacobiSolution j;
    WideDouble L2;
    for (int i = 0; i < 3; ++i) {
        const WideDouble m = WideDouble(I[i]) * w[i];
        L2 = L2 + square(m);
        j.twice_energy = j.twice_energy + m * w[i];
    }
    j.momentum = sqrt(L2);
    if (L2.is_zero()) return j;
    choose_axes(j, I, w, on_separatrix);
    if (is_steady(I, w)) {
        j.regime = Regime::permanent;
        return j;
    }

    const auto [a, b, c] = j.axis;
    for (int i = 0; i < 3; ++i) {
        const int axis = j.axis[i];
        j.moments[i] = I[axis];
        j.start[i] = WideDouble(I[axis]) * (j.sign[i] * w[axis]);
        j.delta[i] = momentum_difference(I, w, axis);
    }
    if (on_separatrix) put_momentum_on_separatrix(j);
    const WideDouble ba = exact_difference(I[b], I[a]);
    const WideDouble bc = exact_difference(I[b], I[c]);
    const WideDouble ca = exact_difference(I[c], I[a]);
    set_periods(j, ba, bc, ca);
    if (on_separatrix) put_start_on_separatrix(j);
    j.start_phase = start_phase(j);
    j.mean_turn_rate = mean_turn_rate(j, ba, bc, ca);
    j.regime = j.complementary_modulus.is_zero() ? Regime::separatrix
               : bc.is_zero()                    ? Regime::symmetric
               : j.s > 0                         ? Regime::elliptic_about_lowest
                                                 : Regime::elliptic_about_highest;
    return j;
}

}  // namespace poinsot
