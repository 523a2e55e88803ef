#include "mechanics/top/heavy_top_setup.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/top/heavy_top_elliptic.h"
#include "mechanics/top/heavy_top_regime.h"
#include "numerics/wide_functions.h"

namespace poinsot {

using namespace top_setup;

namespace {

DoubleDouble double_double(const WideDouble& x) {
    const DoubleDouble value = x.double_double();
    return {value.hi, std::isfinite(value.hi) ? value.lo : 0.0};
}

// The exponent of the fastest of ω, a and √(|Mgl|/A); 0 for a top at rest without gravity.
int rate_exponent_of(const TopAtStart& s) {
    int exponent = 0;
    bool is_first = true;
    for (const WideDouble& rate :
         {s.omega1, s.omega2, s.omega3, WideDouble(s.C * s.omega3 / s.A), sqrt(abs(s.mgl) / s.A)}) {
        if (rate.is_zero()) continue;
        exponent = is_first ? rate.exponent() : std::max(exponent, rate.exponent());
        is_first = false;
    }
    return exponent;
}

// θ of an end of the nutation from x and y = 2 − x.
double angle_of(const WideDouble& x, const WideDouble& y) {
    return (2 * atan2(sqrt(x), sqrt(y))).rounded();
}

}  // namespace

void TopSetup::solve(const TopAtStart& given) {
    TopSeries& series = top.series_;
    const int exponent = top.rate_exponent_ = rate_exponent_of(given);
    TopAtStart scaled = given;
    for (WideDouble* rate : {&scaled.omega1, &scaled.omega2, &scaled.omega3})
        *rate = ldexp(*rate, -exponent);
    scaled.mgl = ldexp(given.mgl, -2 * exponent);
    series.reversed = given.mgl < 0;
    const TopAtStart start = series.reversed ? reversed(scaled) : scaled;
    cubic = solve_cubic(start);
    half_spin = (start.omega3 - cubic.a) / 2;
    if (cubic.steady) {
        fill_steady(series);
    } else {
        fill_nutating(series);
    }
    series.phase_rate =
        (regular_rate + lambda * (series.factor[0].cell_rate + series.factor[1].cell_rate))
            .rounded();
    fill_public(given);
    top.start_[0] = {given.qw.rounded(), given.qz.rounded()};
    top.start_[1] = {given.qx.rounded(), given.qy.rounded()};
    top.fit_start({scaled.omega1.rounded(), scaled.omega2.rounded()});
}

void TopSetup::set_rate(TopFactor& factor, int which, const WideDouble& regular) {
    const WideDouble rate = regular + (which == 0 ? half_spin : WideDouble(-half_spin));
    factor.regular_rate = regular.rounded();
    regular_rate = regular_rate + regular;
    factor.rate = double_double(rate);
    angle_rate[which] = 2 * rate;
    if (factor.zero) angle_rate[which] = 0;
}

void TopSetup::fill_steady(TopSeries& series) {
    series.steady = true;
    const WideDouble squares[2] = {cubic.y0, cubic.x0};
    const WideDouble constants[2] = {cubic.e, cubic.d};
    for (int which = 0; which < 2; ++which) {
        TopFactor& factor = series.factor[which];
        factor.zero = squares[which] == 0;
        factor.lower_amplitude = sqrt(squares[which]).rounded();
        factor.theta1_re[0] = 1.0;
        set_rate(factor, which,
                 factor.zero ? WideDouble(0) : WideDouble(constants[which] / (2 * squares[which])));
    }
}

void TopSetup::fill_nutating(TopSeries& series) {
    const Cubic& c = cubic;
    const Modulus m(c);
    const WideDouble top_value = c.beta * c.x1 + c.G;
    lambda = sqrt(top_value) / 2;
    quarter = m.K;
    const auto [quarter_start, u_start] = starting_phase(c, m);

    series.hyperbolic = m.hyperbolic;
    series.nome = m.nome.rounded();
    series.scaled = m.hyperbolic && series.nome < 1e-36;
    series.n_terms = series.scaled ? 1 : TopFactor::max_terms;
    series.lambda = double_double(lambda);
    series.quarter_u =
        m.K == 0 ? DoubleDouble{std::numeric_limits<double>::infinity(), 0.0} : double_double(m.K);
    series.quarter_start = quarter_start;
    series.u_start = double_double(u_start);
    series.argument_per_u = m.argument_per_u().rounded();

    // The zeros of 2 − x and of x lie at u = i v1 and K + i v2.
    const WideDouble v1 =
        sqrt(c.y1 / c.y2) *
        carlson_rf(WideDouble(c.delta / c.y2),
                   WideDouble(c.delta * (2 * c.beta + c.G) / (top_value * c.y2)), WideDouble(1));
    WideDouble v2 = 0;
    if (c.x2 > 0 || (c.d == 0 && c.X > 0)) {
        const WideDouble denominator = c.x1 * (c.X + c.G);
        v2 = sqrt(c.x2 * top_value / denominator) *
             carlson_rf(WideDouble(c.G * c.delta / denominator), WideDouble(c.delta / c.x1),
                        WideDouble(1));
    }

    const WideDouble slope1 = fill_series(m, v1, sign_of(c.e), series.factor[0]);
    const WideDouble slope2 = fill_series(m, v2, sign_of(c.d), series.factor[1]);
    series.factor[0].through_zero = v1 == 0;
    series.factor[1].through_zero = v2 == 0;
    set_rate(series.factor[0], 0, c.e / (2 * c.y2) - lambda * slope1);
    set_rate(series.factor[1], 1, c.d / (2 * c.x1) - lambda * slope2);
    if (m.K != 0) {
        for (int which = 0; which < 2; ++which) {
            const TopFactor& factor = series.factor[which];
            if (!factor.through_zero)
                angle_rate[which] = angle_rate[which] + factor.winding * pi * lambda / m.K;
        }
    }
    // If this constant vanishes, by symmetry only the spin has a mean rate.
    if (c.e == 0) angle_rate[0] = 2 * half_spin;
    if (c.d == 0) angle_rate[1] = -2 * half_spin;
    fill_amplitudes(series, m.k_prime);
}

void TopSetup::fill_amplitudes(TopSeries& series, const WideDouble& k_prime) const {
    const Cubic& c = cubic;
    const WideDouble root_k_prime = sqrt(k_prime);
    series.factor[0].lower_amplitude = sqrt(c.y2).rounded();
    series.factor[0].upper_amplitude[0] = sqrt(c.y2).rounded();
    if (series.hyperbolic) {
        series.factor[1].lower_amplitude = sqrt(c.x1).rounded();
        series.factor[1].upper_amplitude[0] = (sqrt(c.x1) * root_k_prime).rounded();
        series.factor[1].upper_amplitude[1] = root_k_prime.rounded();
    } else {
        series.factor[1].lower_amplitude = (sqrt(c.x1) * root_k_prime).rounded();
        series.factor[1].upper_amplitude[0] = series.factor[1].lower_amplitude;
    }
}

void TopSetup::fill_public(const TopAtStart& given) {
    const bool back = top.series_.reversed;
    top.moment_transverse_ = given.A.rounded();
    top.moment_axial_ = given.C.rounded();
    top.mgl_ = given.mgl.rounded();
    top.omega3_ = given.omega3.rounded();

    // Upright and reversed constants: d + a x = e' − a' y' and so on.
    const int exponent = top.rate_exponent_;
    const WideDouble d = ldexp(back ? cubic.e : cubic.d, exponent);
    const WideDouble a = ldexp(back ? WideDouble(-cubic.a) : cubic.a, exponent);
    top.p_phi_minus_p_psi_ = (given.A * d).rounded();
    top.invariants_.p_phi_kg_m2_s = (given.A * (d + a)).rounded();
    top.invariants_.p_psi_kg_m2_s = (given.C * given.omega3).rounded();
    const WideDouble x0 = back ? cubic.y0 : cubic.x0;
    const WideDouble transverse = square(given.omega1) + square(given.omega2);
    top.invariants_.energy_J =
        ((given.A * transverse + given.C * square(given.omega3)) / 2 + given.mgl * (1 - x0))
            .rounded();

    // φ+ψ and φ−ψ at the start.
    const double alpha = (2 * atan2(given.qz, given.qw)).rounded();
    const double beta = (2 * atan2(given.qy, given.qx)).rounded();
    top.angle_start_[0] = given.qw == 0 && given.qz == 0 ? 0.0 : alpha;
    top.angle_start_[1] = given.qx == 0 && given.qy == 0 ? 0.0 : beta;

    top.given_angles_ = {angle_of(x0, back ? cubic.x0 : cubic.y0),
                         0.5 * (top.angle_start_[0] + top.angle_start_[1]),
                         0.5 * (top.angle_start_[0] - top.angle_start_[1])};

    fill_nutation();
    top.regime_ = regime_of(cubic);
}

void TopSetup::fill_nutation() {
    const bool back = top.series_.reversed;
    TopNutation& nutation = top.nutation_;
    const auto seconds = [this](const WideDouble& duration) {
        return ldexp(duration, -top.rate_exponent_).rounded();
    };
    nutation.theta_min_rad = back ? angle_of(cubic.y1, cubic.x1) : angle_of(cubic.x2, cubic.y2);
    nutation.theta_max_rad = back ? angle_of(cubic.y2, cubic.x2) : angle_of(cubic.x1, cubic.y1);
    if (cubic.steady) {
        // Small nutation about steady motion: x'' = 2 P2 (x − x0) to first order.
        const WideDouble stiffness = -cubic.p2;
        const bool moves = cubic.x0 > 0 && cubic.y0 > 0 && stiffness > 0;
        nutation.period_s = moves ? seconds(2 * pi / sqrt(stiffness)) : 0.0;
    } else {
        nutation.period_s =
            quarter == 0 ? std::numeric_limits<double>::infinity() : seconds(2 * quarter / lambda);
    }
    nutation.precession_rate_rad_s =
        ldexp((angle_rate[0] + angle_rate[1]) / 2, top.rate_exponent_).rounded();
}

}  // namespace poinsot
