// Evaluation of Lagrange's top: two theta series and a phase each.
#include "mechanics/top/heavy_top.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "error/error.h"

namespace poinsot {

namespace {

using Complex = std::complex<double>;

constexpr DoubleDouble half_pi{1.57079632679489656, 6.12323399573676604e-17};
constexpr DoubleDouble two_pi{6.28318530717958648, 2.44929359829470641e-16};

// i to the power n.
Complex quarter_turns(std::int64_t n) {
    switch (((n % 4) + 4) % 4) {
        case 0:
            return {1.0, 0.0};
        case 1:
            return {0.0, 1.0};
        case 2:
            return {-1.0, 0.0};
        default:
            return {0.0, -1.0};
    }
}

// e^{iφ}; the whole turns are subtracted in double-double: each pass takes fifty bits off the
// phase, and of NaN there is one.
Complex unit_phase(DoubleDouble phase) {
    DoubleDouble rest = phase;
    do {
        rest = rest + two_pi * -std::round(rest.hi / two_pi.hi);
    } while (std::abs(rest.hi) > two_pi.hi);
    return {std::cos(rest.hi) - rest.lo * std::sin(rest.hi),
            std::sin(rest.hi) + rest.lo * std::cos(rest.hi)};
}

}  // namespace

// The phase of the nutation, reduced to the nearest turning point.
struct HeavyTop::Phase {
    double r = 0.0;  // u from the turning point
    std::int64_t quarter = 0;
    double quarters = 0.0;  // the same number, also where it exceeds an integer
    double elapsed = 0.0;   // in the series' unit of time
};

// α and β up to a common positive factor and without the phases e^{i rate t}, and their rates.
struct HeavyTop::Factors {
    Complex value[2];
    Complex slope[2];  // the value's own rate
    Complex rate[2];   // the same with the regular part of the phase
};

HeavyTop::Phase HeavyTop::phase_at(double time_s) const {
    Phase phase;
    const double elapsed = std::ldexp(time_s - given_.time_s, rate_exponent_);
    phase.elapsed = elapsed;
    const double fastest = std::max({series_.lambda.hi, std::abs(series_.factor[0].rate.hi),
                                     std::abs(series_.factor[1].rate.hi)});
    constexpr double largest_phase = 1e290;  // products of two words must not overflow
    if (!(fastest * std::abs(elapsed) < largest_phase) || !std::isfinite(elapsed)) {
        throw InputError(
            fmt::format("time_s: the top's phase after {} s exceeds what a double holds; ask for "
                        "an earlier time",
                        time_s));
    }
    if (series_.steady) return phase;
    DoubleDouble u = series_.lambda * elapsed + series_.u_start;
    if (std::isfinite(series_.quarter_u.hi)) {
        // One pass, or more if the number of quarters approaches 2^53, since each takes fifty bits
        // off u: the series are those of the nearest turning point. Of NaN there is one.
        constexpr double half_a_quarter = 0.5 + 0x1p-10;
        do {
            const double quarters = std::round(u.hi / series_.quarter_u.hi);
            u = u + series_.quarter_u * -quarters;
            phase.quarters += quarters;
            phase.quarter += static_cast<std::int64_t>(std::fmod(quarters, 4.0));
        } while (std::abs(u.hi) > half_a_quarter * series_.quarter_u.hi);
    }
    phase.quarters += series_.quarter_start;
    phase.quarter += series_.quarter_start;
    phase.r = u.rounded();
    return phase;
}

HeavyTop::Factors HeavyTop::factors_at(const Phase& phase) const {
    Factors result;
    const double lambda = series_.lambda.hi;
    if (series_.steady) {
        for (int which = 0; which < 2; ++which) {
            const TopFactor& factor = series_.factor[which];
            result.value[which] = factor.lower_amplitude;
            result.slope[which] = 0.0;
            result.rate[which] = Complex(0.0, factor.regular_rate) * factor.lower_amplitude;
        }
        return result;
    }

    const bool upper = phase.quarter % 2 != 0;
    const double argument = phase.r * series_.argument_per_u;
    const double curvature = series_.hyperbolic ? 1.0 : -1.0;
    Multiples m;
    if (!series_.hyperbolic) {
        m = multiples_of(std::cos(argument), std::sin(argument), curvature);
    } else if (series_.scaled && !upper && std::abs(argument) > 1.0) {
        // All terms are multiplied by e^{−|argument|}; the normalisation removes this factor.
        const double decay = std::exp(-2.0 * std::abs(argument));
        m = Multiples{};
        m.odd_cos[0] = 0.5 * (1.0 + decay);
        m.odd_sin[0] = std::copysign(0.5 * (1.0 - decay), argument);
        m.even_cos[0] = std::exp(-std::abs(argument));
    } else {
        constexpr double largest = 700.0;  // where a factor this large stands beside a vanishing k'
        const double bounded = std::clamp(argument, -largest, largest);
        m = multiples_of(std::cosh(bounded), std::sinh(bounded), curvature);
    }

    for (int which = 0; which < 2; ++which) {
        const TopFactor& factor = series_.factor[which];
        const bool theta1 = (which == 0) != upper;
        const bool even = series_.hyperbolic && !theta1;
        const SeriesValue sum =
            sum_series(theta1 ? factor.theta1_re : factor.theta2_re,
                       theta1 ? factor.theta1_im : factor.theta2_im, even ? m.even_cos : m.odd_cos,
                       even ? m.even_sin : m.odd_sin, even ? 0 : 1, curvature, series_.n_terms);
        const double phase_rate = factor.regular_rate + lambda * factor.cell_rate;
        const Complex slope = lambda * series_.argument_per_u * sum.slope;
        const Complex rate = slope + Complex(0.0, phase_rate) * sum.value;
        const double first = upper ? factor.upper_amplitude[1] : 1.0;
        const double second = upper ? factor.upper_amplitude[0] : factor.lower_amplitude;
        result.value[which] = second * (first * sum.value);
        result.slope[which] = second * (first * slope);
        result.rate[which] = second * (first * rate);
    }
    return result;
}

// The continuous phase of a factor, from the series' own zero; in double-double, because φ and ψ
// are sums and differences of large phases.
DoubleDouble HeavyTop::unwrapped(int which, const Phase& phase, const Factors& factors) const {
    const TopFactor& factor = series_.factor[which];
    if (factor.zero) return 0.0;
    const DoubleDouble secular = factor.rate * phase.elapsed;
    if (series_.steady) return secular;
    const DoubleDouble angle = secular + factor.cell_rate * phase.r;
    const Complex& value = factors.value[which];
    if (factor.through_zero) {
        // θ1 passes through zero along a straight line: no winding, a jump of π there and back.
        Complex turned = quarter_turns(factor.winding * phase.quarter);
        if (which == 0) turned *= Complex(0.0, -factor.winding);
        const Complex along = value == 0.0 ? factors.rate[which] : value;
        return (turned * along).real() < 0.0 ? angle + half_pi * 2.0 : angle;
    }
    return angle + half_pi * (factor.winding * phase.quarters) + std::arg(value);
}

// Rotates the series so that they match the start: by their phase there, or by the phase of their
// rate where the start is exactly vertical.
void HeavyTop::fit_start(std::complex<double> omega_transverse) {
    const Phase phase = phase_at(given_.time_s);
    const Factors factors = factors_at(phase);
    const int alpha = series_.reversed ? 1 : 0;
    // 2 dα/dt = −β conj(ω1 + iω2) at α = 0, and 2 dβ/dt = α (ω1 + iω2) at β = 0.
    const Complex start_rate[2] = {-start_[1] * std::conj(omega_transverse),
                                   start_[0] * omega_transverse};
    for (int which = 0; which < 2; ++which) {
        const int series_index = which == 0 ? alpha : 1 - alpha;
        const TopFactor& factor = series_.factor[series_index];
        start_angle_[series_index] = unwrapped(series_index, phase, factors);
        const bool vertical = start_[which] == 0.0;
        const Complex wanted = vertical ? start_rate[which] : start_[which];
        const Complex value = vertical ? factors.rate[series_index] : factors.value[series_index];
        const Complex turned = quarter_turns(factor.winding * phase.quarter) * value *
                               std::polar(1.0, factor.cell_rate * phase.r);
        if (wanted == 0.0 || turned == 0.0) continue;
        // Scaled first: either may be as small as 1e-300.
        const Complex ratio = (wanted / std::abs(wanted)) * std::conj(turned / std::abs(turned));
        start_phase_[series_index] = ratio / std::abs(ratio);
    }
}

RotationState HeavyTop::state_from(double time_s, const Phase& phase,
                                   const Factors& factors) const {
    Complex value[2];
    Complex slope[2];
    Complex turn[2];
    for (int which = 0; which < 2; ++which) {
        const TopFactor& factor = series_.factor[which];
        DoubleDouble angle = factor.rate * phase.elapsed;
        if (!series_.steady) angle = angle + factor.cell_rate * phase.r;
        turn[which] = unit_phase(angle) * start_phase_[which] *
                      quarter_turns(series_.steady ? 0 : factor.winding * phase.quarter);
        value[which] = factors.value[which];
        slope[which] = factors.slope[which];
    }
    if (series_.reversed) {
        // q = q' i⁻¹: α = β' and β = −α' for the body turned back about e1.
        std::swap(value[0], value[1]);
        std::swap(slope[0], slope[1]);
        std::swap(turn[0], turn[1]);
    }

    // ω1 + iω2 = 2 (ᾱ dβ/dt − β dᾱ/dt); the norm's own rate drops out. The phases are common
    // factors, and their rates a sum: what cancels is little. One of α and β is never small, so
    // that an underflow of the other's square is harmless.
    const auto length = [](const Complex(&pair)[2]) {
        return std::sqrt(std::norm(pair[0]) + std::norm(pair[1]));
    };
    const Complex turned[2] = {turn[0] * value[0], turn[1] * value[1]};
    const double norm = length(turned);
    const Complex alpha = turned[0] / norm;
    const Complex beta = turned[1] / norm;
    // The phases' own lengths are 1 but for rounding, which does not enter ω's terms.
    const double norm_before = length(value);
    for (int which = 0; which < 2; ++which) {
        value[which] /= norm_before;
        slope[which] /= norm_before;
    }
    const Complex within = std::conj(value[0]) * slope[1] - value[1] * std::conj(slope[0]) +
                           Complex(0.0, series_.phase_rate) * (std::conj(value[0]) * value[1]);
    const Complex omega = 2.0 * std::conj(turn[0]) * turn[1] * within;

    RotationState state;
    state.time_s = time_s;
    state.space_from_body =
        Eigen::Quaterniond(alpha.real(), beta.real(), beta.imag(), alpha.imag()) *
        body_from_top_.conjugate();
    state.omega_body =
        body_from_top_ * Eigen::Vector3d(std::ldexp(omega.real(), rate_exponent_),
                                         std::ldexp(omega.imag(), rate_exponent_), omega3_);
    return state;
}

EulerAngles HeavyTop::angles_from(const Phase& phase, const Factors& factors) const {
    const int alpha = series_.reversed ? 1 : 0;
    DoubleDouble half_angle[2];
    for (int which = 0; which < 2; ++which) {
        const int index = which == 0 ? alpha : 1 - alpha;
        half_angle[which] = unwrapped(index, phase, factors) - start_angle_[index];
    }
    EulerAngles angles;
    angles.theta_rad =
        2.0 * std::atan2(std::abs(factors.value[1 - alpha]), std::abs(factors.value[alpha]));
    const double mean = 0.5 * (angle_start_[0] + angle_start_[1]);
    const double half_difference = 0.5 * (angle_start_[0] - angle_start_[1]);
    angles.phi_rad = (half_angle[0] + half_angle[1] + mean).rounded();
    angles.psi_rad = (half_angle[0] - half_angle[1] + half_difference).rounded();
    return angles;
}

RotationState HeavyTop::at(double time_s) const {
    if (is_start(time_s)) return given_;
    const Phase phase = phase_at(time_s);
    return state_from(time_s, phase, factors_at(phase));
}

EulerAngles HeavyTop::euler_angles(double time_s) const {
    if (is_start(time_s)) return given_angles_;
    const Phase phase = phase_at(time_s);
    return angles_from(phase, factors_at(phase));
}

MotionSample HeavyTop::sample(double time_s, Quantities wanted) const {
    MotionSample sample;
    if (is_start(time_s)) {
        sample.state = given_;
        sample.euler = given_angles_;
    } else {
        const Phase phase = phase_at(time_s);
        const Factors factors = factors_at(phase);
        sample.state = state_from(time_s, phase, factors);
        if (wanted.euler_angles) sample.euler = angles_from(phase, factors);
    }
    if (wanted.herpolhode) {
        // L itself moves in space, and ω's part across it is taken at this instant.
        const Eigen::Vector3d omega = body_from_top_.conjugate() * sample.state.omega_body;
        const Eigen::Vector3d momentum(moment_transverse_ * omega[0], moment_transverse_ * omega[1],
                                       moment_axial_ * omega[2]);
        const Eigen::Vector3d across = omega_across_momentum(momentum, omega);
        sample.herpolhode_space = sample.state.space_from_body * (body_from_top_ * across).eval();
    }
    if (!wanted.attitude) sample.state.space_from_body = Eigen::Quaterniond::Identity();
    return sample;
}

double HeavyTop::effective_potential_J(double theta_rad) const {
    const double half = std::sin(0.5 * theta_rad);
    const double sine = std::sin(theta_rad);
    const double p_psi = invariants_.p_psi_kg_m2_s;
    const double across = p_phi_minus_p_psi_ + p_psi * 2.0 * half * half;
    // At a vertical with p_φ = ±p_ψ the quotient tends to zero.
    const double centrifugal =
        across == 0.0 ? 0.0 : across * across / (2.0 * moment_transverse_ * sine * sine);
    return centrifugal + p_psi * p_psi / (2.0 * moment_axial_) + mgl_ * std::cos(theta_rad);
}

}  // namespace poinsot
