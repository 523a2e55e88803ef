#include "mechanics/free_rotation.h"

#include <algorithm>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "error/error.h"

namespace poinsot {

namespace {

using Real = long double;
using Quaternion = std::array<Real, 4>;
constexpr Real pi = std::numbers::pi_v<Real>;

Quaternion multiply(const Quaternion& p, const Quaternion& q) {
    return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
            p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
            p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
            p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}

Real complete_first_kind(Real k_complement) {
    Real a = 1;
    Real g = k_complement;
    for (int i = 0; i < 60 && std::abs(a - g) > 1e-19L * a; ++i) {
        const Real mean = (a + g) / 2;
        g = std::sqrt(a * g);
        a = mean;
    }
    return pi / (2 * a);
}

}  // namespace

struct FreeRotation::Frame {
    std::array<Real, 3> m;
    Quaternion rotation;
};

FreeRotation::FreeRotation(const InertiaTensor& inertia, const RotationState& start)
    : inertia_(inertia), start_(start) {
    const Eigen::Matrix3d& axes = inertia.body_from_principal();
    const Eigen::Vector3d w = axes.transpose() * start.omega_body;
    if (!w.allFinite()) throw InputError("omega_rad_s: the angular velocity is to be finite");
    start_.space_from_body.normalize();
    const Eigen::Vector3d& I = inertia.moments_kg_m2();
    const Eigen::Vector3d L_body = I.cwiseProduct(w);
    if (!L_body.allFinite()) throw InputError("angular momentum overflows; choose other units");
    L_ = std::sqrt(static_cast<Real>(L_body.squaredNorm()));
    constants_.kinetic_energy_J = 0.5 * w.dot(L_body);
    constants_.momentum_kg_m2_s = L_body.norm();
    constants_.momentum_space = start_.space_from_body * (axes * L_body);
    if (w.isZero(0.0)) return;

    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int i, int j) { return I[i] < I[j]; });
    const auto [l, m, h] = order;
    const auto steady = [&](int i, int j) { return I[i] == I[j] || w[i] == 0 || w[j] == 0; };
    const auto delta = [&](int i) {
        Real sum = 0;
        for (int j = 0; j < 3; ++j) {
            sum += static_cast<Real>(I[j]) * w[j] * w[j] * (static_cast<Real>(I[j]) - I[i]);
        }
        return sum;
    };
    const Real D = static_cast<Real>(I[h]) * w[h] * w[h] * (static_cast<Real>(I[h]) - I[m]) -
                   static_cast<Real>(I[l]) * w[l] * w[l] * (static_cast<Real>(I[m]) - I[l]);
    const int a = D >= 0 ? h : l;
    const int c = D >= 0 ? l : h;
    axis_ = {a, m, c};
    constants_.encircled_axis = a;
    if (steady(0, 1) && steady(1, 2) && steady(0, 2)) {
        regime_ = Regime::permanent;
        return;
    }
    s_ = a == l ? 1 : -1;
    const Real Ia = I[a];
    const Real Ib = I[m];
    const Real Ic = I[c];
    moments_ = {Ia, Ib, Ic};
    delta_ = {delta(a), D, delta(c)};
    amplitude_ = {std::sqrt(Ia * delta_[2] / (Ia - Ic)), std::sqrt(Ib * delta_[0] / (Ib - Ia)),
                  s_ * std::sqrt(Ic * delta_[0] / (Ic - Ia))};
    const Real k2 = delta_[0] * (Ib - Ic) / (delta_[2] * (Ib - Ia));
    const Real kp = std::sqrt(D * (Ia - Ic) / (delta_[2] * (Ia - Ib)));
    lambda_ = std::sqrt(std::abs(delta_[2] * (Ia - Ib) / (Ia * Ib * Ic)));
    sign_[0] = w[a] >= 0 ? 1 : -1;
    sign_[2] = s_ * w[c] >= 0 ? 1 : -1;
    sign_[1] = ((m - a + 3) % 3 == 1 ? 1 : -1) * sign_[0] * sign_[2];
    const Real sn = sign_[1] * L_body[m] / amplitude_[1];
    const Real cn = sign_[2] * L_body[c] / amplitude_[2];
    const Real dn = sign_[0] * L_body[a] / amplitude_[0];
    u0_ = sn * boost::math::ellint_rf(cn * cn, dn * dn, Real(1));
    Kp_ = complete_first_kind(std::sqrt(k2));
    const Real tangent = std::sqrt(Ic * std::abs(Ib - Ia) / (Ia * std::abs(Ic - Ib)));
    const Real phi = std::atan(tangent);
    F_ = Ib == Ic
             ? 0
             : std::sin(phi) * boost::math::ellint_rf(std::cos(phi) * std::cos(phi),
                                                      1 - std::pow(kp * std::sin(phi), 2), Real(1));
    if (D == 0) {
        K_ = 0;
        regime_ = Regime::separatrix;
        mean_rate_ = 2 * constants_.kinetic_energy_J / L_;
        constants_.complementary_modulus = 0.0;
    } else {
        K_ = complete_first_kind(kp);
        regime_ = Ib == Ic ? Regime::symmetric
                  : a == l ? Regime::elliptic_about_lowest
                           : Regime::elliptic_about_highest;
        const Real p = Ib * (Ic - Ia) / (Ic * (Ib - Ia));
        // ∫du/(cn²+p sn²) and ∫sn²du/(cn²+p sn²) over a quarter period, by Carlson's R_F and R_J.
        const Real J = boost::math::ellint_rj(Real(0), kp * kp, Real(1), p) / 3;
        const Real Pi = K_ - (p - 1) * J;
        mean_rate_ =
            L_ / Ic * Pi / K_ + L_ * (Ic - Ib) / (Ic * (Ib - Ia)) * J / K_ +
            s_ * amplitude_[0] / Ia * std::sqrt((Ib - Ia) / Ib * ((Ic - Ia) / Ic)) * pi / (2 * K_);
        constants_.polhode_period_s = static_cast<double>(4 * K_ / lambda_);
        constants_.complementary_modulus = static_cast<double>(kp);
        const Real rate = mean_rate_ - s_ * pi * lambda_ / (2 * K_);
        constants_.mean_advance_rate_rad_s = static_cast<double>(rate);
        constants_.advance_per_period_rad = static_cast<double>(rate * 4 * K_ / lambda_);
    }
    constants_.modulus = static_cast<double>(std::sqrt(k2));
    const Frame first = frame(0);
    frame_from_start_ = {first.rotation[0], -first.rotation[1], -first.rotation[2],
                         -first.rotation[3]};
}

FreeRotation::Frame FreeRotation::frame(Real t) const {
    const Real u = lambda_ * t + u0_;
    const Real cycles = K_ > 0 ? u / (2 * K_) : 0;
    const Real n = std::nearbyint(cycles);
    const Real r = K_ > 0 ? cycles - n : 0;
    const bool odd = std::fmod(std::abs(n), Real(2)) == 1;
    if (constants_.complementary_modulus > 0.6) return trigonometric_frame(t, r, odd);
    const Real G = K_ > 0 ? pi * K_ / Kp_ : 0;
    const Real x = K_ > 0 ? r * G : u;
    const Real E = std::exp(-std::abs(x));
    const Real Q = K_ > 0 ? std::exp(-G / 2) : 0;
    const Real F = Q / E;
    const Real X = E * E;
    const Real Y = F * F;
    const Real q = Q * Q;
    const Real side = x < 0 ? -1 : 1;
    Real N1 = 0, N2 = 0, N3 = 1, N4 = 0, t2 = 0, t3 = 1, t4 = 1;
    std::complex<Real> S = 0;
    const Real chi = pi / 2 - pi * F_ / (4 * Kp_);
    for (int i = 0; i < 40; ++i) {
        const Real alternate = i % 2 == 0 ? 1 : -1;
        const Real qq = std::pow(q, static_cast<Real>(i * i));
        const Real yi = std::pow(Y, static_cast<Real>(i));
        N1 += alternate * qq * yi * (1 - std::pow(X, Real(2 * i + 1)));
        N2 += qq * yi * (1 + std::pow(X, Real(2 * i + 1)));
        N4 += alternate * qq * std::pow(X, Real(i)) * (1 - std::pow(Y, Real(2 * i + 1)));
        t2 += 2 * qq * std::pow(q, Real(i));
        const Real factor =
            alternate * std::pow(F, static_cast<Real>(i)) * std::pow(Q, static_cast<Real>(i * i));
        const Real e = std::pow(E, Real(2 * i + 1));
        S += factor * std::complex<Real>(std::sin((2 * i + 1) * chi) * (1 + e),
                                         -side * std::cos((2 * i + 1) * chi) * (1 - e));
        if (i > 0) {
            N3 += std::pow(q, Real(i * i - i)) * (yi + std::pow(q * X, Real(i)));
            t3 += 2 * qq;
            t4 += 2 * alternate * qq;
        }
    }
    const Real parity = odd ? -1 : 1;
    const std::array<Real, 3> m{amplitude_[0] * t2 / t3 * E * N3 / N2,
                                amplitude_[1] * parity * side * t3 / t4 * N1 / N2,
                                amplitude_[2] * parity * t2 / t4 * E * N4 / N2};
    const Real half =
        mean_rate_ * t / 2 - s_ * (pi * F_ / (2 * Kp_) * r + std::atan2(S.imag(), S.real()));
    const Real p0 = std::sqrt((1 + m[0] / L_) / 2);
    return {m, multiply({std::cos(half), std::sin(half), 0, 0},
                        {p0, 0, m[2] / L_ / (2 * p0), -m[1] / L_ / (2 * p0)})};
}

FreeRotation::Frame FreeRotation::trigonometric_frame(Real t, Real cycles, bool odd) const {
    const Real v = pi * cycles;
    const Real q = F_ > 0 || constants_.modulus > 0 ? std::exp(-pi * Kp_ / K_) : 0;
    Real t1 = 0, t2 = 0, t3 = 1, t4 = 1, c2 = 0, c3 = 1, c4 = 1;
    for (int i = 0; i < 12; ++i) {
        const Real alternate = i % 2 == 0 ? 1 : -1;
        const Real odd_power = std::pow(q, static_cast<Real>(i * (i + 1)));
        t1 += alternate * odd_power * std::sin((2 * i + 1) * v);
        t2 += odd_power * std::cos((2 * i + 1) * v);
        c2 += odd_power;
        if (i == 0) continue;
        const Real power = std::pow(q, static_cast<Real>(i * i));
        t3 += 2 * power * std::cos(2 * i * v);
        t4 += 2 * alternate * power * std::cos(2 * i * v);
        c3 += 2 * power;
        c4 += 2 * alternate * power;
    }
    const Real parity = odd ? -1 : 1;
    const std::array<Real, 3> m{amplitude_[0] * c4 / c3 * t3 / t4,
                                amplitude_[1] * parity * c3 / c2 * t1 / t4,
                                amplitude_[2] * parity * c4 / c2 * t2 / t4};
    const Real q4 = q * q * q * q;
    const Real rho = q > 0 ? std::exp(-pi * (2 * Kp_ - F_) / K_) : 0;
    const Real rho2 = q > 0 ? q4 / rho : 0;
    const std::complex<Real> z(std::cos(2 * v), std::sin(2 * v));
    const std::complex<Real> theta = Real(1) - rho * z - rho2 * std::conj(z) +
                                     q4 * (rho * rho * z * z + std::conj(rho2 * rho2 * z * z)) -
                                     q4 * q4 * q4 * rho * rho * rho * z * z * z;
    const Real half = mean_rate_ * t / 2 - s_ * std::atan2(theta.imag(), theta.real());
    const Real p0 = std::sqrt((1 + m[0] / L_) / 2);
    return {m, multiply({std::cos(half), std::sin(half), 0, 0},
                        {p0, 0, m[2] / L_ / (2 * p0), -m[1] / L_ / (2 * p0)})};
}

RotationState FreeRotation::at(double time_s) const {
    return sample(time_s, {.attitude = true}).state;
}

MotionSample FreeRotation::sample(double time_s, Quantities wanted) const {
    MotionSample out;
    out.state = start_;
    out.state.time_s = time_s;
    const double t = time_s - start_.time_s;
    if (!std::isfinite(t)) throw InputError("time_s: the instant is to be finite");
    const Eigen::Matrix3d& axes = inertia_.body_from_principal();
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d herpolhode = Eigen::Vector3d::Zero();
    if (regime_ == Regime::permanent) {
        const double rate = start_.omega_body.norm();
        const Eigen::Vector3d along = start_.omega_body / rate;
        rotation.w() = std::cos(0.5 * rate * t);
        rotation.vec() = std::sin(0.5 * rate * t) * along;
    } else if (regime_ != Regime::at_rest) {
        const Frame now = frame(t);
        const Quaternion q = multiply(frame_from_start_, now.rotation);
        Eigen::Vector3d omega;
        Eigen::Vector3d turn;
        for (int i = 0; i < 3; ++i) {
            omega[axis_[i]] = static_cast<double>(sign_[i] * now.m[i] / moments_[i]);
            turn[axis_[i]] = static_cast<double>(sign_[i] * q[i + 1]);
            herpolhode[axis_[i]] =
                static_cast<double>(sign_[i] * now.m[i] / moments_[i] * delta_[i] / (L_ * L_));
        }
        rotation.w() = static_cast<double>(q[0]);
        rotation.vec() = axes * turn;
        out.state.omega_body = axes * omega;
    }
    out.state.space_from_body = start_.space_from_body * rotation;
    if (wanted.herpolhode) out.herpolhode_space = out.state.space_from_body * (axes * herpolhode);
    if (!wanted.attitude) out.state.space_from_body = Eigen::Quaterniond::Identity();
    return out;
}

}  // namespace poinsot
