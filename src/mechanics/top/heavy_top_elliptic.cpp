#include "mechanics/top/heavy_top_elliptic.h"

#include <boost/math/special_functions/ellint_rf.hpp>
#include <limits>

namespace poinsot::top_setup {

namespace {

const Real epsilon = std::numeric_limits<Real>::epsilon();

Real agm(Real a, Real b) {
    while (abs(a - b) > 4 * epsilon * a) {
        const Real mean = (a + b) / 2;
        b = sqrt(a * b);
        a = mean;
    }
    return (a + b) / 2;
}

// Half the sum of theta-like terms; q^{n(n+1)} or q^{n²} falls below 2^-113 within these.
constexpr int n_sum = 9;

}  // namespace

Modulus::Modulus(const Cubic& c) {
    const Real top = c.beta * c.x1 + c.G;
    const Real k2 = c.beta * c.delta / top;
    const Real k_prime2 = (c.X + c.G) / top;
    k_prime = sqrt(k_prime2);
    if (k_prime2 > 0) K = pi / (2 * agm(1, k_prime));
    if (k2 > 0) K_prime = pi / (2 * agm(1, sqrt(k2)));
    hyperbolic = k_prime2 < 0.5;
    if (K != 0 && K_prime != 0) {
        nome = exp(hyperbolic ? Real(-pi * K / K_prime) : Real(-pi * K_prime / K));
    }
}

Real Modulus::argument_per_u() const { return pi / (2 * (hyperbolic ? K_prime : K)); }

Real fill_series(const Modulus& m, const Real& v, int sign, TopFactor& f) {
    f.winding = sign;
    const Real shift = v * m.argument_per_u();
    if (!m.hyperbolic) {
        // θ1(z − i s η) and θ2(z − i s η), divided by θ2(i η).
        Real cosh_terms[n_sum];
        Real sinh_terms[n_sum];
        Real sum = 0;
        Real slope = 0;
        for (int n = 0; n < n_sum; ++n) {
            const Real power = n == 0 ? Real(1) : Real(pow(m.nome, n * (n + 1)));
            cosh_terms[n] = power * cosh((2 * n + 1) * shift);
            sinh_terms[n] = power * sinh((2 * n + 1) * shift);
            sum += cosh_terms[n];
            slope += (2 * n + 1) * sinh_terms[n];
        }
        for (int n = 0; n < TopFactor::max_terms; ++n) {
            const int alternating = n % 2 == 0 ? 1 : -1;
            const auto index = static_cast<std::size_t>(n);
            f.theta1_re[index] = alternating * to_double(sinh_terms[n] / sum);
            f.theta1_im[index] = alternating * sign * to_double(cosh_terms[n] / sum);
            f.theta2_re[index] = to_double(cosh_terms[n] / sum);
            f.theta2_im[index] = sign * to_double(sinh_terms[n] / sum);
        }
        return sign * m.argument_per_u() * slope / sum;
    }

    // Jacobi's imaginary transformation: θ1 and θ4 of s χ + i Y in the complementary nome, and a
    // phase linear in u; divided by θ4(χ) θ2(0)/θ3(0) and by θ4(χ).
    const Real& q = m.nome;
    const Real cell_rate = m.K == 0 ? Real(0) : Real(sign * pi * v / (2 * m.K * m.K_prime));
    f.cell_rate = to_double(cell_rate);
    Real theta4 = 1;
    Real theta3 = 1;
    Real theta2 = 1;  // without 2 q^{1/4}
    Real slope = 0;
    for (int n = 1; n < n_sum; ++n) {
        const int alternating = n % 2 == 0 ? 1 : -1;
        const Real power = pow(q, n * n);
        theta4 += 2 * alternating * power * cos(2 * n * shift);
        theta3 += 2 * power;
        theta2 += pow(q, n * (n + 1));
        slope -= 4 * n * alternating * power * sin(2 * n * shift);
    }
    for (int n = 0; n < TopFactor::max_terms; ++n) {
        const int alternating = n % 2 == 0 ? 1 : -1;
        const auto index = static_cast<std::size_t>(n);
        const Real odd = alternating * (n == 0 ? Real(1) : Real(pow(q, n * (n + 1)))) * theta3 /
                         (theta2 * theta4);
        const Real even =
            n == 0 ? Real(1 / theta4) : Real(2 * alternating * pow(q, n * n) / theta4);
        f.theta1_re[index] = to_double(odd * sin((2 * n + 1) * shift));
        f.theta1_im[index] = sign * to_double(odd * cos((2 * n + 1) * shift));
        f.theta2_re[index] = to_double(even * cos(2 * n * shift));
        f.theta2_im[index] = -sign * to_double(even * sin(2 * n * shift));
    }
    return cell_rate + sign * m.argument_per_u() * slope / theta4;
}

std::pair<int, Real> starting_phase(const Cubic& c, const Modulus& m) {
    using boost::math::ellint_rf;
    const int sign = c.x_dot > 0 ? -1 : 1;
    const Real sn2 = c.above / c.delta;
    const Real cn2 = c.below / c.delta;
    const Real dn2 = (c.beta * c.x0 + c.G) / (c.beta * c.x1 + c.G);
    if (dn2 >= m.k_prime) return {0, sign * sqrt(sn2) * ellint_rf(cn2, dn2, Real(1))};
    const Real k2_prime = square(m.k_prime);
    const Real from_upper =
        sqrt(cn2 / dn2) * ellint_rf(Real(k2_prime * sn2 / dn2), Real(k2_prime / dn2), Real(1));
    return {sign, -sign * from_upper};
}

}  // namespace poinsot::top_setup
