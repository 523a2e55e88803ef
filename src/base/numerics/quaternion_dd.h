// Vectors and quaternions in double-double, for setting up an attitude.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

#include "numerics/double_double.h"
#include "numerics/power_of_two.h"

namespace poinsot {

using VectorDD = std::array<DoubleDouble, 3>;

// A quaternion in double-double.
struct QuaternionDD {
    DoubleDouble w;
    VectorDD v;
};

inline Eigen::Vector3d rounded(const VectorDD& v) {
    return {v[0].rounded(), v[1].rounded(), v[2].rounded()};
}
inline Eigen::Quaterniond rounded(const QuaternionDD& q) {
    return {q.w.rounded(), q.v[0].rounded(), q.v[1].rounded(), q.v[2].rounded()};
}

inline VectorDD cross(const VectorDD& a, const VectorDD& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline QuaternionDD operator*(const QuaternionDD& p, const QuaternionDD& q) {
    const VectorDD c = cross(p.v, q.v);
    QuaternionDD r;
    r.w = p.w * q.w - (p.v[0] * q.v[0] + p.v[1] * q.v[1] + p.v[2] * q.v[2]);
    for (std::size_t i = 0; i < 3; ++i) r.v[i] = p.w * q.v[i] + q.w * p.v[i] + c[i];
    return r;
}

inline VectorDD rotated(const QuaternionDD& q, const VectorDD& x) {
    const VectorDD once = cross(q.v, x);
    const VectorDD twice = cross(q.v, once);
    VectorDD result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = x[i] + (q.w * once[i] + twice[i]) * 2.0;
    return result;
}

inline QuaternionDD conjugate(const QuaternionDD& q) { return {q.w, {-q.v[0], -q.v[1], -q.v[2]}}; }

// The unit quaternion of q, with w ≥ 0. Precondition: q is finite and not zero.
inline QuaternionDD unit(const Eigen::Quaterniond& q) {
    const Eigen::Vector4d c = ldexp(q.coeffs(), -exponent_of(q.coeffs()));
    DoubleDouble square;
    for (const double x : c) square = square + two_product(x, x);
    DoubleDouble length = sqrt(square);
    if (c[3] < 0.0) length = -length;
    return {
        DoubleDouble(c[3]) / length,
        {DoubleDouble(c[0]) / length, DoubleDouble(c[1]) / length, DoubleDouble(c[2]) / length}};
}

inline VectorDD times(const Eigen::Matrix3d& m, const VectorDD& x) {
    VectorDD result;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            const auto j = static_cast<std::size_t>(k);
            result[static_cast<std::size_t>(i)] =
                result[static_cast<std::size_t>(i)] + x[j] * m(i, k);
        }
    }
    return result;
}

}  // namespace poinsot
