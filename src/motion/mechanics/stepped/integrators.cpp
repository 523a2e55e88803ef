// The integrators: one function each, named by a row of the table in methods.cpp.
#include <fmt/format.h>

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "error/error.h"
#include "mechanics/methods.h"
#include "mechanics/stepped/fixed_step.h"
#include "mechanics/stepped/friction.h"
#include "mechanics/stepped/moser_veselov_series.h"

namespace poinsot {

namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// q + h·½ q Ω without normalisation: a Runge–Kutta stage in the quaternion's four components.
Quaterniond moved(const Quaterniond& q, const Quaterniond& rate, double h) {
    return Quaterniond(q.coeffs() + h * rate.coeffs());
}

struct StateRate {
    Vector3d momentum;
    Quaterniond attitude;
};

StateRate rate_of(const RotationDynamics& dynamics, const StepState& state,
                  StepCounters& counters) {
    ++counters.n_right_hand_sides;
    counters.n_torques += dynamics.has_torque() ? 1 : 0;
    const RotationRates rates = dynamics.rates(state);
    const Vector3d half = 0.5 * rates.turning;
    return {rates.momentum_rate,
            state.space_from_principal * Quaterniond(0.0, half[0], half[1], half[2])};
}

StepState moved(const StepState& state, const StateRate& rate, double h) {
    return {state.momentum + h * rate.momentum, moved(state.space_from_principal, rate.attitude, h),
            state.time_s + h};
}

// The rotation by |v| about v.
Quaterniond rotation_by(const Vector3d& v) {
    const double square = 0.25 * v.squaredNorm();  // of half the angle
    double cosine = 1.0;
    double sinc = 1.0;  // sin(half)/half
    if (square < 0.25) {
        // Taylor's series, for a step is a small turn: the first term left out is below 1e-18.
        constexpr std::array cosine_factors{1.0 / 182, 1.0 / 132, 1.0 / 90, 1.0 / 56,
                                            1.0 / 30,  1.0 / 12,  1.0 / 2};
        constexpr std::array sinc_factors{1.0 / 210, 1.0 / 156, 1.0 / 110, 1.0 / 72,
                                          1.0 / 42,  1.0 / 20,  1.0 / 6};
        for (std::size_t i = 0; i < cosine_factors.size(); ++i) {
            cosine = 1.0 - square * cosine_factors[i] * cosine;
            sinc = 1.0 - square * sinc_factors[i] * sinc;
        }
    } else {
        const double half = std::sqrt(square);
        cosine = std::cos(half);
        sinc = std::sin(half) / half;
    }
    return {cosine, 0.5 * sinc * v[0], 0.5 * sinc * v[1], 0.5 * sinc * v[2]};
}

// L in space where no torque acts: a method that conserves L takes L from here, not from the step
// before, so that rounding errors do not accumulate.
struct KeptMomentum {
    explicit KeptMomentum(const MethodStart& start)
        : space(start.state.space_from_principal * start.state.momentum),
          kept(!start.dynamics.has_torque()) {}

    // L in the principal axes of this attitude if L is kept; otherwise the given L.
    Vector3d in_axes_of(const Quaterniond& attitude, const Vector3d& otherwise) const {
        return kept ? attitude.conjugate() * space : otherwise;
    }

    Vector3d space;
    bool kept;
};

// Newton's method converges quadratically: a correction this small leaves an error below rounding.
constexpr double last_correction = 1e-9;
constexpr int max_iterations = 25;

[[noreturn]] void refuse_step(const char* method, double step_s) {
    throw InputError(
        fmt::format("method \"{}\" finds no solution for a step of {} s; give a shorter step_s",
                    method, std::abs(step_s)));
}

}  // namespace

Propagator euler(const MethodStart& start) {
    return fixed_step(start, [dynamics = start.dynamics, friction = Friction(start)](
                                 const StepState& state, double h, StepCounters& counters) {
        StepState end = moved(state, rate_of(dynamics, state, counters), h);
        end.space_from_principal.normalize();
        if (!friction.acts()) return end;
        return friction.settled(state, end.space_from_principal,
                                std::abs(h) * friction.decay_1_s(state.momentum));
    });
}

Propagator rk4(const MethodStart& start) {
    return fixed_step(start, [dynamics = start.dynamics, friction = Friction(start)](
                                 const StepState& state, double h, StepCounters& counters) {
        const auto stage = [&](const StateRate& rate, double duration) {
            StepState here = moved(state, rate, duration);
            if (friction.acts()) here.momentum = friction.momentum_at(here.space_from_principal);
            return here;
        };
        const StateRate k1 = rate_of(dynamics, state, counters);
        const StepState second = stage(k1, 0.5 * h);
        const StateRate k2 = rate_of(dynamics, second, counters);
        const StepState third = stage(k2, 0.5 * h);
        const StateRate k3 = rate_of(dynamics, third, counters);
        const StepState fourth = stage(k3, h);
        const StateRate k4 = rate_of(dynamics, fourth, counters);
        StepState end;
        end.momentum =
            state.momentum +
            h / 6.0 * (k1.momentum + 2.0 * k2.momentum + 2.0 * k3.momentum + k4.momentum);
        end.space_from_principal.coeffs() = state.space_from_principal.coeffs() +
                                            h / 6.0 *
                                                (k1.attitude.coeffs() + 2.0 * k2.attitude.coeffs() +
                                                 2.0 * k3.attitude.coeffs() + k4.attitude.coeffs());
        end.space_from_principal.normalize();
        if (!friction.acts()) return end;
        return friction.settled(
            state, end.space_from_principal,
            std::abs(h) / 6.0 *
                (friction.decay_1_s(state.momentum) + 2.0 * friction.decay_1_s(second.momentum) +
                 2.0 * friction.decay_1_s(third.momentum) + friction.decay_1_s(fourth.momentum)));
    });
}

// With q = q0 exp(u), du/dt = dexp⁻¹(Ω) = Ω + ½ u×Ω + u×(u×Ω)/12 + …, to the order of the method.
Propagator rkmk4(const MethodStart& start) {
    return fixed_step(start, [dynamics = start.dynamics, kept = KeptMomentum(start),
                              friction = Friction(start)](const StepState& state, double h,
                                                          StepCounters& counters) {
        const Quaterniond& q0 = state.space_from_principal;
        const Vector3d momentum_space = q0 * state.momentum;
        struct Stage {
            Vector3d turning;
            Vector3d momentum_rate_space;
            double decay_1_s;
        };
        const auto stage = [&](const Vector3d& u, const Vector3d& momentum, double after_s) {
            ++counters.n_right_hand_sides;
            StepState here;
            here.space_from_principal = q0 * rotation_by(u);
            here.momentum = here.space_from_principal.conjugate() * momentum;
            here.time_s = state.time_s + after_s;
            const Vector3d omega = dynamics.rates(here).turning;
            counters.n_torques += kept.kept ? 0 : 2;
            const Vector3d across = u.cross(omega);
            Stage result{omega + 0.5 * across + u.cross(across) / 12.0, Vector3d::Zero(),
                         friction.acts() ? friction.decay_1_s(here.momentum) : 0.0};
            if (!kept.kept) {
                result.momentum_rate_space = here.space_from_principal * dynamics.torque_on(here);
            }
            return result;
        };
        const Stage k1 = stage(Vector3d::Zero(), momentum_space, 0.0);
        const Stage k2 =
            stage(0.5 * h * k1.turning, momentum_space + 0.5 * h * k1.momentum_rate_space, 0.5 * h);
        const Stage k3 =
            stage(0.5 * h * k2.turning, momentum_space + 0.5 * h * k2.momentum_rate_space, 0.5 * h);
        const Stage k4 = stage(h * k3.turning, momentum_space + h * k3.momentum_rate_space, h);
        const Vector3d u =
            h / 6.0 * (k1.turning + 2.0 * k2.turning + 2.0 * k3.turning + k4.turning);
        const Vector3d momentum_end =
            momentum_space + h / 6.0 *
                                 (k1.momentum_rate_space + 2.0 * k2.momentum_rate_space +
                                  2.0 * k3.momentum_rate_space + k4.momentum_rate_space);
        StepState end;
        end.space_from_principal = (q0 * rotation_by(u)).normalized();
        if (friction.acts()) {
            return friction.settled(
                state, end.space_from_principal,
                std::abs(h) / 6.0 *
                    (k1.decay_1_s + 2.0 * k2.decay_1_s + 2.0 * k3.decay_1_s + k4.decay_1_s));
        }
        end.momentum = kept.in_axes_of(end.space_from_principal,
                                       end.space_from_principal.conjugate() * momentum_end);
        return end;
    });
}

// L1 = L0 + h L̄ × ω̄ with L̄ = (L0+L1)/2 and ω̄ = I⁻¹L̄, which conserves the quadratic |L|² and T;
// equivalently L1 is L0 turned back by the Cayley transform of h ω̄, by which the attitude turns
// forward (Austin, Krishnaprasad & Wang, J. Comput. Phys. 107 (1993) 105).
Propagator midpoint(const MethodStart& start) {
    return fixed_step(start, [dynamics = start.dynamics, kept = KeptMomentum(start)](
                                 const StepState& state, double h, StepCounters& counters) {
        const Vector3d inverse = dynamics.moments_kg_m2().cwiseInverse();
        const Vector3d& L0 = state.momentum;
        Vector3d middle = L0;
        Vector3d omega = dynamics.omega(middle);
        bool converged = false;
        for (int i = 0; i < max_iterations && !converged; ++i) {
            ++counters.n_right_hand_sides;
            // Newton's method for middle − L0 − (h/2) middle × ω(middle) = 0.
            const Vector3d residual = middle - L0 - 0.5 * h * middle.cross(omega);
            Eigen::Matrix3d slope;
            slope << 1.0, -0.5 * h * (inverse[2] - inverse[1]) * middle[2],
                -0.5 * h * (inverse[2] - inverse[1]) * middle[1],
                -0.5 * h * (inverse[0] - inverse[2]) * middle[2], 1.0,
                -0.5 * h * (inverse[0] - inverse[2]) * middle[0],
                -0.5 * h * (inverse[1] - inverse[0]) * middle[1],
                -0.5 * h * (inverse[1] - inverse[0]) * middle[0], 1.0;
            const Vector3d correction = slope.inverse() * residual;
            middle -= correction;
            omega = dynamics.omega(middle);
            converged = correction.norm() <= last_correction * middle.norm() || middle.isZero(0.0);
        }
        if (!converged || !middle.allFinite()) refuse_step("midpoint", h);
        const Vector3d half = 0.5 * h * omega;
        const Quaterniond turn = Quaterniond(1.0, half[0], half[1], half[2]).normalized();
        StepState end;
        end.space_from_principal = (state.space_from_principal * turn).normalized();
        end.momentum = kept.in_axes_of(end.space_from_principal, turn.conjugate() * L0);
        return end;
    });
}

// H = Σ L_i²/2I_i: each term alone is a rotation about its axis at the constant rate L_i/I_i
// (McLachlan, Phys. Rev. Lett. 71 (1993) 3043; Reich, Physica D 76 (1994) 375).
Propagator splitting(const MethodStart& start) {
    return fixed_step(start, [dynamics = start.dynamics, kept = KeptMomentum(start)](
                                 const StepState& state, double h, StepCounters& counters) {
        ++counters.n_right_hand_sides;
        const Vector3d& moments = dynamics.moments_kg_m2();
        StepState end = state;
        const auto turn_about = [&](int axis, double duration) {
            const double half = 0.5 * duration * end.momentum[axis] / moments[axis];
            Quaterniond turn(std::cos(half), 0.0, 0.0, 0.0);
            turn.vec()[axis] = std::sin(half);
            end.momentum = turn.conjugate() * end.momentum;
            end.space_from_principal = end.space_from_principal * turn;
        };
        const bool kicked = dynamics.has_torque();
        counters.n_torques += kicked ? 2 : 0;
        if (kicked) end.momentum += 0.5 * h * dynamics.torque_on(end);
        turn_about(0, 0.5 * h);
        turn_about(1, 0.5 * h);
        turn_about(2, h);
        turn_about(1, 0.5 * h);
        turn_about(0, 0.5 * h);
        end.space_from_principal.normalize();
        end.momentum = kept.in_axes_of(end.space_from_principal, end.momentum);
        if (kicked) end.momentum += 0.5 * h * dynamics.torque_on(end);
        return end;
    });
}

// h L/2 = e0 Ĩe + e × Ĩe for the unit quaternion (e0, e) of the step, by Newton's method; then the
// step turns L back and the attitude forward. With 1/Ĩ = (1+s)/I + d the modified equation is the
// true one up to the requested order (Hairer & Vilmart, J. Phys. A 39 (2006) 13225; the step as in
// Lee, Leok & McClamroch, Comput. Methods Appl. Mech. Eng. 196 (2007) 2907).
Propagator dmv(const MethodStart& start) {
    const MoserVeselovSeries series =
        moser_veselov_series(start.dynamics.moments_kg_m2(), start.state.momentum);
    const int n_terms = start.order / 2 - 1;
    return fixed_step(start, [moments = start.dynamics.moments_kg_m2(), kept = KeptMomentum(start),
                              series,
                              n_terms](const StepState& state, double h, StepCounters& counters) {
        double s = 0.0;
        double d = 0.0;
        for (int k = n_terms - 1; k >= 0; --k) {
            s = (s + series.s[k]) * h * h;
            d = (d + series.d[k]) * h * h;
        }
        const Vector3d inverse = (1.0 + s) * moments.cwiseInverse() + Vector3d::Constant(d);
        const Vector3d J = inverse.cwiseInverse();
        const Vector3d target = 0.5 * h * state.momentum;
        Vector3d e = inverse.cwiseProduct(target);
        double e0 = 1.0;
        bool converged = false;
        for (int i = 0; i < max_iterations && !converged; ++i) {
            ++counters.n_right_hand_sides;
            const double square = e.squaredNorm();
            if (!(square < 1.0)) break;
            e0 = std::sqrt(1.0 - square);
            const Vector3d w = J.cwiseProduct(e);
            const Vector3d residual = e0 * w + e.cross(w) - target;
            Eigen::Matrix3d slope = -(w / e0) * e.transpose();
            slope.diagonal() += e0 * J;
            slope(0, 1) += (J[2] - J[1]) * e[2];
            slope(0, 2) += (J[2] - J[1]) * e[1];
            slope(1, 0) += (J[0] - J[2]) * e[2];
            slope(1, 2) += (J[0] - J[2]) * e[0];
            slope(2, 0) += (J[1] - J[0]) * e[1];
            slope(2, 1) += (J[1] - J[0]) * e[0];
            const Vector3d correction = slope.inverse() * residual;
            e -= correction;
            converged = correction.norm() <= last_correction * e.norm() || e.isZero(0.0);
        }
        if (!converged || !(e.squaredNorm() < 1.0)) refuse_step("dmv", h);
        e0 = std::sqrt(1.0 - e.squaredNorm());
        const Quaterniond turn(e0, e[0], e[1], e[2]);
        StepState end;
        end.space_from_principal = (state.space_from_principal * turn).normalized();
        end.momentum = kept.in_axes_of(end.space_from_principal, turn.conjugate() * state.momentum);
        return end;
    });
}

}  // namespace poinsot
