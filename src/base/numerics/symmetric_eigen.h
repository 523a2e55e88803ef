// Principal axes of a symmetric 3×3 tensor in wide double-double, whatever the sizes of its
// elements. The input doubles count as exact.
#pragma once

#include <Eigen/Core>
#include <array>

#include "numerics/wide_double.h"

namespace poinsot {

using TensorDD = std::array<std::array<DoubleDouble, 3>, 3>;

struct SymmetricEigen {
    std::array<WideDouble, 3> values;                       // value i belongs to column i
    Eigen::Matrix3d vectors = Eigen::Matrix3d::Identity();  // columns; determinant +1
};

// Computes eigenvalues and eigenvectors by Jacobi rotations. Of the 24 proper arrangements of the
// axes, it returns the one nearest to the identity. Eigenvalues that agree within
// repeated_tolerance · (largest magnitude) become one repeated value, and their axes are turned as
// near as possible to the input's; not so two that are much smaller than the third, if rounding the
// elements by such a tolerance would leave them apart. Of a positive definite tensor small
// eigenvalues keep their digits where the tensor, scaled to a unit diagonal, has them (Demmel &
// Veselić, SIAM J. Matrix Anal. Appl. 13 (1992) 1204). Precondition: the elements are finite.
// Units: those of the tensor. Source: Golub & Van Loan, Matrix Computations §8.5.
SymmetricEigen symmetric_eigen(const TensorDD& tensor, double repeated_tolerance);

}  // namespace poinsot
