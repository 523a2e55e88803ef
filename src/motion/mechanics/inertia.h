// The inertia tensor of a rigid body about its centre of mass (or fixed point) and its principal
// axes.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

namespace poinsot {

// Whether moments that violate the triangle inequality, which no real body has, are refused.
enum class Physicality { required, waived };

// A symmetric inertia tensor with its principal axes, checked once at construction.
//
// "Body axes" are the axes in which the user gave the numbers. The principal axes e1, e2, e3 are
// numbered as the user gave them (principal moments), or each has the number of the nearest body
// axis (tensor); they are never sorted. body_from_principal is a proper rotation.
class InertiaTensor {
 public:
    // Principal moments in kg m², in any order; body axes are the principal axes. Throws InputError
    // if one is not finite, not positive, or (required) the triangle inequality fails by more than
    // 4 ulp. The message names the moment as moments_kg_m2[i] and states the rule.
    static InertiaTensor from_principal_moments(const Eigen::Vector3d& moments_kg_m2,
                                                Physicality physicality = Physicality::required);

    // Principal moments in kg m² and the principal axes as columns in body axes. Throws InputError
    // as above, and if the axes are not a proper rotation to 1e-12.
    static InertiaTensor from_principal_axes(const Eigen::Vector3d& moments_kg_m2,
                                             const Eigen::Matrix3d& body_from_principal,
                                             Physicality physicality = Physicality::required);

    // A full symmetric tensor in kg m², in body axes. Asymmetry of at most 1e-12 of the largest
    // element is averaged away and noted; more is refused. An exactly diagonal tensor keeps its
    // moments exactly. The elements of other tensors are taken as exact; moments that differ by at
    // most 4 epsilon of the largest are set equal (with the axes nearest the body's), and the body
    // is a lamina if the triangle equality holds to 16 ulp: rounding the elements moves a moment by
    // as much. Throws InputError with the eigenvalues printed if it is not positive definite or
    // breaks the triangle inequality, and if a moment lies beyond the range of double.
    static InertiaTensor from_matrix(const Eigen::Matrix3d& tensor_kg_m2_body,
                                     Physicality physicality = Physicality::required);

    // I1, I2, I3 in kg m², in the order of the principal axes.
    const Eigen::Vector3d& moments_kg_m2() const { return moments_kg_m2_; }

    // Columns are e1, e2, e3 in body axes. Determinant +1.
    const Eigen::Matrix3d& body_from_principal() const { return body_from_principal_; }

    // True if the body axes are principal axes (body_from_principal is exactly the identity).
    bool body_axes_are_principal() const { return body_axes_are_principal_; }

    // The tensor in kg m², in body axes.
    Eigen::Matrix3d matrix_body() const;

    // True if one moment is the sum of the others to 4 ulp: a lamina.
    bool planar() const { return planar_; }

    // The correction made to the input ("asymmetry of 2e-16 of its largest element averaged away"),
    // or empty.
    const std::string& note() const { return note_; }

 private:
    InertiaTensor() = default;

    Eigen::Vector3d moments_kg_m2_{1.0, 1.0, 1.0};
    Eigen::Matrix3d body_from_principal_ = Eigen::Matrix3d::Identity();
    bool body_axes_are_principal_ = true;
    bool planar_ = false;
    std::string note_;
};

}  // namespace poinsot
