// Eigenvalues and linear equations of small symmetric matrices in doubles, compiled once for those
// who need their sizes at run time only.
#pragma once

#include <Eigen/Core>

namespace poinsot {

struct Eigenpairs {
    Eigen::VectorXd values;   // in rising order
    Eigen::MatrixXd vectors;  // columns of length 1, value i belongs to column i
};

// Of a symmetric matrix, of which the lower half is read. Source: tridiagonal form and the QR
// algorithm, Golub & Van Loan, Matrix Computations §8.3.
Eigenpairs eigenpairs_of(const Eigen::MatrixXd& symmetric);

// x of A x = b for each column of b and a symmetric A that has no negative eigenvalue, by its
// factors LDLᵀ (Golub & Van Loan §4.1). A singular A gives one of the solutions, or numbers that
// are not finite.
Eigen::MatrixXd solved(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b);

}  // namespace poinsot
