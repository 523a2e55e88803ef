// Small matrices stored by columns, with the rows in SIMD pairs. A matrix-vector product is a sum
// of columns, and each instruction computes two rows.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>

#include "numerics/double_pair.h"

namespace poinsot {

// A matrix of three rows; its product is a Vector3d.
template <std::size_t n_columns>
class ThreeRows {
 public:
    void set(std::size_t column, const Eigen::Vector3d& v) {
        xy_[column] = Pair{v[0], v[1]};
        z_[column] = v[2];
    }

    // Writes scale·(matrix·x) to out.
    void product(const std::array<double, n_columns>& x, double scale, Eigen::Vector3d& out) const {
        Pair xy = xy_[0] * x[0];
        double z = z_[0] * x[0];
        for (std::size_t k = 1; k < n_columns; ++k) {
            xy += xy_[k] * x[k];
            z += z_[k] * x[k];
        }
        xy *= scale;
        out[0] = xy[0];
        out[1] = xy[1];
        out[2] = z * scale;
    }

 private:
    std::array<Pair, n_columns> xy_{};
    std::array<double, n_columns> z_{};
};

// A 4×4 matrix with rows x, y, z, w and columns w, x, y, z; its product is a quaternion.
class QuaternionRows {
 public:
    void set(std::size_t column, const Eigen::Quaterniond& q) {
        xy_[column] = Pair{q.x(), q.y()};
        zw_[column] = Pair{q.z(), q.w()};
    }

    // Writes scale·(matrix·(w, x, y, z)) to out.
    void product(Pair w_x, Pair y_z, double scale, Eigen::Quaterniond& out) const {
        const Pair w = both(w_x[0]);
        const Pair x = both(w_x[1]);
        const Pair y = both(y_z[0]);
        const Pair z = both(y_z[1]);
        const Pair xy = scale * ((xy_[0] * w + xy_[1] * x) + (xy_[2] * y + xy_[3] * z));
        const Pair zw = scale * ((zw_[0] * w + zw_[1] * x) + (zw_[2] * y + zw_[3] * z));
        out.x() = xy[0];
        out.y() = xy[1];
        out.z() = zw[0];
        out.w() = zw[1];
    }

 private:
    std::array<Pair, 4> xy_{};
    std::array<Pair, 4> zw_{};
};

}  // namespace poinsot
