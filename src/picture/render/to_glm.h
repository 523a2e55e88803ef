// Where Eigen, the language of the physics and of the shapes, becomes GLM, the language of OpenGL.
#pragma once

#include <Eigen/Core>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace poinsot {

// The same vector, or the same matrix, with the same precision: GLM's own conversions round.
template <class Derived>
auto to_glm(const Eigen::MatrixBase<Derived>& from) {
    constexpr int n_rows = Derived::RowsAtCompileTime, n_columns = Derived::ColsAtCompileTime;
    const auto column = [&from](int k) {
        glm::vec<n_rows, typename Derived::Scalar> to;
        for (int row = 0; row < n_rows; ++row) to[row] = from(row, k);
        return to;
    };
    if constexpr (n_columns == 1) {
        return column(0);
    } else {
        glm::mat<n_columns, n_rows, typename Derived::Scalar> to;
        for (int k = 0; k < n_columns; ++k) to[k] = column(k);
        return to;
    }
}

// The same pixel, where the tiles that a shape touches are found.
inline Eigen::Vector2d to_eigen(const glm::vec2& from) { return {from.x, from.y}; }

}  // namespace poinsot
