#include "mechanics/half_life.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "error/error.h"
#include "mechanics/torque.h"
#include "numerics/bracketed_root.h"

namespace poinsot {

namespace {

// For motions with more turns, the mean over each polhode is used.
constexpr double most_stepped_turns = 1000.0;
// Rotation in one step of the classical Runge–Kutta method, at the fastest rate: the numerical
// dissipation is below 1e-7 of T over all those turns.
constexpr double step_rad = 0.01;
// After so many radians of rotation by friction alone, no excess energy is left for any start: a
// tilt of 1e-12 takes 60.
constexpr double most_friction_rad = 1000.0;

// The body in units in which L = 1 and the largest moment is 1: time in I_max/L.
struct ScaledStart {
    Eigen::Vector3d moments;
    Eigen::Vector3d momentum;
    double seconds = 1.0;  // of a unit of time
    double range = 0.0;    // 1/I_min − 1/I_max: of 2T
};

// 2T − L²/I_max without cancelling: Σ Lᵢ²(1/Iᵢ − 1/I_max). And L²/I_min − 2T.
double excess(const ScaledStart& body, const Eigen::Vector3d& momentum) {
    return momentum.cwiseAbs2().dot(
        (1.0 - body.moments.array()).matrix().cwiseQuotient(body.moments));
}

double deficit(const ScaledStart& body, const Eigen::Vector3d& momentum) {
    const double least = body.moments.minCoeff();
    return momentum.cwiseAbs2().dot(
        (body.moments.array() - least).matrix().cwiseQuotient(least * body.moments));
}

ScaledStart scaled_start(const InertiaTensor& inertia, const Eigen::Vector3d& omega_body) {
    const Eigen::Vector3d omega = inertia.body_from_principal().transpose() * omega_body;
    const double largest = omega.cwiseAbs().maxCoeff();
    int axis = 0;
    omega.cwiseAbs().maxCoeff(&axis);
    Eigen::Vector3d aside = omega / largest;
    aside[axis] = 0.0;
    // With two equal moments every axis in their plane is principal: there ω is constant, too.
    const Eigen::Vector3d& I = inertia.moments_kg_m2();
    for (int i = 0; i < 3; ++i)
        if (I[i] == I[axis]) aside[i] = 0.0;
    if (!(largest > 0.0) || !(aside.norm() > 1e-12))
        throw InputError(
            "omega_rad_s: internal friction does not change a rotation exactly about a "
            "principal axis; tilt omega a little, as by a hundredth in another component");
    ScaledStart body;
    const double I_max = I.maxCoeff();
    body.moments = I / I_max;
    const Eigen::Vector3d momentum = body.moments.cwiseProduct(omega / largest);
    body.momentum = momentum.normalized();
    // ω and the moments were divided by their largest components.
    body.seconds = 1.0 / momentum.norm() / largest;
    const double least = body.moments.minCoeff();
    body.range = (1.0 - least) / least;
    return body;
}

// dL/dt = L × ω + κ L × (L × ω) with L = 1.
Eigen::Vector3d momentum_rate(const ScaledStart& body, double friction,
                              const Eigen::Vector3d& momentum) {
    const Eigen::Vector3d turning = momentum.cross(momentum.cwiseQuotient(body.moments));
    return turning + friction * momentum.cross(turning);
}

// The share of the excess that is left after a time, by numerical integration.
double share_left(const ScaledStart& body, double friction, double time) {
    if (friction * body.range * time > most_friction_rad) return 0.0;
    // Only the differences of the 1/Iᵢ turn L in the body.
    const double fastest = (1.0 + friction) * body.range;
    const auto n_steps =
        static_cast<std::int64_t>(std::ceil(std::max(256.0, time * fastest / step_rad)));
    const double h = time / static_cast<double>(n_steps);
    Eigen::Vector3d momentum = body.momentum;
    for (std::int64_t k = 0; k < n_steps; ++k) {
        const Eigen::Vector3d k1 = momentum_rate(body, friction, momentum);
        const Eigen::Vector3d k2 = momentum_rate(body, friction, momentum + 0.5 * h * k1);
        const Eigen::Vector3d k3 = momentum_rate(body, friction, momentum + 0.5 * h * k2);
        const Eigen::Vector3d k4 = momentum_rate(body, friction, momentum + h * k3);
        momentum += h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
        momentum.normalize();
    }
    return excess(body, momentum) / excess(body, body.momentum);
}

// Mean of |L × ω|² over a polhode with L = 1, for moments in ascending order. `above` is 2T −
// 1/I_max and `below` is 1/I_min − 2T; both are passed so that neither is the difference of nearly
// equal numbers.
double burning(const Eigen::Vector3d& rising, double above, double below) {
    const Eigen::Vector3d inverse = rising.cwiseInverse();
    const double upper = (rising[1] - rising[0]) * inverse[0] * inverse[1];  // 1/I1 − 1/I2
    const double lower = (rising[2] - rising[1]) * inverse[1] * inverse[2];
    if (!(above > 0.0) || !(below > 0.0)) return 0.0;
    // About the axis of the largest moment, or of the smallest: the same formulas with their places
    // exchanged. The modulus is below 1 for one of them.
    double k2 = upper * above / (lower * below);
    double side = upper;
    double own = above;
    double other = below;
    if (!(k2 <= 1.0)) {
        k2 = lower * below / (upper * above);
        side = lower;
        std::swap(own, other);
    }
    // Means of sn² and dn²; on the separatrix the motion stays at the middle axis.
    double sn2 = 0.5;
    if (k2 >= 1.0) {
        sn2 = 1.0;
    } else if (k2 > 1e-8) {
        const double k = std::sqrt(k2);
        sn2 = (1.0 - boost::math::ellint_2(k) / boost::math::ellint_1(k)) / k2;
    }
    // ω² − (2T)² is the variance of the 1/Iᵢ over the squares of L's components.
    return own * std::max(0.0, other - sn2 * side);
}

// The friction from the mean over each polhode: ∫ dT/⟨burning⟩ over the half of the energy that is
// lost, divided by the time.
double mean_friction(const ScaledStart& body, double time) {
    Eigen::Vector3d rising = body.moments;
    std::sort(rising.data(), rising.data() + 3);
    const double start = excess(body, body.momentum);
    const double end = 0.5 * start;
    if (!std::isfinite(body.range)) return std::numeric_limits<double>::quiet_NaN();
    // Integrates over the logarithm of the excess or, in the upper half of the range, of the
    // deficit from the greatest energy: near each axis the integrand is the reciprocal of that
    // quantity.
    const auto time_of = [](double energy, double burnt) {
        return burnt > 0.0 ? 0.5 * energy / burnt : 0.0;  // on the pole
    };
    const auto low_part = [&](double log_above) {
        const double above = std::exp(log_above);
        return time_of(above, burning(rising, above, body.range - above));
    };
    const auto high_part = [&](double log_below) {
        const double below = std::exp(log_below);
        return time_of(below, burning(rising, body.range - below, below));
    };
    // On the separatrix the mean dissipation is zero: the integrand has a logarithmic pole there,
    // and the integration interval is split at it.
    boost::math::quadrature::tanh_sinh<double> integrator;
    const auto integral = [&](const auto& function, double low, double high, double pole) {
        const auto piece = [&](double from, double to) {
            return from < to ? integrator.integrate(function, from, to, 1e-9) : 0.0;
        };
        if (!(low < pole && pole < high)) return piece(low, high);
        return piece(low, pole) + piece(pole, high);
    };
    const double half = 0.5 * body.range;
    const double separatrix = 1.0 / rising[1] - 1.0;
    double all =
        integral(low_part, std::log(end), std::log(std::min(start, half)), std::log(separatrix));
    if (start > half)
        all +=
            integral(high_part, std::log(deficit(body, body.momentum)),
                     std::log(body.range - std::max(end, half)), std::log(body.range - separatrix));
    return all / time;
}

// The friction that leaves half after the time, by stepping: from a guess outwards, by factors that
// are squared, until it lies between two.
double stepped_friction(const ScaledStart& body, double time, double guess) {
    constexpr int most_factors = 12;  // e^(0.1 · 2^12) spans all doubles
    const auto over_half = [&](double log_friction) {
        return share_left(body, std::exp(log_friction), time) - 0.5;
    };
    double low = std::log(guess);
    double high = low;
    const double sign = over_half(low) < 0.0 ? -1.0 : 1.0;
    double distance = 0.1;
    for (int k = 0; k < most_factors; ++k, distance *= 2.0) {
        double& far = sign < 0.0 ? low : high;
        double& near = sign < 0.0 ? high : low;
        near = far;
        far += sign * distance;
        if (sign * over_half(far) <= 0.0) return std::exp(bracketed_root(over_half, low, high));
    }
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double mean_burning(const Eigen::Vector3d& moments_kg_m2, double momentum, double twice_T) {
    Eigen::Vector3d rising = moments_kg_m2;
    std::sort(rising.data(), rising.data() + 3);
    const double L2 = momentum * momentum;
    return L2 * burning(rising, twice_T / L2 - 1.0 / rising[2], 1.0 / rising[0] - twice_T / L2);
}

double friction_rate_of_half_life(const InertiaTensor& inertia, const Eigen::Vector3d& omega_body,
                                  double half_life_s) {
    const ScaledStart body = scaled_start(inertia, omega_body);
    if (!(excess(body, body.momentum) > 1e-20))
        throw InputError(
            "omega_rad_s: a rotation about the axis of the largest moment has no energy that "
            "friction could take; start about another axis");
    const double time = half_life_s / body.seconds;
    double friction = mean_friction(body, time);
    if (time * body.range < 2.0 * std::numbers::pi * most_stepped_turns) {
        // Of a short time the mean says little; about one radian by friction is never far.
        const double guess =
            std::isfinite(friction) && friction > 0.0 ? friction : 1.0 / (time * body.range);
        friction = stepped_friction(body, time, guess);
    }
    // κ = friction · L is rate · tr(I)/3; L in units of I_max/seconds.
    const double rate_1_s = 3.0 * friction / body.moments.sum() / body.seconds;
    if (!std::isnormal(rate_1_s))
        throw InputError(fmt::format(
            "torque.half_life_s: no friction that doubles can express burns half of this body's "
            "energy in {:g} s; give a half-life nearer to the time of a turn, {:.3g} s",
            half_life_s, 2.0 * std::numbers::pi * body.seconds));
    return rate_1_s;
}

}  // namespace poinsot
