// Principal axes of a symmetric 3×3 tensor in double-double, so that its doubles are taken as
// exact.
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

// Eigenvalues and eigenvectors by Jacobi's rotations. Of the axes' 24 proper arrangements the one
// nearest the identity is returned; eigenvalues that agree within repeated_tolerance · (largest
// magnitude) are taken as one value, and their axes are turned to be nearest the input's.
// Units: those of the tensor. Source: Golub & Van Loan, Matrix Computations §8.5.
SymmetricEigen symmetric_eigen(const TensorDD& tensor, double repeated_tolerance);

}  // namespace poinsot
