#include "mechanics/inertia.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "error/error.h"
#include "numerics/symmetric_eigen.h"

namespace poinsot {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

double ulp(double x) {
    return std::nextafter(std::abs(x), std::numeric_limits<double>::infinity()) - std::abs(x);
}

// Index of the largest moment, and the others.
struct Ranks {
    int high = 2;
    int one = 0;
    int other = 1;
};

Ranks ranks(const Eigen::Vector3d& I) {
    Ranks r;
    I.maxCoeff(&r.high);
    r.one = r.high == 0 ? 1 : 0;
    r.other = 3 - r.high - r.one;
    return r;
}

// I_one + I_other − I_high over 4, free of overflow; exact but for one rounding.
double quarter_of_triangle_slack(const Eigen::Vector3d& I, const Ranks& r) {
    const DoubleDouble sum = two_sum(0.25 * I[r.one], 0.25 * I[r.other]);
    return (sum - DoubleDouble(0.25 * I[r.high])).rounded();
}

// Throws for moments that no mass distribution has; returns whether they are a lamina's.
bool check_triangle(const Eigen::Vector3d& I, Physicality physicality, double n_ulps,
                    std::string_view what) {
    const Ranks r = ranks(I);
    const double slack = quarter_of_triangle_slack(I, r);
    const double margin = 0.25 * n_ulps * ulp(I[r.high]);
    if (std::abs(slack) <= margin) return true;
    if (slack > 0.0 || physicality == Physicality::waived) return false;
    throw InputError(
        fmt::format("{}: no distribution of mass has the moments {}, {}, {}, since I{} + I{} - I{} "
                    "= 2 times the integral of x{}^2 dm is never negative (here {:.6g}); make I{} "
                    "at most {}, I{} at least {:.12g} or I{} at least {:.12g}, or set "
                    "allow_unphysical = true to compute with them anyway",
                    what, I[0], I[1], I[2], r.one + 1, r.other + 1, r.high + 1, r.high + 1,
                    4.0 * slack, r.high + 1, I[r.one] + I[r.other], r.one + 1,
                    I[r.high] - I[r.other], r.other + 1, I[r.high] - I[r.one]));
}

void check_finite(const Eigen::Matrix3d& tensor) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            if (std::isfinite(tensor(i, j))) continue;
            throw InputError(
                fmt::format("tensor_kg_m2[{}][{}] = {}: an element of the inertia tensor must be a "
                            "finite number",
                            i, j, tensor(i, j)));
        }
    }
}

// The symmetric part in double-double. Elements of a tensor that was computed (R diag(I) Rᵀ, a sum
// over masses) differ by roundings of the largest one, however small they are: this is noted, and
// more is refused.
TensorDD symmetric_part(const Eigen::Matrix3d& tensor, std::string& note) {
    constexpr double most_asymmetry = 1e-12;
    const double largest = tensor.cwiseAbs().maxCoeff();
    TensorDD symmetric;
    double worst = 0.0;
    for (int i = 0; i < 3; ++i) {
        symmetric[i][i] = tensor(i, i);
        for (int j = 0; j < i; ++j) {
            const double x = tensor(i, j);
            const double y = tensor(j, i);
            symmetric[i][j] = symmetric[j][i] = x;
            if (x == y) continue;
            symmetric[i][j] = symmetric[j][i] = two_sum(0.5 * x, 0.5 * y);
            const double asymmetry = std::abs(0.5 * x - 0.5 * y) / (0.5 * largest);
            if (!(asymmetry <= most_asymmetry)) {
                throw InputError(fmt::format(
                    "tensor_kg_m2 is not symmetric: [{0}][{1}] = {2} but [{1}][{0}] = {3}; an "
                    "inertia tensor is symmetric, so give both the same value",
                    j, i, y, x));
            }
            worst = std::max(worst, asymmetry);
        }
    }
    if (worst > 0.0)
        note = fmt::format("asymmetry of {:.1g} of its largest element averaged away", worst);
    return symmetric;
}

// A principal moment in double. Throws InputError if it has no double.
double moment_of(const WideDouble& value, int i) {
    const double moment = value.rounded();
    if (moment > 0.0 && std::isfinite(moment)) return moment;
    throw InputError(
        fmt::format("tensor_kg_m2: its principal moment I{} lies beyond the range of "
                    "double-precision numbers; choose other units",
                    i + 1));
}

}  // namespace

InertiaTensor InertiaTensor::from_principal_moments(const Eigen::Vector3d& moments_kg_m2,
                                                    Physicality physicality) {
    for (int i = 0; i < 3; ++i) {
        const double I = moments_kg_m2[i];
        if (!std::isfinite(I)) {
            throw InputError(fmt::format(
                "moments_kg_m2[{}] (I{}) = {}: a principal moment must be a finite number", i,
                i + 1, I));
        }
        if (!(I > 0.0)) {
            throw InputError(
                fmt::format("moments_kg_m2[{}] (I{}) = {}: a principal moment must be positive, as "
                            "it is a sum of m r^2",
                            i, i + 1, I));
        }
    }
    InertiaTensor inertia;
    inertia.planar_ = check_triangle(moments_kg_m2, physicality, 4.0, "moments_kg_m2");
    inertia.moments_kg_m2_ = moments_kg_m2;
    return inertia;
}

InertiaTensor InertiaTensor::from_principal_axes(const Eigen::Vector3d& moments_kg_m2,
                                                 const Eigen::Matrix3d& body_from_principal,
                                                 Physicality physicality) {
    InertiaTensor inertia = from_principal_moments(moments_kg_m2, physicality);
    const double defect =
        (body_from_principal.transpose() * body_from_principal - Eigen::Matrix3d::Identity())
            .cwiseAbs()
            .maxCoeff();
    if (!(defect <= 1e-12) || !(body_from_principal.determinant() > 0.0)) {
        throw InputError(
            "body_from_principal is not a proper rotation: its columns must be orthonormal and "
            "right-handed");
    }
    inertia.body_from_principal_ = body_from_principal;
    inertia.body_axes_are_principal_ = body_from_principal.isIdentity(0.0);
    return inertia;
}

InertiaTensor InertiaTensor::from_matrix(const Eigen::Matrix3d& tensor_kg_m2_body,
                                         Physicality physicality) {
    check_finite(tensor_kg_m2_body);
    std::string note;
    const TensorDD symmetric = symmetric_part(tensor_kg_m2_body, note);
    const bool is_diagonal =
        symmetric[0][1].hi == 0.0 && symmetric[0][2].hi == 0.0 && symmetric[1][2].hi == 0.0;

    // Rounding a tensor's elements moves its eigenvalues by a few ulp; closer ones are repeated.
    const SymmetricEigen eigen = symmetric_eigen(symmetric, is_diagonal ? 0.0 : 4.0 * epsilon);
    const auto& [first, second, third] = eigen.values;
    if (std::min({first, second, third}).sign() <= 0) {
        throw InputError(
            fmt::format("tensor_kg_m2 is not positive definite: its eigenvalues (principal "
                        "moments) are {}, {}, {}; each must be positive, as it is a sum of m r^2",
                        first.rounded(), second.rounded(), third.rounded()));
    }
    Eigen::Vector3d moments;
    for (int i = 0; i < 3; ++i) moments[i] = moment_of(eigen.values[i], i);

    InertiaTensor inertia;
    if (is_diagonal) moments = tensor_kg_m2_body.diagonal();
    // Three eigenvalues, each moved by the rounding of nine elements.
    inertia.planar_ =
        check_triangle(moments, physicality, is_diagonal ? 4.0 : 16.0, "tensor_kg_m2");
    inertia.moments_kg_m2_ = moments;
    inertia.body_from_principal_ = eigen.vectors;
    inertia.body_axes_are_principal_ = eigen.vectors.isIdentity(0.0);
    inertia.note_ = note;
    return inertia;
}

Eigen::Matrix3d InertiaTensor::matrix_body() const {
    if (body_axes_are_principal_) return moments_kg_m2_.asDiagonal();
    return body_from_principal_ * moments_kg_m2_.asDiagonal() * body_from_principal_.transpose();
}

}  // namespace poinsot
