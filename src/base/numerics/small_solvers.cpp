#include "numerics/small_solvers.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace poinsot {

Eigenpairs eigenpairs_of(const Eigen::MatrixXd& symmetric) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::MatrixXd solved(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b) {
    return A.ldlt().solve(b);
}

}  // namespace poinsot
