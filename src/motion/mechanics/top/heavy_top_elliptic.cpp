#include "mechanics/top/heavy_top_elliptic.h"

#include "numerics/wide_functions.h"

namespace poinsot::top_setup {

namespace {

// Half the sum of theta-like terms; q^{n(n+1)} or q^{n²} falls below 2^-106 within these.
constexpr int n_sum = 9;

}  // namespace

Modulus::Modulus(const Cubic& c) {
    const WideDouble top = c.beta * c.x1 + c.G;
    const WideDouble k2 = c.beta * c.delta / top;
    const WideDouble k_prime2 = (c.X + c.G) / top;
    k_prime = sqrt(k_prime2);
    if (k_prime2 > 0) K = complete_first_kind(k_prime);
    if (k2 > 0) K_prime = complete_first_kind(sqrt(k2));
    hyperbolic = k_prime2 < 0.5;
    if (K != 0 && K_prime != 0) {
        nome = exp(hyperbolic ? WideDouble(-pi * K / K_prime) : WideDouble(-pi * K_prime / K));
    }
}

WideDouble Modulus::argument_per_u() const { return pi / (2 * (hyperbolic ? K_prime : K)); }

WideDouble fill_series(const Modulus& m, const WideDouble& v, int sign, TopFactor& f) {
    f.winding = sign;
    const WideDouble shift = v * m.argument_per_u();
    if (!m.hyperbolic) {
        // θ1(z − i s η) and θ2(z − i s η), divided by θ2(i η).
        WideDouble cosh_terms[n_sum];
        WideDouble sinh_terms[n_sum];
        WideDouble sum = 0;
        WideDouble slope = 0;
        for (int n = 0; n < n_sum; ++n) {
            const WideDouble weight = power(m.nome, n * (n + 1));
            const auto [sinh, cosh] = sinh_cosh((2 * n + 1) * shift);
            cosh_terms[n] = weight * cosh;
            sinh_terms[n] = weight * sinh;
            sum = sum + cosh_terms[n];
            slope = slope + (2 * n + 1) * sinh_terms[n];
        }
        for (int n = 0; n < TopFactor::max_terms; ++n) {
            const int alternating = n % 2 == 0 ? 1 : -1;
            const auto index = static_cast<std::size_t>(n);
            f.theta1_re[index] = alternating * (sinh_terms[n] / sum).rounded();
            f.theta1_im[index] = alternating * sign * (cosh_terms[n] / sum).rounded();
            f.theta2_re[index] = (cosh_terms[n] / sum).rounded();
            f.theta2_im[index] = sign * (sinh_terms[n] / sum).rounded();
        }
        return sign * m.argument_per_u() * slope / sum;
    }

    // Jacobi's imaginary transformation: θ1 and θ4 of s χ + i Y in the complementary nome, and a
    // phase linear in u; divided by θ4(χ) θ2(0)/θ3(0) and by θ4(χ).
    const WideDouble& q = m.nome;
    const WideDouble cell_rate =
        m.K == 0 ? WideDouble(0) : WideDouble(sign * pi * v / (2 * m.K * m.K_prime));
    f.cell_rate = cell_rate.rounded();
    WideDouble theta4 = 1;
    WideDouble theta3 = 1;
    WideDouble theta2 = 1;  // without 2 q^{1/4}
    WideDouble slope = 0;
    for (int n = 1; n < n_sum; ++n) {
        const int alternating = n % 2 == 0 ? 1 : -1;
        const WideDouble weight = power(q, n * n);
        const WideSinCos turn = sin_cos(2 * n * shift);
        theta4 = theta4 + 2 * alternating * weight * turn.cos;
        theta3 = theta3 + 2 * weight;
        theta2 = theta2 + power(q, n * (n + 1));
        slope = slope - 4 * n * alternating * weight * turn.sin;
    }
    for (int n = 0; n < TopFactor::max_terms; ++n) {
        const int alternating = n % 2 == 0 ? 1 : -1;
        const auto index = static_cast<std::size_t>(n);
        const WideDouble odd = alternating * power(q, n * (n + 1)) * theta3 / (theta2 * theta4);
        const WideDouble even = n == 0 ? WideDouble(1 / theta4)
                                       : WideDouble(2 * alternating * power(q, n * n) / theta4);
        const WideSinCos odd_turn = sin_cos((2 * n + 1) * shift);
        const WideSinCos even_turn = sin_cos(2 * n * shift);
        f.theta1_re[index] = (odd * odd_turn.sin).rounded();
        f.theta1_im[index] = sign * (odd * odd_turn.cos).rounded();
        f.theta2_re[index] = (even * even_turn.cos).rounded();
        f.theta2_im[index] = -sign * (even * even_turn.sin).rounded();
    }
    return cell_rate + sign * m.argument_per_u() * slope / theta4;
}

std::pair<int, WideDouble> starting_phase(const Cubic& c, const Modulus& m) {
    const int sign = c.x_dot > 0 ? -1 : 1;
    const WideDouble sn2 = c.above / c.delta;
    const WideDouble cn2 = c.below / c.delta;
    const WideDouble dn2 = (c.beta * c.x0 + c.G) / (c.beta * c.x1 + c.G);
    // At u = K/2, cn² = k′ sn². Without gravity k′ and dn are 1 and tell nothing.
    if (cn2 >= m.k_prime * sn2) return {0, sign * sqrt(sn2) * carlson_rf(cn2, dn2, WideDouble(1))};
    const WideDouble k2_prime = square(m.k_prime);
    const WideDouble from_upper =
        sqrt(cn2 / dn2) *
        carlson_rf(WideDouble(k2_prime * sn2 / dn2), WideDouble(k2_prime / dn2), WideDouble(1));
    return {sign, -sign * from_upper};
}

}  // namespace poinsot::top_setup
