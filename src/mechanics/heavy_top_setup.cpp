// The setup of Lagrange's top in 113-bit arithmetic: from the cubic's roots to periods, nomes and
// phase rates. The symbols are those of heavy_top_cubic.h.
#include <fmt/format.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "error/error.h"
#include "mechanics/heavy_top.h"
#include "mechanics/heavy_top_cubic.h"

namespace poinsot {

using namespace top_setup;

namespace {

const Real pi = boost::math::constants::pi<Real>();
const Real epsilon = std::numeric_limits<Real>::epsilon();

double to_double(const Real& x) { return x.convert_to<double>(); }

DoubleDouble double_double(const Real& x) {
    const double hi = to_double(x);
    return {hi, std::isfinite(hi) ? to_double(x - Real(hi)) : 0.0};
}

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

// The modulus with what belongs to it; K is infinite on the separatrix, K' where β = 0.
struct Modulus {
    Real k_prime;
    Real K = 0, K_prime = 0;  // 0 stands for infinite
    Real nome = 0;            // of the series in use
    bool hyperbolic = false;

    explicit Modulus(const Cubic& c) {
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

    Real argument_per_u() const { return pi / (2 * (hyperbolic ? K_prime : K)); }
};

// The series of one factor whose θ1 has its zero at i v; returns the rate of the phase of θ2 per
// unit u at its centre.
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

// The phase of the nutation at the start: the nearer turning point and the distance from it in u.
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

int sign_of(const Real& x) { return x < 0 ? -1 : 1; }

}  // namespace

// Fills a HeavyTop; a struct so that it may be a friend.
struct TopSetup {
    HeavyTop& top;
    Cubic cubic{};
    Real half_spin = 0;           // (ω3 − a)/2
    Real angle_rate[2] = {0, 0};  // mean rates of φ+ψ and φ−ψ
    Real lambda = 0, quarter = 0;

    explicit TopSetup(HeavyTop& filled) : top(filled) {}

    void solve(const TopAtStart& given) {
        TopSeries& series = top.series_;
        series.reversed = given.mgl < 0;
        const TopAtStart start = series.reversed ? reversed(given) : given;
        cubic = solve_cubic(start);
        half_spin = (start.omega3 - cubic.a) / 2;
        if (cubic.steady) {
            fill_steady(series);
        } else {
            fill_nutating(series);
        }
        fill_public(given);
        top.start_[0] = {to_double(given.qw), to_double(given.qz)};
        top.start_[1] = {to_double(given.qx), to_double(given.qy)};
        top.fit_start({to_double(given.omega1), to_double(given.omega2)});
    }

    void set_rate(TopFactor& factor, int which, const Real& regular) {
        const Real rate = regular + (which == 0 ? half_spin : Real(-half_spin));
        factor.regular_rate_1_s = to_double(regular);
        factor.rate_1_s = double_double(rate);
        angle_rate[which] = 2 * rate;
        if (factor.zero) angle_rate[which] = 0;
    }

    void fill_steady(TopSeries& series) {
        series.steady = true;
        const Real squares[2] = {cubic.y0, cubic.x0};
        const Real constants[2] = {cubic.e, cubic.d};
        for (int which = 0; which < 2; ++which) {
            TopFactor& factor = series.factor[which];
            factor.zero = squares[which] == 0;
            factor.lower_amplitude = to_double(sqrt(squares[which]));
            factor.theta1_re[0] = 1.0;
            set_rate(factor, which,
                     factor.zero ? Real(0) : Real(constants[which] / (2 * squares[which])));
        }
    }

    void fill_nutating(TopSeries& series) {
        using boost::math::ellint_rf;
        const Cubic& c = cubic;
        const Modulus m(c);
        const Real top_value = c.beta * c.x1 + c.G;
        lambda = sqrt(top_value) / 2;
        quarter = m.K;
        const auto [quarter_start, u_start] = starting_phase(c, m);

        series.hyperbolic = m.hyperbolic;
        series.nome = to_double(m.nome);
        series.scaled = m.hyperbolic && series.nome < 1e-36;
        series.n_terms = series.scaled ? 1 : TopFactor::max_terms;
        series.lambda_1_s = double_double(lambda);
        series.quarter_u = m.K == 0 ? DoubleDouble{std::numeric_limits<double>::infinity(), 0.0}
                                    : double_double(m.K);
        series.quarter_start = quarter_start;
        series.u_start = double_double(u_start);
        series.argument_per_u = to_double(m.argument_per_u());

        // The zeros of 2 − x and of x lie at u = i v1 and K + i v2.
        const Real v1 = sqrt(c.y1 / c.y2) *
                        ellint_rf(Real(c.delta / c.y2),
                                  Real(c.delta * (2 * c.beta + c.G) / (top_value * c.y2)), Real(1));
        Real v2 = 0;
        if (c.x2 > 0 || (c.d == 0 && c.X > 0)) {
            const Real denominator = c.x1 * (c.X + c.G);
            v2 = sqrt(c.x2 * top_value / denominator) *
                 ellint_rf(Real(c.G * c.delta / denominator), Real(c.delta / c.x1), Real(1));
        }

        const Real slope1 = fill_series(m, v1, sign_of(c.e), series.factor[0]);
        const Real slope2 = fill_series(m, v2, sign_of(c.d), series.factor[1]);
        series.factor[0].through_zero = v1 == 0;
        series.factor[1].through_zero = v2 == 0;
        set_rate(series.factor[0], 0, c.e / (2 * c.y2) - lambda * slope1);
        set_rate(series.factor[1], 1, c.d / (2 * c.x1) - lambda * slope2);
        if (m.K != 0) {
            for (int which = 0; which < 2; ++which) {
                const TopFactor& factor = series.factor[which];
                if (!factor.through_zero) angle_rate[which] += factor.winding * pi * lambda / m.K;
            }
        }
        // By symmetry a vanishing constant leaves no mean rate but that of the spin.
        if (c.e == 0) angle_rate[0] = 2 * half_spin;
        if (c.d == 0) angle_rate[1] = -2 * half_spin;

        const Real root_k_prime = sqrt(m.k_prime);
        series.factor[0].lower_amplitude = to_double(sqrt(c.y2));
        series.factor[0].upper_amplitude[0] = to_double(sqrt(c.y2));
        if (m.hyperbolic) {
            series.factor[1].lower_amplitude = to_double(sqrt(c.x1));
            series.factor[1].upper_amplitude[0] = to_double(sqrt(c.x1) * root_k_prime);
            series.factor[1].upper_amplitude[1] = to_double(root_k_prime);
        } else {
            series.factor[1].lower_amplitude = to_double(sqrt(c.x1) * root_k_prime);
            series.factor[1].upper_amplitude[0] = series.factor[1].lower_amplitude;
        }
    }

    // θ of an end of the nutation from x and y = 2 − x.
    static double angle_of(const Real& x, const Real& y) {
        return to_double(2 * atan2(sqrt(x), sqrt(y)));
    }

    void fill_public(const TopAtStart& given) {
        const bool back = top.series_.reversed;
        top.moment_transverse_ = to_double(given.A);
        top.moment_axial_ = to_double(given.C);
        top.mgl_ = to_double(given.mgl);
        top.omega3_ = to_double(given.omega3);

        // Upright and reversed constants: d + a x = e' − a' y' and so on.
        const Real d = back ? cubic.e : cubic.d;
        const Real a = back ? Real(-cubic.a) : cubic.a;
        top.p_phi_minus_p_psi_ = to_double(given.A * d);
        top.invariants_.p_phi_kg_m2_s = to_double(given.A * (d + a));
        top.invariants_.p_psi_kg_m2_s = to_double(given.C * given.omega3);
        const Real x0 = back ? cubic.y0 : cubic.x0;
        const Real transverse = square(given.omega1) + square(given.omega2);
        top.invariants_.energy_J = to_double(
            (given.A * transverse + given.C * square(given.omega3)) / 2 + given.mgl * (1 - x0));

        // φ+ψ and φ−ψ at the start.
        const double alpha = to_double(2 * atan2(given.qz, given.qw));
        const double beta = to_double(2 * atan2(given.qy, given.qx));
        top.angle_start_[0] = given.qw == 0 && given.qz == 0 ? 0.0 : alpha;
        top.angle_start_[1] = given.qx == 0 && given.qy == 0 ? 0.0 : beta;

        TopNutation& nutation = top.nutation_;
        nutation.theta_min_rad = back ? angle_of(cubic.y1, cubic.x1) : angle_of(cubic.x2, cubic.y2);
        nutation.theta_max_rad = back ? angle_of(cubic.y2, cubic.x2) : angle_of(cubic.x1, cubic.y1);
        if (cubic.steady) {
            // Small nutation about steady motion: x'' = 2 P2 (x − x0) to first order.
            const Real stiffness = -cubic.p2;
            const bool moves = cubic.x0 > 0 && cubic.y0 > 0 && stiffness > 0;
            nutation.period_s = moves ? to_double(2 * pi / sqrt(stiffness)) : 0.0;
        } else {
            nutation.period_s = quarter == 0 ? std::numeric_limits<double>::infinity()
                                             : to_double(2 * quarter / lambda);
        }
        const Real sum = back ? angle_rate[1] : angle_rate[0];
        const Real difference = back ? angle_rate[0] : angle_rate[1];
        nutation.precession_rate_rad_s = to_double((sum + difference) / 2);
        nutation.spin_rate_rad_s = to_double((sum - difference) / 2);
        top.regime_ = classify();
    }

    // Names the motion. What rounding of the input decides is decided to 1e-12.
    TopRegime classify() const {
        const Cubic& c = cubic;
        const Real tolerance = 1e-12;
        if (c.beta == 0) return TopRegime::no_gravity;
        if (c.steady && c.x0 == 0) {
            return c.unstable ? TopRegime::sleeping_unstable : TopRegime::sleeping;
        }
        if (c.steady && c.y0 == 0) return TopRegime::hanging;
        if (!c.steady && c.X + c.G == 0) return TopRegime::separatrix;
        if (c.a == 0 && c.d == 0) return TopRegime::planar_pendulum;
        if (c.steady || c.delta < tolerance * c.x1 * c.y2) {
            // The two precessions of this θ have the product β/(2 cos θ); without a real second
            // one, below the horizontal, the one with the sense of slow precession has φ' a > 0.
            const Real cosine = (c.y0 - c.x0) / 2;
            const Real precession = (c.d + c.a * c.x0) / (c.x0 * c.y0);
            const bool slow = 2 * square(precession) * abs(cosine) <= c.beta;
            return slow ? TopRegime::steady_slow : TopRegime::steady_fast;
        }
        if (c.x2 == 0 || c.y1 == 0) return TopRegime::through_vertical;
        const Real at_upper = c.d + c.a * c.x2;
        const Real at_lower = c.d + c.a * c.x1;
        if (abs(at_upper) <= tolerance * (abs(c.d) + abs(c.a) * c.x2)) return TopRegime::cusp;
        return sign_of(at_upper) == sign_of(at_lower) ? TopRegime::wavy : TopRegime::looping;
    }
};

namespace {

void require_finite(double value, const char* what) {
    if (!std::isfinite(value)) {
        throw InputError(fmt::format("heavy top: {} is {}; give a finite number", what, value));
    }
}

void require_moment(double value, const char* what) {
    require_finite(value, what);
    if (value <= 0.0) {
        throw InputError(
            fmt::format("heavy top: {} is {}; a moment of inertia must be positive", what, value));
    }
}

TopAtStart start_from_angles(double A, double C, double mgl, const TopStart& given) {
    const Real half = Real(given.theta_rad) / 2;
    const Real cosine = cos(half);
    const Real sine = sin(half);
    return {A,
            C,
            mgl,
            cosine,
            sine,
            0,
            0,
            given.theta_dot_rad_s,
            2 * sine * cosine * given.phi_dot_rad_s,
            given.omega3_rad_s};
}

// The axis that the arm lies along, with its sense, if the body is symmetric about it.
struct Symmetry {
    bool found = false;
    int axis = 2;
    double sense = 1.0;
    Eigen::Quaterniond principal_from_top = Eigen::Quaterniond::Identity();
};

// The rotation that takes e3 to the axis of this number by a cyclic permutation.
Eigen::Quaterniond cyclic_permutation(int axis) {
    if (axis == 2) return Eigen::Quaterniond::Identity();
    return axis == 0 ? Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5)
                     : Eigen::Quaterniond(0.5, -0.5, -0.5, -0.5);
}

// The shortest rotation that takes e3 to a unit vector: 1 + (e3·v) and e3 × v, normalised.
Eigen::Quaterniond shortest_rotation_from_e3(const Eigen::Vector3d& v) {
    const double across = std::hypot(v[0], v[1]);
    const double half = 0.5 * std::atan2(across, v[2]);
    const double scale = across > 0.0 ? std::sin(half) / across : 0.0;
    return {std::cos(half), -scale * v[1], scale * v[0], 0.0};
}

Symmetry symmetry_of(const InertiaTensor& inertia, const Eigen::Vector3d& arm_body) {
    const Eigen::Vector3d& moments = inertia.moments_kg_m2();
    const Eigen::Vector3d arm = inertia.body_from_principal().transpose() * arm_body.normalized();
    constexpr double alignment = 8.0 * std::numeric_limits<double>::epsilon();
    for (int axis = 2; axis >= 0; --axis) {
        const int next = (axis + 1) % 3;
        const int last = (axis + 2) % 3;
        const bool aligned = std::hypot(arm[next], arm[last]) <= alignment;
        if (aligned && moments[next] == moments[last]) {
            return {true, axis, arm[axis] < 0.0 ? -1.0 : 1.0, cyclic_permutation(axis)};
        }
    }
    if (moments[0] == moments[1] && moments[1] == moments[2]) {
        return {true, 2, 1.0, shortest_rotation_from_e3(arm)};
    }
    return {};
}

}  // namespace

HeavyTop::HeavyTop(const HeavyTopProblem& problem) {
    require_moment(problem.moment_transverse_kg_m2, "the moment about e1 and e2");
    require_moment(problem.moment_axial_kg_m2, "the moment about e3");
    require_finite(problem.mgl_N_m, "mgl_N_m");
    require_finite(problem.theta_rad, "theta_rad");
    require_finite(problem.theta_dot_rad_s, "theta_dot_rad_s");
    require_finite(problem.phi_dot_rad_s, "phi_dot_rad_s");
    require_finite(problem.omega3_rad_s, "omega3_rad_s");
    TopSetup(*this).solve(start_from_angles(
        problem.moment_transverse_kg_m2, problem.moment_axial_kg_m2, problem.mgl_N_m,
        {problem.theta_rad, problem.theta_dot_rad_s, problem.phi_dot_rad_s, problem.omega3_rad_s}));
}

HeavyTop::HeavyTop(const InertiaTensor& inertia, const GravityTorque& gravity,
                   const RotationState& start, const std::optional<TopStart>& unrounded) {
    const Symmetry symmetry = symmetry_of(inertia, gravity.arm_body);
    if (!symmetry.found) {
        throw InputError(
            "a heavy top has an exact solution only if two principal moments are equal and the "
            "centre of mass lies on the third axis; choose a stepping method");
    }
    const Eigen::Quaterniond body_from_principal(inertia.body_from_principal());
    body_from_top_ = inertia.body_axes_are_principal()
                         ? symmetry.principal_from_top
                         : body_from_principal * symmetry.principal_from_top;

    if (!start.omega_body.allFinite() || !start.space_from_body.coeffs().allFinite() ||
        start.space_from_body.coeffs().isZero(0.0)) {
        throw InputError(
            "the start of a heavy top must be finite, with an attitude other than zero");
    }
    require_finite(gravity.mgl_N_m, "mgl_N_m");
    start_time_s_ = start.time_s;
    const double transverse = inertia.moments_kg_m2()[(symmetry.axis + 1) % 3];
    const double axial = inertia.moments_kg_m2()[symmetry.axis];
    const double mgl = symmetry.sense * gravity.mgl_N_m;
    const bool about_e3 = inertia.body_axes_are_principal() && symmetry.axis == 2 &&
                          symmetry.principal_from_top.w() == 1.0;
    if (unrounded && about_e3) {
        TopSetup(*this).solve(start_from_angles(transverse, axial, mgl, *unrounded));
        return;
    }
    const Eigen::Quaterniond q = start.space_from_body * body_from_top_;
    const Eigen::Vector3d omega = body_from_top_.conjugate() * start.omega_body;
    const Real norm =
        sqrt(square(Real(q.w())) + square(Real(q.x())) + square(Real(q.y())) + square(Real(q.z())));
    TopSetup(*this).solve({transverse, axial, mgl, q.w() / norm, q.x() / norm, q.y() / norm,
                           q.z() / norm, omega[0], omega[1], omega[2]});
}

bool HeavyTop::accepts(const InertiaTensor& inertia, const GravityTorque& gravity) {
    return symmetry_of(inertia, gravity.arm_body).found;
}

}  // namespace poinsot
