// The series of Moser and Veselov's preprocessed algorithm.
#pragma once

#include <Eigen/Core>

namespace poinsot {

// Functions of the two invariants by which dmv preprocesses the moments: 1/Ĩ = (1+s)/I + d with s =
// Σ s[k] h^{2k+2}, d = Σ d[k] h^{2k+2}; k = 0…3. momentum and moments in principal axes.
struct MoserVeselovSeries {
    double s[4] = {0.0, 0.0, 0.0, 0.0};
    double d[4] = {0.0, 0.0, 0.0, 0.0};
};
MoserVeselovSeries moser_veselov_series(const Eigen::Vector3d& moments,
                                        const Eigen::Vector3d& momentum);

}  // namespace poinsot
