#include "numerics/symmetric_eigen.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace poinsot {

namespace {

using WideTensor = std::array<std::array<WideDouble, 3>, 3>;

constexpr std::pair<int, int> planes[] = {{0, 1}, {0, 2}, {1, 2}};

// One Jacobi rotation in the plane (p, q), by the smaller angle, that makes a[p][q] zero.
void rotate(WideTensor& a, WideTensor& v, int p, int q) {
    if (a[p][q].is_zero()) return;
    const WideDouble theta = (a[q][q] - a[p][p]) / ldexp(a[p][q], 1);
    const WideDouble size = abs(theta);
    WideDouble t = WideDouble(1.0) / (size + sqrt(square(size) + 1.0));
    if (theta.sign() < 0) t = -t;
    const WideDouble c = WideDouble(1.0) / sqrt(square(t) + 1.0);
    const WideDouble s = t * c;
    const WideDouble apq = a[p][q];
    a[p][p] = a[p][p] - t * apq;
    a[q][q] = a[q][q] + t * apq;
    a[p][q] = a[q][p] = 0.0;
    const int r = 3 - p - q;
    const WideDouble arp = a[r][p];
    const WideDouble arq = a[r][q];
    a[r][p] = a[p][r] = c * arp - s * arq;
    a[r][q] = a[q][r] = s * arp + c * arq;
    for (auto& row : v) {
        const WideDouble x = row[p];
        const WideDouble y = row[q];
        row[p] = c * x - s * y;
        row[q] = s * x + c * y;
    }
}

WideDouble greatest_on_diagonal(const WideTensor& a) {
    return std::max({abs(a[0][0]), abs(a[1][1]), abs(a[2][2])});
}

// True once the off-diagonal elements are below the rounding of double-double, or so small that no
// double beside the greatest is.
bool diagonal(const WideTensor& a) {
    constexpr int rounding = -104, ratio_of_doubles = -2200;
    const WideDouble negligible = ldexp(greatest_on_diagonal(a), ratio_of_doubles);
    return std::all_of(std::begin(planes), std::end(planes), [&](const auto& plane) {
        const auto [p, q] = plane;
        const WideDouble off = abs(a[p][q]);
        return off <= ldexp(std::min(abs(a[p][p]), abs(a[q][q])), rounding) || off <= negligible;
    });
}

// Permutes the columns and chooses their signs so that the trace is largest among proper rotations.
void arrange_nearest_identity(SymmetricEigen& eigen) {
    std::array<int, 3> order{0, 1, 2};
    std::array<int, 3> best_order = order;
    Eigen::Vector3d best_sign = Eigen::Vector3d::Ones();
    double best = -4.0;
    const double orientation = eigen.vectors.determinant() < 0.0 ? -1.0 : 1.0;
    do {
        const bool even = (order[1] - order[0] + 3) % 3 == 1;
        for (int bits = 0; bits < 8; ++bits) {
            const Eigen::Vector3d sign(bits & 1 ? -1.0 : 1.0, bits & 2 ? -1.0 : 1.0,
                                       bits & 4 ? -1.0 : 1.0);
            if (sign.prod() * (even ? 1.0 : -1.0) * orientation < 0.0) continue;
            double trace = 0.0;
            for (int i = 0; i < 3; ++i) trace += sign[i] * eigen.vectors(i, order[i]);
            if (trace > best) {
                best = trace;
                best_order = order;
                best_sign = sign;
            }
        }
    } while (std::next_permutation(order.begin(), order.end()));

    const SymmetricEigen given = eigen;
    for (int i = 0; i < 3; ++i) {
        eigen.values[i] = given.values[best_order[i]];
        eigen.vectors.col(i) = best_sign[i] * given.vectors.col(best_order[i]);
    }
}

// How far the rounding of the tensor's elements moves the eigenvalue of column i, in units of that
// rounding: Σ|v_j||v_k||T_jk|. Of a turned body this is near the largest eigenvalue.
WideDouble sensitivity(const SymmetricEigen& eigen, const TensorDD& tensor, int i) {
    WideDouble sum;
    for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
            sum = sum + abs(WideDouble(tensor[j][k]) * eigen.vectors(j, i) * eigen.vectors(k, i));
    return sum;
}

// The axes of a repeated eigenvalue are not unique: turns them in their plane as near as possible
// to the input's. Where two eigenvalues are much smaller than the third, rounding need not move
// them by as much as their difference, however small that is beside the third.
void turn_repeated(SymmetricEigen& eigen, const TensorDD& tensor, double tolerance) {
    constexpr double margin = 64.0;  // a product R diag(I) Rᵀ is rounded several times
    const auto close = [&](int i, int j) {
        const WideDouble apart = abs(eigen.values[i] - eigen.values[j]);
        if (apart.is_zero()) return true;
        const auto& [first, second, third] = eigen.values;
        const WideDouble most = std::max({abs(first), abs(second), abs(third)});
        return apart <= most * tolerance &&
               apart <= std::max(sensitivity(eigen, tensor, i), sensitivity(eigen, tensor, j)) *
                            (margin * tolerance);
    };
    const int n_pairs = int{close(0, 1)} + int{close(1, 2)} + int{close(0, 2)};
    if (n_pairs >= 2) {
        const WideDouble sum = eigen.values[0] + eigen.values[1] + eigen.values[2];
        eigen.values.fill((sum / 3.0).rounded_to_53_bits());
        eigen.vectors.setIdentity();
        return;
    }
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (!close(i, j)) continue;
        eigen.values[i] = eigen.values[j] =
            ldexp(eigen.values[i] + eigen.values[j], -1).rounded_to_53_bits();
        // Maximises x·e_i + y·e_j over rotations of (x, y) in their plane.
        const Eigen::Vector3d x = eigen.vectors.col(i);
        const Eigen::Vector3d y = eigen.vectors.col(j);
        const double cosine = x[i] + y[j];
        const double sine = y[i] - x[j];
        const double length = std::sqrt(cosine * cosine + sine * sine);
        if (!(length > 0.0)) continue;
        eigen.vectors.col(i) = (cosine * x + sine * y) / length;
        eigen.vectors.col(j) = (cosine * y - sine * x) / length;
    }
}

}  // namespace

SymmetricEigen symmetric_eigen(const TensorDD& tensor, double repeated_tolerance) {
    WideTensor a;
    WideTensor v;
    for (std::size_t i = 0; i < 3; ++i) {
        v[i][i] = 1.0;
        for (std::size_t j = 0; j < 3; ++j) a[i][j] = WideDouble(tensor[i][j]);
    }
    // Convergence is quadratic: a few sweeps reach the rounding of double-double.
    constexpr int most_sweeps = 40;
    for (int sweep = 0; sweep < most_sweeps && !diagonal(a); ++sweep)
        for (const auto& [p, q] : planes) rotate(a, v, p, q);

    SymmetricEigen eigen;
    for (int i = 0; i < 3; ++i) {
        eigen.values[i] = a[i][i];
        for (int j = 0; j < 3; ++j) eigen.vectors(i, j) = v[i][j].rounded() + 0.0;  // no −0
    }
    arrange_nearest_identity(eigen);
    turn_repeated(eigen, tensor, repeated_tolerance);
    return eigen;
}

}  // namespace poinsot
