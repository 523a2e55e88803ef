#include "mechanics/half_life.h"

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <numbers>

#include "error/error.h"
#include "mechanics/torque.h"
#include "numerics/bracketed_root.h"

namespace poinsot {

namespace {

// Motions that turn more often go by their mean.
constexpr double most_stepped_turns = 1500.0;
// Of the fastest turning, a step of the classical Runge–Kutta method: its own friction is below
// 1e-7 of T over all those turns.
constexpr double step_rad = 0.02;

// The body in units in which L = 1 and the largest moment is 1: time in I_max/L.
struct ScaledStart {
    Eigen::Vector3d moments;
    Eigen::Vector3d momentum;
    double seconds = 1.0;  // of a unit of time
};

double twice_T(const ScaledStart& body, const Eigen::Vector3d& momentum) {
    return momentum.dot(momentum.cwiseQuotient(body.moments));
}

// 2T − L²/I_max, without cancelling: Σ Lᵢ²(1/Iᵢ − 1/I_max).
double excess(const ScaledStart& body, const Eigen::Vector3d& momentum) {
    return momentum.cwiseAbs2().dot(
        (1.0 - body.moments.array()).matrix().cwiseQuotient(body.moments));
}

ScaledStart scaled_start(const InertiaTensor& inertia, const Eigen::Vector3d& omega_body) {
    const Eigen::Vector3d omega = inertia.body_from_principal().transpose() * omega_body;
    const double largest = omega.cwiseAbs().maxCoeff();
    int axis = 0;
    omega.cwiseAbs().maxCoeff(&axis);
    Eigen::Vector3d aside = omega;
    aside[axis] = 0.0;
    // Equal moments have no axis of their own: within their plane, ω stays as well.
    const Eigen::Vector3d& I = inertia.moments_kg_m2();
    for (int i = 0; i < 3; ++i)
        if (I[i] == I[axis]) aside[i] = 0.0;
    if (!(largest > 0.0) || !(aside.norm() > 1e-12 * largest))
        throw InputError(
            "omega_rad_s: friction inside a body does not change a rotation exactly about a "
            "principal axis; tilt omega a little, as by a hundredth in another component");
    ScaledStart body;
    const double I_max = I.maxCoeff();
    body.moments = I / I_max;
    const Eigen::Vector3d momentum = body.moments.cwiseProduct(omega / largest);
    body.momentum = momentum.normalized();
    body.seconds = 1.0 / (largest * momentum.norm());
    return body;
}

// dL/dt = L × ω + κ L × (L × ω) with L = 1.
Eigen::Vector3d momentum_rate(const ScaledStart& body, double friction,
                              const Eigen::Vector3d& momentum) {
    const Eigen::Vector3d turning = momentum.cross(momentum.cwiseQuotient(body.moments));
    return turning + friction * momentum.cross(turning);
}

// The share of the excess that is left after a time, by stepping.
double share_left(const ScaledStart& body, double friction, double time) {
    const double fastest = (1.0 + friction) / body.moments.minCoeff();
    const auto n_steps =
        static_cast<std::int64_t>(std::ceil(std::max(64.0, time * fastest / step_rad)));
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

// The friction by the mean of each polhode: ∫ dT/⟨burning⟩ over the half that goes, over the time.
double mean_friction(const ScaledStart& body, double time) {
    const double least = 1.0;  // 2T about the largest moment
    const double start = twice_T(body, body.momentum);
    const double end = least + 0.5 * (start - least);
    const auto inverse = [&body](double twice_energy) {
        return 0.5 / mean_burning(body.moments, 1.0, twice_energy);
    };
    // The polhodes through the middle axis burn nothing in the mean: the integrand has a pole of a
    // logarithm there, which lies at an end of each part.
    Eigen::Vector3d sorted = body.moments;
    std::sort(sorted.data(), sorted.data() + 3);
    const double separatrix = 1.0 / sorted[1];
    boost::math::quadrature::tanh_sinh<double> integrator;
    const auto integral = [&](double low, double high) {
        return low < high ? integrator.integrate(inverse, low, high, 1e-9) : 0.0;
    };
    const bool passes = end < separatrix && separatrix < start;
    const double all =
        passes ? integral(end, separatrix) + integral(separatrix, start) : integral(end, start);
    return all / time;
}

}  // namespace

double mean_burning(const Eigen::Vector3d& moments_kg_m2, double momentum, double twice_T) {
    Eigen::Vector3d I = moments_kg_m2;
    std::sort(I.data(), I.data() + 3);
    const double L2 = momentum * momentum;
    // About the axis of the largest moment, or of the smallest: the same formulas with their places
    // exchanged.
    if (L2 < twice_T * I[1]) std::swap(I[0], I[2]);
    const double toward_0 = twice_T * I[2] - L2;
    const double toward_2 = L2 - twice_T * I[0];
    const double across = I[2] - I[0];
    const double k2 = std::clamp((I[1] - I[0]) * toward_0 / ((I[2] - I[1]) * toward_2), 0.0, 1.0);
    const double k = std::sqrt(k2);
    // Means of sn² and dn²; on the separatrix the motion stays at the middle axis.
    double sn2 = 0.5;
    double dn2 = 1.0;
    if (k2 >= 1.0) {
        sn2 = 1.0, dn2 = 0.0;
    } else if (k2 > 1e-8) {
        dn2 = boost::math::ellint_2(k) / boost::math::ellint_1(k);
        sn2 = (1.0 - dn2) / k2;
    } else {
        dn2 = 1.0 - 0.5 * k2;
    }
    // Lᵢ²; L2 of the middle axis by what is left where I1 = I2 makes its own formula 0/0.
    const double m0 = I[0] * toward_0 / across * (1.0 - sn2);
    const double m2 = I[2] * toward_2 / across * dn2;
    const double m1 = L2 - m0 - m2;
    const double omega2 = m0 / (I[0] * I[0]) + m1 / (I[1] * I[1]) + m2 / (I[2] * I[2]);
    return omega2 - twice_T * twice_T / L2;
}

double dissipation_rate_of_half_life(const InertiaTensor& inertia,
                                     const Eigen::Vector3d& omega_body, double half_life_s) {
    const ScaledStart body = scaled_start(inertia, omega_body);
    if (!(excess(body, body.momentum) > 1e-20))
        throw InputError(
            "omega_rad_s: a rotation about the axis of the largest moment has no energy that "
            "friction could take; start about another axis");
    const double time = half_life_s / body.seconds;
    double friction = mean_friction(body, time);
    const double turns = time / body.moments.minCoeff() / (2.0 * std::numbers::pi);
    if (turns < most_stepped_turns) {
        const auto over_half = [&](double log_friction) {
            return share_left(body, std::exp(log_friction), time) - 0.5;
        };
        double low = std::log(friction);
        double high = low;
        while (over_half(low) < 0.0) low -= 0.25;
        while (over_half(high) > 0.0) high += 0.25;
        if (low < high) friction = std::exp(bracketed_root(over_half, low, high));
    }
    // κ = friction · L is rate · tr(I)/3; L in units of I_max/seconds.
    const double trace = body.moments.sum();
    return 3.0 * friction / (trace * body.seconds);
}

}  // namespace poinsot
