// The preprocessing of the discrete Moser–Veselov algorithm, as truncated series in h².
//
// Hairer & Vilmart (2006) print s and d as polynomials in T, L² and the moments. The same numbers
// follow here from the two conditions that define them, on the step that straddles the plane L2 = 0
// of the middle axis symmetrically, which every polhode crosses: the step must take the time h that
// the true motion needs from one side to the other, and turn the middle axis about L as far. Both
// hold order by order. Formal identities in the invariants hold for every other step, too.
//
// In this file 1, 2 are the axes of the lowest and highest moment, 3 the middle one; |L| = 1, and h
// stands for h|L|/tr(I).
#include "mechanics/stepped/moser_veselov_series.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "numerics/power_of_two.h"

namespace poinsot {

namespace {

double beta(double a, double b) {
#ifdef __cpp_lib_math_special_functions
    return std::beta(a, b);
#else  // libc++
    return std::exp(std::lgamma(a) + std::lgamma(b) - std::lgamma(a + b));
#endif
}

constexpr std::size_t n_coefficients = 5;

// c[0] + c[1] h² + … + c[4] h⁸.
struct Series {
    std::array<double, n_coefficients> c{};

    Series() = default;
    Series(double constant) { c[0] = constant; }  // NOLINT(google-explicit-constructor)
};

Series operator+(const Series& a, const Series& b) {
    Series sum;
    for (std::size_t i = 0; i < n_coefficients; ++i) sum.c[i] = a.c[i] + b.c[i];
    return sum;
}

Series operator*(const Series& a, const Series& b) {
    Series product;
    for (std::size_t i = 0; i < n_coefficients; ++i) {
        for (std::size_t j = 0; i + j < n_coefficients; ++j) product.c[i + j] += a.c[i] * b.c[j];
    }
    return product;
}

Series operator-(const Series& a, const Series& b) { return a + b * -1.0; }

Series operator/(const Series& a, const Series& b) {
    Series quotient;
    for (std::size_t i = 0; i < n_coefficients; ++i) {
        double rest = a.c[i];
        for (std::size_t j = 0; j < i; ++j) rest -= quotient.c[j] * b.c[i - j];
        quotient.c[i] = rest / b.c[0];
    }
    return quotient;
}

// h² a.
Series raised(const Series& a) {
    Series result;
    for (std::size_t i = 1; i < n_coefficients; ++i) result.c[i] = a.c[i - 1];
    return result;
}

// The motion in the variables of this file.
struct Polhode {
    double inverse1, inverse2, inverse3;  // 1/I
    double spread;                        // 1/I1 − 1/I2
    double share1, share2;                // of −d(L3²) that goes to L1² and L2²
    double crossing1, crossing2;          // L1² and L2² at L3 = 0
    double twice_energy;
};

struct Residual {
    Series time;
    Series angle;
};

// The errors in time and angle of a step with these s and d.
Residual residual_of(const Polhode& p, const Series& s, const Series& d) {
    const Series scale = Series(1.0) + s;
    const Series g1 = scale * p.inverse1 + d;  // 1/Ĩ
    const Series g2 = scale * p.inverse2 + d;
    const Series spread2 = (scale * p.spread) * (scale * p.spread);

    // e = h √X/Ĩ: the step's quaternion has no third component. Each pass determines one more
    // order.
    Series X1 = p.crossing1 / 4.0;
    Series X2 = p.crossing2 / 4.0;
    Series e0_squared;
    for (std::size_t pass = 0; pass < n_coefficients; ++pass) {
        e0_squared = Series(1.0) - raised(X1 * g1 * g1 + X2 * g2 * g2);
        const Series end = raised(X1 * X2 * spread2);  // L3²/4 at the ends of the step
        X1 = (Series(p.crossing1 / 4.0) - end * p.share1) / e0_squared;
        X2 = (Series(p.crossing2 / 4.0) - end * p.share2) / e0_squared;
    }
    const Series end_squared = raised(X1 * X2 * spread2) * 4.0;  // L3²

    // L1² and L2² along the step are their ends' values times 1 + b (1 − z²), z = L3/L3(end); the
    // time and the angle are integrals over z of their inverse roots, binomial series in b.
    const Series b1 = raised(X2 * spread2) * p.share1 / e0_squared;
    const Series b2 = raised(X1 * spread2) * p.share2 / e0_squared;
    constexpr std::array<double, n_coefficients> binomial{1.0, -1.0 / 2, 3.0 / 8, -5.0 / 16,
                                                          35.0 / 128};
    std::array<Series, n_coefficients> root;  // coefficients of (1 − z²)^n
    Series power1 = 1.0;
    for (std::size_t i = 0; i < n_coefficients; ++i) {
        Series power2 = 1.0;
        for (std::size_t j = 0; i + j < n_coefficients; ++j) {
            root[i + j] = root[i + j] + power1 * power2 * (binomial[i] * binomial[j]);
            power2 = power2 * b2;
        }
        power1 = power1 * b1;
    }
    Series time;
    Series weighted;  // by 1/(1 − L3²)
    for (std::size_t n = 0; n < n_coefficients; ++n) {
        Series power = 1.0;
        for (std::size_t j = 0; j < n_coefficients; ++j) {
            const double moment =
                0.5 * beta(static_cast<double>(j) + 0.5, static_cast<double>(n) + 1.0);
            if (j == 0) time = time + root[n] * moment;
            weighted = weighted + root[n] * power * moment;
            power = power * end_squared;
        }
    }

    // The middle axis turns about L at 1/I3 + (2T − 1/I3)/(1 − L3²).
    const Series rate = Series(p.inverse3) + weighted / time * (p.twice_energy - p.inverse3);
    const Series y = rate * rate;
    // sin²(angle/2)/h² of the true motion and of the step.
    const Series wanted =
        y *
        (Series(1.0 / 4) +
         raised(y * (Series(-1.0 / 48) + raised(y * (Series(1.0 / 1440) +
                                                     raised(y * (Series(-1.0 / 80640) +
                                                                 raised(y * (1.0 / 7257600)))))))));
    const Series got =
        (X1 * g1 * g1 + X2 * g2 * g2 - X1 * X2 * spread2 * 4.0) / (Series(1.0) - end_squared);
    return {e0_squared - scale * time, got - wanted};
}

Polhode polhode_of(const Eigen::Vector3d& moments, const Eigen::Vector3d& momentum) {
    std::array<int, 3> axis{0, 1, 2};
    std::sort(axis.begin(), axis.end(), [&](int i, int j) { return moments[i] < moments[j]; });
    const double unit = moments.sum();
    const Eigen::Vector3d direction = momentum.stableNormalized();
    const auto square = [&](int i) { return direction[axis[i]] * direction[axis[i]]; };
    Polhode p{};
    p.inverse1 = unit / moments[axis[0]];
    p.inverse3 = unit / moments[axis[1]];
    p.inverse2 = unit / moments[axis[2]];
    p.spread = p.inverse1 - p.inverse2;
    // For a sphere every share is correct.
    p.share1 = p.spread > 0.0 ? (p.inverse3 - p.inverse2) / p.spread : 0.5;
    p.share2 = 1.0 - p.share1;
    p.crossing1 = square(0) + p.share1 * square(1);
    p.crossing2 = square(2) + p.share2 * square(1);
    p.twice_energy = square(0) * p.inverse1 + square(2) * p.inverse2 + square(1) * p.inverse3;
    return p;
}

}  // namespace

MoserVeselovSeries moser_veselov_series(const Eigen::Vector3d& moments,
                                        const Eigen::Vector3d& momentum) {
    MoserVeselovSeries result;
    const double norm = norm_of(momentum);
    if (!(norm > 0.0)) return result;
    const Polhode polhode = polhode_of(moments, momentum);
    const double rate = norm / moments.sum();
    Series s;
    Series d;
    double power = 1.0;
    for (std::size_t k = 1; k < n_coefficients; ++k) {
        // The coefficients of order k enter the residuals of order k linearly.
        const Residual base = residual_of(polhode, s, d);
        Series s_tried = s;
        s_tried.c[k] = 1.0;
        const Residual by_s = residual_of(polhode, s_tried, d);
        Series d_tried = d;
        d_tried.c[k] = 1.0;
        const Residual by_d = residual_of(polhode, s, d_tried);
        const double ts = by_s.time.c[k] - base.time.c[k];
        const double td = by_d.time.c[k] - base.time.c[k];
        const double as = by_s.angle.c[k] - base.angle.c[k];
        const double ad = by_d.angle.c[k] - base.angle.c[k];
        const double determinant = ts * ad - td * as;
        s.c[k] = (td * base.angle.c[k] - ad * base.time.c[k]) / determinant;
        d.c[k] = (as * base.time.c[k] - ts * base.angle.c[k]) / determinant;
        power *= rate * rate;
        result.s[k - 1] = s.c[k] * power;
        result.d[k - 1] = d.c[k] * power / moments.sum();
    }
    return result;
}

}  // namespace poinsot
