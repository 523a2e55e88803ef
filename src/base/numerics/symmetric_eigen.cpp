#include "numerics/symmetric_eigen.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace poinsot {

namespace {

// One Jacobi rotation in the plane (p, q), by the smaller angle, that makes a[p][q] zero.
void rotate(TensorDD& a, TensorDD& v, int p, int q) {
    if (a[p][q].hi == 0.0) return;
    const DoubleDouble theta = (a[q][q] - a[p][p]) / (a[p][q] * 2.0);
    const DoubleDouble size = abs(theta);
    // Beyond 2^500 the square would overflow; t = 1/(2θ) is then exact to all digits.
    DoubleDouble t = size.hi > 0x1p500 ? DoubleDouble(0.5) / size
                                       : DoubleDouble(1.0) / (size + sqrt(size * size + 1.0));
    if (theta.hi < 0.0) t = -t;
    const DoubleDouble c = DoubleDouble(1.0) / sqrt(t * t + 1.0);
    const DoubleDouble s = t * c;
    const DoubleDouble apq = a[p][q];
    a[p][p] = a[p][p] - t * apq;
    a[q][q] = a[q][q] + t * apq;
    a[p][q] = a[q][p] = 0.0;
    const int r = 3 - p - q;
    const DoubleDouble arp = a[r][p];
    const DoubleDouble arq = a[r][q];
    a[r][p] = a[p][r] = c * arp - s * arq;
    a[r][q] = a[q][r] = s * arp + c * arq;
    for (auto& row : v) {
        const DoubleDouble x = row[p];
        const DoubleDouble y = row[q];
        row[p] = c * x - s * y;
        row[q] = s * x + c * y;
    }
}

// True once the off-diagonal elements are below the rounding of double-double.
bool diagonal(const TensorDD& a) {
    for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
        const double off = std::abs(a[p][q].hi);
        const double least = std::min(std::abs(a[p][p].hi), std::abs(a[q][q].hi));
        const double most =
            std::max({std::abs(a[0][0].hi), std::abs(a[1][1].hi), std::abs(a[2][2].hi)});
        if (off > 0x1p-104 * least && off > 0x1p-140 * most) return false;
    }
    return true;
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

// The axes of a repeated eigenvalue are not unique: turns them in their plane as near as possible
// to the input's.
void turn_repeated(SymmetricEigen& eigen, double tolerance) {
    const auto close = [&](int i, int j) {
        return std::abs((eigen.values[i] - eigen.values[j]).hi) <= tolerance;
    };
    const int n_pairs = int{close(0, 1)} + int{close(1, 2)} + int{close(0, 2)};
    if (n_pairs >= 2) {
        const DoubleDouble mean =
            (eigen.values[0] + eigen.values[1] + eigen.values[2]) / DoubleDouble(3.0);
        eigen.values = {mean.rounded(), mean.rounded(), mean.rounded()};
        eigen.vectors.setIdentity();
        return;
    }
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (!close(i, j)) continue;
        const double mean = ((eigen.values[i] + eigen.values[j]) * 0.5).rounded();
        eigen.values[i] = eigen.values[j] = mean;
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
    TensorDD a = tensor;
    TensorDD v{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    // Convergence is quadratic: a few sweeps reach the rounding of double-double.
    for (int sweep = 0; sweep < 40 && !diagonal(a); ++sweep) {
        rotate(a, v, 0, 1);
        rotate(a, v, 0, 2);
        rotate(a, v, 1, 2);
    }

    SymmetricEigen eigen;
    double most = 0.0;
    for (int i = 0; i < 3; ++i) {
        eigen.values[i] = a[i][i];
        most = std::max(most, std::abs(a[i][i].hi));
        for (int j = 0; j < 3; ++j) eigen.vectors(i, j) = v[i][j].rounded();
    }
    arrange_nearest_identity(eigen);
    turn_repeated(eigen, repeated_tolerance * most);
    return eigen;
}

}  // namespace poinsot
