// An independent reference for Lagrange's top: Taylor's method for Euler's equations.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "mechanics/top/heavy_top.h"
#include "numerics/double_double.h"

namespace poinsot::tops {

// √(|Mgl|/A): the rate at which gravity turns the body.
inline double gravity_rate(const HeavyTopProblem& p) {
    using std::sqrt;
    return static_cast<double>(sqrt(boost::multiprecision::cpp_bin_float_quad(std::abs(p.mgl_N_m)) /
                                    p.moment_transverse_kg_m2));
}

// The difference of a top's state from (q, ω) in long double: the largest component of the
// quaternion's difference (q and −q are equal) and of ω's, the latter relative to the larger of |ω|
// and √(|Mgl|/A).
struct Difference {
    double attitude = 0.0;
    double omega = 0.0;
};

using Wide = long double;
using Quad = boost::multiprecision::cpp_bin_float_quad;

inline Difference difference(const HeavyTopProblem& p, const RotationState& state,
                             const std::array<Wide, 4>& q, const std::array<Wide, 3>& omega) {
    const Eigen::Quaterniond& r = state.space_from_body;
    const double components[4] = {r.w(), r.x(), r.y(), r.z()};
    Wide same = 0;
    Wide opposite = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        same = std::max(same, std::abs(q[i] - components[i]));
        opposite = std::max(opposite, std::abs(q[i] + components[i]));
    }
    Wide worst = 0;
    Wide square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        worst = std::max(worst, std::abs(omega[i] - state.omega_body[static_cast<int>(i)]));
        square += omega[i] * omega[i];
    }
    const Wide norm = std::max(Wide(gravity_rate(p)), std::sqrt(square));
    return {static_cast<double>(std::min(same, opposite)),
            worst > 0 ? static_cast<double>(worst / norm) : 0.0};
}

// Arithmetic for a number type: conversions from 113 bits and to double, and the convolutions.
template <typename Real>
struct Arithmetic {
    static constexpr int order = std::numeric_limits<Real>::digits > 100 ? 42 : 28;
    static Real from(const Quad& x) { return static_cast<Real>(x); }
    static Wide wide(const Real& x) { return static_cast<Wide>(x); }
    // Σ a_k b_{n−k}, k = 0 … n.
    static Real convolution(const Real* a, const Real* b, int n) {
        Real sum = 0;
        for (int k = 0; k <= n; ++k) sum += a[k] * b[n - k];
        return sum;
    }
};

// DoubleDouble takes a twentieth of the time of 113 bits in software.
template <>
struct Arithmetic<DoubleDouble> {
    static constexpr int order = 42;
    static DoubleDouble from(const Quad& x) {
        const auto hi = static_cast<double>(x);
        return {hi, static_cast<double>(x - hi)};
    }
    static Wide wide(DoubleDouble x) { return Wide(x.hi) + Wide(x.lo); }
    // The dot product of Ogita, Rump & Oishi, SIAM J. Sci. Comput. 26 (2005) 1955, including the
    // products of the second words: accurate to 1e-31 of the sum of the terms' magnitudes.
    static DoubleDouble convolution(const DoubleDouble* a, const DoubleDouble* b, int n) {
        DoubleDouble sum;
        for (int k = 0; k <= n; ++k) {
            const DoubleDouble x = a[k];
            const DoubleDouble y = b[n - k];
            const DoubleDouble term = two_product(x.hi, y.hi);
            const DoubleDouble grown = two_sum(sum.hi, term.hi);
            sum = {grown.hi, sum.lo + (grown.lo + (term.lo + (x.hi * y.lo + x.lo * y.hi)))};
        }
        return fast_two_sum(sum.hi, sum.lo);
    }
};

// Taylor's method for Euler's equations of the top: an independent reference, regular through the
// vertical, with an error near that of the arithmetic. Long double is used where the motion does
// not amplify its error of 1e-19, DoubleDouble's 106 bits where it does, and Quad's 113 bits to
// check DoubleDouble. The unit of time is 2^−n s near the fastest turn, so that no coefficient
// over- or underflows.
template <typename Real>
class TaylorTop {
 public:
    explicit TaylorTop(const HeavyTopProblem& p) : exponent_(exponent_of(p)) {
        const Quad unit = ldexp(Quad(1), exponent_);
        const Quad omega3 = p.omega3_rad_s / unit;
        omega3_ = Numbers::from(omega3);
        spin_coupling_ = Numbers::from((Quad(p.moment_transverse_kg_m2) - p.moment_axial_kg_m2) *
                                       omega3 / p.moment_transverse_kg_m2);
        gravity_ = Numbers::from(Quad(p.mgl_N_m) / p.moment_transverse_kg_m2 / (unit * unit));
        const Quad half = Quad(p.theta_rad) / 2;
        const Quad c = cos(half);
        const Quad s = sin(half);
        const std::array<Quad, 9> start{p.theta_dot_rad_s / unit,
                                        p.phi_dot_rad_s / unit * 2 * s * c,
                                        0,
                                        2 * s * c,
                                        (c - s) * (c + s),
                                        c,
                                        s,
                                        0,
                                        0};
        for (std::size_t i = 0; i < 9; ++i) state_[i] = Numbers::from(start[i]);
    }

    void advance(double duration_s) {
        const double duration = std::ldexp(duration_s, exponent_);
        const auto size = [](const Real& x) {
            return std::abs(static_cast<double>(Numbers::wide(x)));
        };
        const double rate = std::hypot(size(state_[0]), size(state_[1])) + size(omega3_) +
                            size(spin_coupling_) + 2 * std::sqrt(size(gravity_)) + 1e-3;
        const auto n_steps = static_cast<int>(std::ceil(std::abs(duration) * rate / 0.5));
        for (int step = 0; step < n_steps; ++step) advance_once(Real(duration) / n_steps);
    }

    std::array<Wide, 4> quaternion() const {
        return {Numbers::wide(state_[5]), Numbers::wide(state_[6]), Numbers::wide(state_[7]),
                Numbers::wide(state_[8])};
    }
    std::array<Wide, 3> omega() const {
        const auto per_second = [this](const Real& x) {
            return std::ldexp(Numbers::wide(x), exponent_);
        };
        return {per_second(state_[0]), per_second(state_[1]), per_second(omega3_)};
    }

    // Of the fastest of ω and √(|Mgl|/A).
    static int exponent_of(const HeavyTopProblem& p) {
        const double fastest = std::max({std::abs(p.theta_dot_rad_s), std::abs(p.phi_dot_rad_s),
                                         std::abs(p.omega3_rad_s), gravity_rate(p)});
        return fastest > 0.0 ? std::ilogb(fastest) : 0;
    }

 private:
    using Numbers = Arithmetic<Real>;
    static constexpr int order = Numbers::order;
    using Series = std::array<Real, order + 1>;

    static Real product(const Series& a, const Series& b, int n) {
        return Numbers::convolution(a.data(), b.data(), n);
    }

    void advance_once(const Real& h) {
        std::array<Series, 9> s{};
        for (std::size_t i = 0; i < 9; ++i) s[i][0] = state_[i];
        auto& [p, q, v1, v2, v3, w, x, y, z] = s;
        const Real r = omega3_;
        for (int n = 0; n < order; ++n) {
            const Real next = n + 1;
            p[n + 1] = (spin_coupling_ * q[n] + gravity_ * v2[n]) / next;
            q[n + 1] = (-spin_coupling_ * p[n] - gravity_ * v1[n]) / next;
            v1[n + 1] = (r * v2[n] - product(v3, q, n)) / next;
            v2[n + 1] = (product(v3, p, n) - r * v1[n]) / next;
            v3[n + 1] = (product(v1, q, n) - product(v2, p, n)) / next;
            w[n + 1] = -(product(x, p, n) + product(y, q, n) + r * z[n]) / (2 * next);
            x[n + 1] = (product(w, p, n) - product(z, q, n) + r * y[n]) / (2 * next);
            y[n + 1] = (product(w, q, n) + product(z, p, n) - r * x[n]) / (2 * next);
            z[n + 1] = (r * w[n] + product(x, q, n) - product(y, p, n)) / (2 * next);
        }
        for (std::size_t i = 0; i < 9; ++i) {
            Real sum = 0;
            for (int n = order; n >= 0; --n) sum = sum * h + s[i][n];
            state_[i] = sum;
        }
    }

    int exponent_;
    Real omega3_, spin_coupling_, gravity_;
    std::array<Real, 9> state_{};  // ω1, ω2, vertical in body axes, quaternion (w, x, y, z)
};

}  // namespace poinsot::tops
