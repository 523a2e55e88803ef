// An independent answer for Lagrange's top: Taylor's method for Euler's equations.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "mechanics/heavy_top.h"

namespace poinsot::tops {

// How far a top's state is from (q, ω) in long double: the largest component of the quaternion's
// difference (q and −q alike) and of ω's, the latter relative to its norm if that exceeds one.
struct Difference {
    double attitude = 0.0;
    double omega = 0.0;
};

using Wide = long double;
using Quad = boost::multiprecision::cpp_bin_float_quad;

inline Difference difference(const RotationState& state, const std::array<Wide, 4>& q,
                             const std::array<Wide, 3>& omega) {
    const Eigen::Quaterniond& r = state.space_from_body;
    const double components[4] = {r.w(), r.x(), r.y(), r.z()};
    Wide same = 0;
    Wide opposite = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        same = std::max(same, std::abs(q[i] - components[i]));
        opposite = std::max(opposite, std::abs(q[i] + components[i]));
    }
    Wide worst = 0;
    Wide norm = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        worst = std::max(worst, std::abs(omega[i] - state.omega_body[static_cast<int>(i)]));
        norm = std::max(norm, std::abs(omega[i]));
    }
    return {static_cast<double>(std::min(same, opposite)), static_cast<double>(worst / norm)};
}

// Taylor's method for Euler's equations of the top: an independent answer, regular through the
// vertical, with an error of about the arithmetic's. Long double serves where the motion does not
// amplify its 1e-19; 113 bits where it does.
template <typename Real>
class TaylorTop {
 public:
    explicit TaylorTop(const HeavyTopProblem& p)
        : omega3_(p.omega3_rad_s),
          spin_coupling_((Real(p.moment_transverse_kg_m2) - p.moment_axial_kg_m2) * omega3_ /
                         p.moment_transverse_kg_m2),
          gravity_(Real(p.mgl_N_m) / p.moment_transverse_kg_m2) {
        using std::cos;
        using std::sin;
        const Real half = Real(p.theta_rad) / 2;
        const Real c = cos(half);
        const Real s = sin(half);
        state_ = {Real(p.theta_dot_rad_s),
                  Real(p.phi_dot_rad_s * 2 * s * c),
                  Real(0),
                  Real(2 * s * c),
                  Real((c - s) * (c + s)),
                  c,
                  s,
                  Real(0),
                  Real(0)};
    }

    void advance(double duration) {
        const double p = static_cast<double>(state_[0]);
        const double q = static_cast<double>(state_[1]);
        const double rate = std::hypot(p, q) + std::abs(static_cast<double>(omega3_)) +
                            std::abs(static_cast<double>(spin_coupling_)) +
                            2 * std::sqrt(std::abs(static_cast<double>(gravity_))) + 1e-3;
        const auto n_steps = static_cast<int>(std::ceil(std::abs(duration) * rate / 0.5));
        for (int step = 0; step < n_steps; ++step) advance_once(Real(duration) / n_steps);
    }

    std::array<Wide, 4> quaternion() const {
        return {static_cast<Wide>(state_[5]), static_cast<Wide>(state_[6]),
                static_cast<Wide>(state_[7]), static_cast<Wide>(state_[8])};
    }
    std::array<Wide, 3> omega() const {
        return {static_cast<Wide>(state_[0]), static_cast<Wide>(state_[1]),
                static_cast<Wide>(omega3_)};
    }

 private:
    static constexpr int order = std::numeric_limits<Real>::digits > 100 ? 42 : 28;
    using Series = std::array<Real, order + 1>;

    static Real product(const Series& a, const Series& b, int n) {
        Real sum = 0;
        for (int k = 0; k <= n; ++k) sum += a[k] * b[n - k];
        return sum;
    }

    void advance_once(const Real& h) {
        std::array<Series, 9> s{};
        for (std::size_t i = 0; i < 9; ++i) s[i][0] = state_[i];
        auto& [p, q, v1, v2, v3, w, x, y, z] = s;
        const Real& r = omega3_;
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

    Real omega3_, spin_coupling_, gravity_;
    std::array<Real, 9> state_{};  // ω1, ω2, vertical in body axes, quaternion (w, x, y, z)
};

}  // namespace poinsot::tops
