#include "mechanics/free/rotation_series.h"

#include "numerics/elliptic_integrals.h"

namespace poinsot {

namespace {

// 1, q, q², …, up to the highest power that a series here needs.
struct Nome {
    std::array<DoubleDouble, 26> power{};

    explicit Nome(DoubleDouble q) {
        power[0] = 1.0;
        for (std::size_t n = 1; n < power.size(); ++n) power[n] = power[n - 1] * q;
    }
    DoubleDouble operator[](int n) const { return power[static_cast<std::size_t>(n)]; }
};

// Theta functions at zero: θ₂/(2q^¼), θ₃, θ₄ (DLMF 20.2).
struct ThetaZeros {
    DoubleDouble two;
    DoubleDouble three;
    DoubleDouble four;

    explicit ThetaZeros(const Nome& q)
        : two(DoubleDouble(1.0) + q[2] + q[6] + q[12] + q[20]),
          three((q[1] + q[4] + q[9] + q[16] + q[25]) * 2.0 + 1.0),
          four((q[4] - q[1] - q[9] + q[16] - q[25]) * 2.0 + 1.0) {}
};

DoubleDouble ratio(const WideDouble& x, const WideDouble& y) { return (x / y).double_double(); }

// q, ρ and ρ′ of the trigonometric series; all zero for a symmetric body.
struct TrigonometricNomes {
    DoubleDouble q;
    DoubleDouble rho;
    DoubleDouble rho_other;
};

TrigonometricNomes trigonometric_nomes(const JacobiSolution& j) {
    if (j.modulus.is_zero()) return {};
    const DoubleDouble K = j.quarter_period.double_double();
    const DoubleDouble two_K = j.complementary_quarter_period.double_double() * 2.0;
    const DoubleDouble F = j.third_kind_argument.double_double();
    const DoubleDouble unit = -pi_dd / K;
    return {exp(unit * two_K * 0.5), exp(unit * (two_K - F)), exp(unit * (two_K + F))};
}

// Q = √q′ = exp(−πK/2K′) and δ = πF(φ,k′)/4K′; Q = 0 on the separatrix.
struct HyperbolicNomes {
    DoubleDouble root;
    SinCosDD delta;
};

DoubleDouble log_of_root_nome(const JacobiSolution& j) {
    const WideDouble exponent = ldexp(WideDouble(pi_dd) * j.quarter_period, -1);
    return -ratio(exponent, j.complementary_quarter_period);
}

HyperbolicNomes hyperbolic_nomes(const JacobiSolution& j) {
    HyperbolicNomes nomes;
    if (!j.quarter_period.is_zero()) nomes.root = exp(log_of_root_nome(j));
    nomes.delta =
        sin_cos(pi_dd * ratio(j.third_kind_argument, j.complementary_quarter_period) * 0.25);
    return nomes;
}

// sin and cos of δ, 3δ, 5δ, …
template <std::size_t size>
std::array<SinCosDD, size> odd_multiples(const SinCosDD& delta) {
    const DoubleDouble sin2 = delta.sin * delta.cos * 2.0;
    const DoubleDouble cos2 = DoubleDouble(1.0) - delta.sin * delta.sin * 2.0;
    std::array<SinCosDD, size> multiples{};
    multiples[0] = delta;
    for (std::size_t n = 1; n < size; ++n) {
        const SinCosDD& last = multiples[n - 1];
        multiples[n] = {last.sin * cos2 + last.cos * sin2, last.cos * cos2 - last.sin * sin2};
    }
    return multiples;
}

std::array<DoubleDouble, 2> unit(DoubleDouble re, DoubleDouble im) {
    const DoubleDouble length = sqrt(re * re + im * im);
    return {re / length, im / length};
}

// Θ at u₀, conjugated for s = +1, by its trigonometric terms.
std::array<DoubleDouble, 2> trigonometric_start(const JacobiSolution& j) {
    const TrigonometricNomes nomes = trigonometric_nomes(j);
    const Nome q(nomes.q);
    // e^{2iv} at the start, v = π·(u₀/2K).
    const SinCosDD turn = sin_cos(pi_dd * j.start_phase.double_double() * 2.0);
    DoubleDouble re = 1.0;
    DoubleDouble im;
    SinCosDD multiple = turn;
    DoubleDouble rho = 1.0;
    DoubleDouble rho_other = 1.0;
    for (int n = 1; n <= 4; ++n) {
        rho = rho * nomes.rho;
        rho_other = rho_other * nomes.rho_other;
        const DoubleDouble factor = q[2 * n * (n - 1)] * (n % 2 == 1 ? -1.0 : 1.0);
        re = re + factor * (rho + rho_other) * multiple.cos;
        im = im + factor * (rho - rho_other) * multiple.sin;
        multiple = {multiple.sin * turn.cos + multiple.cos * turn.sin,
                    multiple.cos * turn.cos - multiple.sin * turn.sin};
    }
    return unit(re, im * static_cast<double>(-j.s));
}

// The same by hyperbolic terms.
std::array<DoubleDouble, 2> hyperbolic_start(const JacobiSolution& j) {
    const HyperbolicNomes nomes = hyperbolic_nomes(j);
    const DoubleDouble phase = j.start_phase.double_double();
    const double side = phase.hi < 0.0 ? -1.0 : 1.0;
    DoubleDouble E;
    DoubleDouble F;
    DoubleDouble turn;
    if (j.quarter_period.is_zero()) {
        E = exp(-abs(phase));
    } else {
        const DoubleDouble exponent = log_of_root_nome(j) * 2.0;
        E = exp(exponent * abs(phase));
        F = exp(exponent * (DoubleDouble(0.5) - abs(phase)));
        // The part of Θ's argument that grows with u.
        turn = pi_dd * 0.5 * ratio(j.third_kind_argument, j.complementary_quarter_period) * phase;
    }
    const auto multiples = odd_multiples<6>(nomes.delta);
    DoubleDouble re;
    DoubleDouble im;
    DoubleDouble F_power = 1.0;
    DoubleDouble E_power = E;
    const Nome Q(nomes.root);
    for (int n = 0; n <= 4; ++n) {
        const SinCosDD& angle = multiples[static_cast<std::size_t>(n)];
        const DoubleDouble in_F = Q[n * n] * F_power;
        const DoubleDouble in_E = Q[n * n + n] * E_power;
        re = re + angle.cos * (in_F + in_E);
        im = im + angle.sin * (in_E - in_F) * side;
        F_power = F_power * F;
        E_power = E_power * E;
    }
    const SinCosDD linear = sin_cos(turn);
    return unit(re * linear.cos - im * linear.sin,
                (re * linear.sin + im * linear.cos) * static_cast<double>(-j.s));
}

}  // namespace

TrigonometricSeries trigonometric_series(const JacobiSolution& j) {
    const TrigonometricNomes nomes = trigonometric_nomes(j);
    const Nome q(nomes.q);
    const ThetaZeros zero(q);
    // cos 2nv, sin(2n+1)v/sin v and cos(2n+1)v/cos v as polynomials in sin²v.
    const auto even = [](DoubleDouble q1, DoubleDouble q4, DoubleDouble q9) {
        return std::array<DoubleDouble, 4>{(q1 + q4 + q9) * 2.0 + 1.0,
                                           (q1 * 2.0 + q4 * 8.0 + q9 * 18.0) * -2.0,
                                           (q4 * 8.0 + q9 * 48.0) * 2.0, q9 * -64.0};
    };
    const DoubleDouble q2 = q[2];
    const DoubleDouble q6 = q[6];
    const DoubleDouble q12 = q[12];
    const std::array<DoubleDouble, 4> theta_1{DoubleDouble(1.0) - q2 * 3.0 + q6 * 5.0 - q12 * 7.0,
                                              q2 * 4.0 - q6 * 20.0 + q12 * 56.0,
                                              q6 * 16.0 - q12 * 112.0, q12 * 64.0};
    const std::array<DoubleDouble, 4> theta_2{DoubleDouble(1.0) + q2 + q6 + q12,
                                              (q2 * 4.0 + q6 * 12.0 + q12 * 24.0) * -1.0,
                                              q6 * 16.0 + q12 * 80.0, q12 * -64.0};

    // dn = (θ₄/θ₃)(0)·θ₃/θ₄, sn = (θ₃/θ₂)(0)·θ₁/θ₄, cn = (θ₄/θ₂)(0)·θ₂/θ₄ (DLMF 22.2).
    TrigonometricSeries series;
    const auto& [A, B, C] = j.amplitude;
    using Coefficients = std::array<DoubleDouble, 4>;
    const auto set = [](std::array<Pair, 4>& pairs, int place, const Coefficients& p,
                        DoubleDouble factor) {
        for (std::size_t n = 0; n < 4; ++n) pairs[n][place] = (p[n] * factor).rounded();
    };
    const DoubleDouble A_over_L = ratio(A, j.momentum);
    set(series.weight_a, 0, even(-q[1], q[4], -q[9]), 1.0);
    set(series.weight_a, 1, even(q[1], q[4], q[9]), A_over_L * zero.four / zero.three);
    set(series.b_c, 0, theta_1, ratio(B, j.momentum) * zero.three / zero.two);
    set(series.b_c, 1, theta_2,
        ratio(C, j.momentum) * static_cast<double>(j.s) * zero.four / zero.two);

    // Real part 1 − (ρ+ρ′)cos 2v + …, imaginary part sin v cos v·(−2(ρ−ρ′) + …).
    const DoubleDouble& rho = nomes.rho;
    const DoubleDouble& other = nomes.rho_other;
    const DoubleDouble rho2 = rho * rho * q[4];
    const DoubleDouble other2 = other * other * q[4];
    const DoubleDouble rho3 = rho * rho * rho * q[12];
    const DoubleDouble other3 = other * other * other * q[12];
    const DoubleDouble p1 = (rho + other) * -0.5;
    const DoubleDouble p2 = (rho2 + other2) * 0.5;
    const DoubleDouble p3 = (rho3 + other3) * -0.5;
    set(series.rotor, 0, even(p1, p2, p3), 1.0);
    const DoubleDouble d1 = rho - other;
    const DoubleDouble d2 = rho2 - other2;
    const DoubleDouble d3 = rho3 - other3;
    set(series.rotor, 1, {d2 * 4.0 - d1 * 2.0 - d3 * 6.0, d3 * 32.0 - d2 * 8.0, d3 * -32.0, 0.0},
        static_cast<double>(-j.s));
    // At u = 0 Θ is real.
    const DoubleDouble theta = (p1 + p2 + p3) * 2.0 + 1.0;
    series.kappa = theta * theta / (zero.four * (A_over_L + 1.0));
    return series;
}

HyperbolicSeries hyperbolic_series(const JacobiSolution& j) {
    const HyperbolicNomes nomes = hyperbolic_nomes(j);
    // Terms below 2^−120 are left out: they are negligible beside 1.
    const DoubleDouble root = nomes.root.hi > 0x1p-60 ? nomes.root : DoubleDouble(0.0);
    const Nome Q(root);
    const Nome q(root * root);
    const ThetaZeros zero(q);

    HyperbolicSeries series;
    if (!j.quarter_period.is_zero()) {
        const DoubleDouble exponent = ldexp(-log_of_root_nome(j) / ln2_dd, 7);
        series.exponent_high = split(exponent.hi).hi;
        series.exponent_low = (exponent - series.exponent_high).rounded();
        series.phase_per_period =
            -j.s * ratio(j.third_kind_argument, j.complementary_quarter_period).rounded();
    }
    if (!j.quarter_period.is_zero()) {
        series.root_nome_up = exp(log_of_root_nome(j) + ln2_dd * 512.0).rounded();
    }
    // dn, sn, cn of the complementary nome: the factors of DLMF 22.2 after 20.7(viii).
    const auto& [A, B, C] = j.amplitude;
    const DoubleDouble two = zero.two * 2.0;
    series.a = (ratio(A, j.momentum) * two / zero.three).rounded();
    series.b = (ratio(B, j.momentum) * zero.three / zero.four).rounded();
    series.c = (ratio(C, j.momentum) * two / zero.four).rounded() * j.s;
    series.q1 = both(q[1].rounded());
    series.q2 = both(q[2].rounded());
    series.q4 = both(q[4].rounded());
    series.q6 = both(q[6].rounded());
    series.q9 = both(q[9].rounded());
    series.zero_0 = both((DoubleDouble(1.0) - q[2] + q[6]).rounded());
    series.zero_1 = both((q[5] - q[1]).rounded());
    series.zero_2 = both((q[6] - q[2]).rounded());
    series.is_short = root.hi < 0x1p-15;

    const auto multiples = odd_multiples<5>(nomes.delta);
    DoubleDouble theta;  // half of Θ at u = 0
    for (int n = 0; n <= 4; ++n)
        theta = theta + multiples[static_cast<std::size_t>(n)].cos * Q[n * n + n];
    series.kappa = theta * theta * 2.0 / (zero.two * (ratio(A, j.momentum) + 1.0));
    for (int n = 0; n <= 4; ++n) {
        const auto i = static_cast<std::size_t>(n);
        series.in_F[i] = Pair{(multiples[i].cos * Q[n * n]).rounded(),
                              (multiples[i].sin * Q[n * n]).rounded() * j.s};
        if (n == 4) break;
        series.in_E[i] = Pair{(multiples[i].cos * Q[n * n + n]).rounded(),
                              (multiples[i].sin * Q[n * n + n]).rounded() * -j.s};
    }
    return series;
}

std::array<DoubleDouble, 2> start_rotor(const JacobiSolution& solution) {
    return suits_trigonometric(solution) ? trigonometric_start(solution)
                                         : hyperbolic_start(solution);
}

}  // namespace poinsot
