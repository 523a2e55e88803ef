// Starts of Lagrange's top: angles, or a state of a body that is symmetric about its arm.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "error/error.h"
#include "mechanics/top/heavy_top_setup.h"
#include "numerics/power_of_two.h"
#include "numerics/quaternion_dd.h"
#include "numerics/wide_functions.h"

namespace poinsot {

using namespace top_setup;

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

void require_tilt(double theta_rad) {
    require_finite(theta_rad, "theta_rad");
    if (theta_rad < 0.0 || theta_rad > std::numbers::pi)
        throw InputError(fmt::format("heavy top: theta_rad is {}; give an angle from 0 to {}, π",
                                     theta_rad, std::numbers::pi));
}

TopAtStart start_from_angles(double A, double C, double mgl, const TopStart& given) {
    require_tilt(given.theta_rad);
    require_finite(given.theta_dot_rad_s, "theta_dot_rad_s");
    require_finite(given.phi_dot_rad_s, "phi_dot_rad_s");
    require_finite(given.omega3_rad_s, "omega3_rad_s");
    const WideDouble half = WideDouble(given.theta_rad) / 2;
    const auto [sine, cosine] = sin_cos(half);
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
    given_ = start_of(problem);
    TopSetup(*this).solve(start_from_angles(
        problem.moment_transverse_kg_m2, problem.moment_axial_kg_m2, problem.mgl_N_m,
        {problem.theta_rad, problem.theta_dot_rad_s, problem.phi_dot_rad_s, problem.omega3_rad_s}));
    given_angles_.theta_rad = problem.theta_rad;
    check_momentum(true);
}

HeavyTop::HeavyTop(const InertiaTensor& inertia, const Gravity& gravity, const RotationState& start,
                   const std::optional<TopStart>& unrounded) {
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
    given_ = start;
    const double transverse = inertia.moments_kg_m2()[(symmetry.axis + 1) % 3];
    const double axial = inertia.moments_kg_m2()[symmetry.axis];
    const double mgl = symmetry.sense * gravity.mgl_N_m;
    const bool about_e3 = inertia.body_axes_are_principal() && symmetry.axis == 2 &&
                          symmetry.principal_from_top.w() == 1.0;
    if (unrounded && about_e3) {
        TopSetup(*this).solve(start_from_angles(transverse, axial, mgl, *unrounded));
        given_angles_.theta_rad = unrounded->theta_rad;
        check_momentum(true);
        return;
    }
    given_.space_from_body = rounded(unit(start.space_from_body));
    const Eigen::Quaterniond q = start.space_from_body * body_from_top_;
    const Eigen::Vector3d omega = body_from_top_.conjugate() * start.omega_body;
    if (!omega.allFinite())
        throw InputError(
            "omega_rad_s: the angular velocity in the axes of the top overflows; choose other "
            "units");
    const WideDouble norm = sqrt(square(WideDouble(q.w())) + square(WideDouble(q.x())) +
                                 square(WideDouble(q.y())) + square(WideDouble(q.z())));
    TopSetup(*this).solve({transverse, axial, mgl, q.w() / norm, q.x() / norm, q.y() / norm,
                           q.z() / norm, omega[0], omega[1], omega[2]});
    check_momentum(false);
}

// Throws InputError, by the name of the value that is too large, if L overflows.
void HeavyTop::check_momentum(bool from_angles) const {
    const Eigen::Vector3d omega = body_from_top_.conjugate() * given_.omega_body;
    const Eigen::Vector3d momentum(moment_transverse_ * omega[0], moment_transverse_ * omega[1],
                                   moment_axial_ * omega[2]);
    if (std::isfinite(norm_of(momentum)) && std::isfinite(invariants_.p_phi_kg_m2_s)) return;
    const char* too_large = !from_angles                  ? "omega_rad_s"
                            : !std::isfinite(momentum[2]) ? "omega3_rad_s"
                            : !std::isfinite(momentum[0]) ? "theta_dot_rad_s"
                                                          : "phi_dot_rad_s";
    throw InputError(fmt::format(
        "{}: the angular momentum of the top overflows; choose other units", too_large));
}

bool HeavyTop::accepts(const InertiaTensor& inertia, const Gravity& gravity) {
    return symmetry_of(inertia, gravity.arm_body).found;
}

RotationState start_of(const HeavyTopProblem& problem) {
    require_tilt(problem.theta_rad);
    RotationState state;
    const double half = 0.5 * problem.theta_rad;
    state.space_from_body = Eigen::Quaterniond(std::cos(half), std::sin(half), 0.0, 0.0);
    state.omega_body =
        Eigen::Vector3d(problem.theta_dot_rad_s,
                        problem.phi_dot_rad_s * std::sin(problem.theta_rad), problem.omega3_rad_s);
    return state;
}

}  // namespace poinsot
