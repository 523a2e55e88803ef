#include "mechanics/top_families.h"

#include <array>
#include <numbers>

#include "mechanics/heavy_top_oracle.h"

namespace poinsot::tops {

namespace {

constexpr double pi = std::numbers::pi;

HeavyTopProblem near_vertical(Random& random) {
    HeavyTopProblem p = generic_top(random);
    p.theta_rad = std::pow(10.0, uniform(random, -12.0, -1.0));
    p.theta_dot_rad_s *= p.theta_rad;
    p.omega3_rad_s = uniform(random, -4.0, 4.0);
    return p;
}

HeavyTopProblem near_bottom(Random& random) {
    HeavyTopProblem p = generic_top(random);
    p.theta_rad = pi - std::pow(10.0, uniform(random, -12.0, -1.0));
    p.mgl_N_m = std::abs(p.mgl_N_m);
    return p;
}

HeavyTopProblem from_vertical(Random& random) {
    HeavyTopProblem p = generic_top(random);
    p.theta_rad = 0.0;
    return p;
}

HeavyTopProblem pendulum(Random& random) {
    HeavyTopProblem p = generic_top(random);
    p.omega3_rad_s = 0.0;
    if (random() % 2 == 0) p.phi_dot_rad_s = 0.0;
    return p;
}

HeavyTopProblem weak_gravity(Random& random) {
    HeavyTopProblem p = generic_top(random);
    p.mgl_N_m = std::copysign(std::pow(10.0, uniform(random, -20.0, 0.0)), p.mgl_N_m);
    p.moment_axial_kg_m2 = p.moment_transverse_kg_m2 * std::pow(10.0, uniform(random, -9.0, 0.3));
    return p;
}

HeavyTopProblem near_steady(Random& random) {
    HeavyTopProblem p = generic_top(random);
    p.mgl_N_m = std::abs(p.mgl_N_m);
    p.theta_rad = uniform(random, 0.1, 1.4);
    const double cosine = std::cos(p.theta_rad);
    const double spin = std::sqrt(4.0 * p.moment_transverse_kg_m2 * p.mgl_N_m * cosine);
    p.omega3_rad_s = uniform(random, 1.05, 3.0) * spin / p.moment_axial_kg_m2;
    const double a = p.moment_axial_kg_m2 * p.omega3_rad_s / p.moment_transverse_kg_m2;
    const double root = std::sqrt(a * a - 4.0 * cosine * p.mgl_N_m / p.moment_transverse_kg_m2);
    p.phi_dot_rad_s = (random() % 2 == 0 ? a - root : a + root) / (2.0 * cosine) +
                      std::pow(10.0, uniform(random, -20.0, -3.0));
    p.theta_dot_rad_s = random() % 2 == 0 ? 0.0 : std::pow(10.0, uniform(random, -300.0, -3.0));
    return p;
}

// A pendulum-like top whose energy is that of the upright position to 1e-1 … 1e-15.
HeavyTopProblem near_separatrix(Random& random) {
    HeavyTopProblem p = generic_top(random);
    p.mgl_N_m = uniform(random, 0.5, 2.0);
    p.theta_rad = uniform(random, 0.5, 3.0);
    // p_φ = p_ψ and E = E_upright: φ̇ = a/(1 + cos θ), θ̇² = βx − φ̇² sin²θ.
    const double a = uniform(random, 0.0, 0.5);
    p.omega3_rad_s = a * p.moment_transverse_kg_m2 / p.moment_axial_kg_m2;
    p.phi_dot_rad_s = a / (1.0 + std::cos(p.theta_rad));
    const double x = 1.0 - std::cos(p.theta_rad);
    const double rate2 =
        2.0 * p.mgl_N_m / p.moment_transverse_kg_m2 * x - a * a * x / (1.0 + std::cos(p.theta_rad));
    p.theta_dot_rad_s =
        -std::sqrt(std::max(rate2, 0.0)) + std::pow(10.0, uniform(random, -15.0, -1.0));
    return p;
}

// Every number of its own scale, out of so many decades; a fifth of the rates are 0.
template <int decades>
HeavyTopProblem of_any_scale(Random& random) {
    const auto size = [&random] {
        return std::pow(10.0, uniform(random, -0.5 * decades, 0.5 * decades));
    };
    const auto rate = [&] {
        const double sign = random() % 2 == 0 ? 1.0 : -1.0;
        return random() % 5 == 0 ? 0.0 : sign * size();
    };
    HeavyTopProblem p;
    p.moment_transverse_kg_m2 = size();
    p.moment_axial_kg_m2 = 2.0 * p.moment_transverse_kg_m2 *
                           std::pow(10.0, uniform(random, -std::min(decades, 12), 0));
    p.mgl_N_m = (random() % 2 == 0 ? 1.0 : -1.0) * size();
    p.theta_rad = uniform(random, 0.0, pi);
    if (random() % 4 == 0) p.theta_rad = std::pow(10.0, uniform(random, -0.5 * decades, 0.0));
    if (random() % 4 == 0) p.theta_rad = pi - p.theta_rad;
    p.theta_dot_rad_s = rate();
    p.phi_dot_rad_s = rate();
    p.omega3_rad_s = rate();
    return p;
}

constexpr std::array families{
    Family{"heavy top, generic", generic_top, 20.0, false},
    Family{"heavy top, near the vertical", near_vertical, 12.0, true},
    Family{"heavy top, near the bottom", near_bottom, 20.0, false},
    Family{"heavy top, from exactly vertical", from_vertical, 15.0, true},
    Family{"heavy top, planar and spherical pendulums", pendulum, 15.0, true},
    Family{"heavy top, weak gravity, extreme shapes", weak_gravity, 15.0, false},
    Family{"heavy top, near steady precession", near_steady, 15.0, false},
    Family{"heavy top, near the separatrix", near_separatrix, 12.0, true},
    Family{"heavy top, scales of 2 decades", of_any_scale<2>, 8.0, true, true},
    Family{"heavy top, scales of 8 decades", of_any_scale<8>, 8.0, true, true},
    Family{"heavy top, scales of 150 decades", of_any_scale<150>, 8.0, true, true},
    Family{"heavy top, scales of 300 decades", of_any_scale<300>, 8.0, true, true},
};

template <typename Real>
void compare(const HeavyTopProblem& problem, double piece_s, Residuals& worst) {
    const HeavyTop top(problem);
    TaylorTop<Real> oracle(problem);
    for (int k = 1; k <= 4; ++k) {
        oracle.advance(piece_s);
        const Difference d =
            difference(problem, top.at(k * piece_s), oracle.quaternion(), oracle.omega());
        worst.attitude = std::max(worst.attitude, d.attitude);
        worst.omega = std::max(worst.omega, d.omega);
    }
}

}  // namespace

double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

HeavyTopProblem generic_top(Random& random) {
    HeavyTopProblem p;
    p.moment_transverse_kg_m2 = uniform(random, 0.3, 3.0);
    p.moment_axial_kg_m2 = p.moment_transverse_kg_m2 * uniform(random, 0.05, 2.0);
    p.mgl_N_m = uniform(random, -4.0, 4.0);
    p.theta_rad = uniform(random, 0.01, 3.13);
    p.theta_dot_rad_s = uniform(random, -2.0, 2.0);
    p.phi_dot_rad_s = uniform(random, -2.0, 2.0);
    p.omega3_rad_s = uniform(random, -8.0, 8.0);
    return p;
}

std::span<const Family> all() { return families; }

Residuals measure(const Family& family, int first, int last) {
    Residuals worst;
    for (int i = first; i < last; ++i) {
        Random random(static_cast<Random::result_type>(i) + 1);
        const HeavyTopProblem problem = family.draw(random);
        // A multiple of 1/64 s, so that four of them are exact.
        double piece_s = std::ldexp(std::round(family.duration_s * (i % 4 == 3 ? -16 : 16)), -6);
        if (family.of_any_scale)
            // Every fourth time, the motion just after the start.
            piece_s =
                std::ldexp(piece_s, -TaylorTop<Wide>::exponent_of(problem) - (i % 4 == 2 ? 20 : 0));
        if (family.amplifies) {
            compare<DoubleDouble>(problem, piece_s, worst);
        } else {
            compare<Wide>(problem, piece_s, worst);
        }
    }
    return worst;
}

}  // namespace poinsot::tops
