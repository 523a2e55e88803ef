#include "mechanics/top/heavy_top_setup.h"

#include <boost/math/special_functions/ellint_rf.hpp>
#include <cmath>
#include <limits>

#include "mechanics/top/heavy_top_elliptic.h"
#include "mechanics/top/heavy_top_regime.h"

namespace poinsot {

using namespace top_setup;

namespace {

DoubleDouble double_double(const Real& x) {
    const double hi = to_double(x);
    return {hi, std::isfinite(hi) ? to_double(x - Real(hi)) : 0.0};
}

// θ of an end of the nutation from x and y = 2 − x.
double angle_of(const Real& x, const Real& y) { return to_double(2 * atan2(sqrt(x), sqrt(y))); }

}  // namespace

void TopSetup::solve(const TopAtStart& given) {
    TopSeries& series = top.series_;
    series.reversed = given.mgl < 0;
    const TopAtStart start = series.reversed ? reversed(given) : given;
    cubic = solve_cubic(start);
    half_spin = (start.omega3 - cubic.a) / 2;
    if (cubic.steady) {
        fill_steady(series);
    } else {
        fill_nutating(series);
    }
    fill_public(given);
    top.start_[0] = {to_double(given.qw), to_double(given.qz)};
    top.start_[1] = {to_double(given.qx), to_double(given.qy)};
    top.fit_start({to_double(given.omega1), to_double(given.omega2)});
}

void TopSetup::set_rate(TopFactor& factor, int which, const Real& regular) {
    const Real rate = regular + (which == 0 ? half_spin : Real(-half_spin));
    factor.regular_rate_1_s = to_double(regular);
    factor.rate_1_s = double_double(rate);
    angle_rate[which] = 2 * rate;
    if (factor.zero) angle_rate[which] = 0;
}

void TopSetup::fill_steady(TopSeries& series) {
    series.steady = true;
    const Real squares[2] = {cubic.y0, cubic.x0};
    const Real constants[2] = {cubic.e, cubic.d};
    for (int which = 0; which < 2; ++which) {
        TopFactor& factor = series.factor[which];
        factor.zero = squares[which] == 0;
        factor.lower_amplitude = to_double(sqrt(squares[which]));
        factor.theta1_re[0] = 1.0;
        set_rate(factor, which,
                 factor.zero ? Real(0) : Real(constants[which] / (2 * squares[which])));
    }
}

void TopSetup::fill_nutating(TopSeries& series) {
    using boost::math::ellint_rf;
    const Cubic& c = cubic;
    const Modulus m(c);
    const Real top_value = c.beta * c.x1 + c.G;
    lambda = sqrt(top_value) / 2;
    quarter = m.K;
    const auto [quarter_start, u_start] = starting_phase(c, m);

    series.hyperbolic = m.hyperbolic;
    series.nome = to_double(m.nome);
    series.scaled = m.hyperbolic && series.nome < 1e-36;
    series.n_terms = series.scaled ? 1 : TopFactor::max_terms;
    series.lambda_1_s = double_double(lambda);
    series.quarter_u =
        m.K == 0 ? DoubleDouble{std::numeric_limits<double>::infinity(), 0.0} : double_double(m.K);
    series.quarter_start = quarter_start;
    series.u_start = double_double(u_start);
    series.argument_per_u = to_double(m.argument_per_u());

    // The zeros of 2 − x and of x lie at u = i v1 and K + i v2.
    const Real v1 = sqrt(c.y1 / c.y2) *
                    ellint_rf(Real(c.delta / c.y2),
                              Real(c.delta * (2 * c.beta + c.G) / (top_value * c.y2)), Real(1));
    Real v2 = 0;
    if (c.x2 > 0 || (c.d == 0 && c.X > 0)) {
        const Real denominator = c.x1 * (c.X + c.G);
        v2 = sqrt(c.x2 * top_value / denominator) *
             ellint_rf(Real(c.G * c.delta / denominator), Real(c.delta / c.x1), Real(1));
    }

    const Real slope1 = fill_series(m, v1, sign_of(c.e), series.factor[0]);
    const Real slope2 = fill_series(m, v2, sign_of(c.d), series.factor[1]);
    series.factor[0].through_zero = v1 == 0;
    series.factor[1].through_zero = v2 == 0;
    set_rate(series.factor[0], 0, c.e / (2 * c.y2) - lambda * slope1);
    set_rate(series.factor[1], 1, c.d / (2 * c.x1) - lambda * slope2);
    if (m.K != 0) {
        for (int which = 0; which < 2; ++which) {
            const TopFactor& factor = series.factor[which];
            if (!factor.through_zero) angle_rate[which] += factor.winding * pi * lambda / m.K;
        }
    }
    // By symmetry a vanishing constant leaves no mean rate but that of the spin.
    if (c.e == 0) angle_rate[0] = 2 * half_spin;
    if (c.d == 0) angle_rate[1] = -2 * half_spin;
    fill_amplitudes(series, m.k_prime);
}

void TopSetup::fill_amplitudes(TopSeries& series, const Real& k_prime) const {
    const Cubic& c = cubic;
    const Real root_k_prime = sqrt(k_prime);
    series.factor[0].lower_amplitude = to_double(sqrt(c.y2));
    series.factor[0].upper_amplitude[0] = to_double(sqrt(c.y2));
    if (series.hyperbolic) {
        series.factor[1].lower_amplitude = to_double(sqrt(c.x1));
        series.factor[1].upper_amplitude[0] = to_double(sqrt(c.x1) * root_k_prime);
        series.factor[1].upper_amplitude[1] = to_double(root_k_prime);
    } else {
        series.factor[1].lower_amplitude = to_double(sqrt(c.x1) * root_k_prime);
        series.factor[1].upper_amplitude[0] = series.factor[1].lower_amplitude;
    }
}

void TopSetup::fill_public(const TopAtStart& given) {
    const bool back = top.series_.reversed;
    top.moment_transverse_ = to_double(given.A);
    top.moment_axial_ = to_double(given.C);
    top.mgl_ = to_double(given.mgl);
    top.omega3_ = to_double(given.omega3);

    // Upright and reversed constants: d + a x = e' − a' y' and so on.
    const Real d = back ? cubic.e : cubic.d;
    const Real a = back ? Real(-cubic.a) : cubic.a;
    top.p_phi_minus_p_psi_ = to_double(given.A * d);
    top.invariants_.p_phi_kg_m2_s = to_double(given.A * (d + a));
    top.invariants_.p_psi_kg_m2_s = to_double(given.C * given.omega3);
    const Real x0 = back ? cubic.y0 : cubic.x0;
    const Real transverse = square(given.omega1) + square(given.omega2);
    top.invariants_.energy_J = to_double(
        (given.A * transverse + given.C * square(given.omega3)) / 2 + given.mgl * (1 - x0));

    // φ+ψ and φ−ψ at the start.
    const double alpha = to_double(2 * atan2(given.qz, given.qw));
    const double beta = to_double(2 * atan2(given.qy, given.qx));
    top.angle_start_[0] = given.qw == 0 && given.qz == 0 ? 0.0 : alpha;
    top.angle_start_[1] = given.qx == 0 && given.qy == 0 ? 0.0 : beta;

    fill_nutation();
    top.regime_ = regime_of(cubic);
}

void TopSetup::fill_nutation() {
    const bool back = top.series_.reversed;
    TopNutation& nutation = top.nutation_;
    nutation.theta_min_rad = back ? angle_of(cubic.y1, cubic.x1) : angle_of(cubic.x2, cubic.y2);
    nutation.theta_max_rad = back ? angle_of(cubic.y2, cubic.x2) : angle_of(cubic.x1, cubic.y1);
    if (cubic.steady) {
        // Small nutation about steady motion: x'' = 2 P2 (x − x0) to first order.
        const Real stiffness = -cubic.p2;
        const bool moves = cubic.x0 > 0 && cubic.y0 > 0 && stiffness > 0;
        nutation.period_s = moves ? to_double(2 * pi / sqrt(stiffness)) : 0.0;
    } else {
        nutation.period_s = quarter == 0 ? std::numeric_limits<double>::infinity()
                                         : to_double(2 * quarter / lambda);
    }
    const Real sum = back ? angle_rate[1] : angle_rate[0];
    const Real difference = back ? angle_rate[0] : angle_rate[1];
    nutation.precession_rate_rad_s = to_double((sum + difference) / 2);
    nutation.spin_rate_rad_s = to_double((sum - difference) / 2);
}

}  // namespace poinsot
