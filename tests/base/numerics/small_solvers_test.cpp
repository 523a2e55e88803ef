#include "numerics/small_solvers.h"

#include <gtest/gtest.h>

namespace poinsot {

namespace {

// A = M Mᵀ of any M is symmetric without negative eigenvalues.
TEST(SmallSolvers, PairsAndSolutionsSatisfyTheirEquations) {
    for (Eigen::Index n = 1; n <= 11; ++n) {
        const Eigen::MatrixXd M = Eigen::MatrixXd::Random(n, n);
        const Eigen::MatrixXd A = M * M.transpose();
        const auto [values, vectors] = eigenpairs_of(A);
        EXPECT_LT((A * vectors - vectors * values.asDiagonal()).norm(), 1e-13 * A.norm()) << n;
        EXPECT_LT((vectors.transpose() * vectors - Eigen::MatrixXd::Identity(n, n)).norm(), 1e-13);
        for (Eigen::Index k = 1; k < n; ++k) EXPECT_LE(values[k - 1], values[k]);
        const Eigen::MatrixXd b = Eigen::MatrixXd::Random(n, 3);
        const Eigen::MatrixXd x = solved(A, b);
        EXPECT_LT((A * x - b).norm(), 1e-12 * (A.norm() * x.norm() + b.norm())) << n;
    }
}

}  // namespace

}  // namespace poinsot
