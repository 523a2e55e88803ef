// Principal axes of a symmetric 3×3 tensor in double-double. The input doubles count as exact.
#pragma once

#include <Eigen/Core>
#include <array>

#include "numerics/double_double.h"

namespace poinsot {

using TensorDD = std::array<std::array<DoubleDouble, 3>, 3>;

struct SymmetricEigen {
    std::array<DoubleDouble, 3> values;                     // value i belongs to column i
    Eigen::Matrix3d vectors = Eigen::Matrix3d::Identity();  // columns; determinant +1
};

// Computes eigenvalues and eigenvectors by Jacobi rotations. Of the 24 proper arrangements of the
// axes, it returns the one nearest to the identity. Eigenvalues that agree within
// repeated_tolerance · (largest magnitude) become one repeated value, and their axes are turned as
// near as possible to the input's. Units: those of the tensor. Source: Golub & Van Loan, Matrix
// Computations §8.5.
SymmetricEigen symmetric_eigen(const TensorDD& tensor, double repeated_tolerance);

}  // namespace poinsot
