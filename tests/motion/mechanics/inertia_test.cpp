// Inertia tensors: accepted and refused input, and the resulting principal axes.
#include "mechanics/inertia.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>

#include "error/error.h"
#include "refusal.h"

namespace poinsot::inertia_tests {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

std::string refusal_of_moments(const Vector3d& moments) {
    return refusal_message([&] { InertiaTensor::from_principal_moments(moments); });
}
std::string refusal_of_tensor(const Matrix3d& tensor) {
    return refusal_message([&] { InertiaTensor::from_matrix(tensor); });
}

// R D Rᵀ, symmetric to the last bit.
Matrix3d turned(const Vector3d& moments, const Matrix3d& rotation) {
    const Matrix3d full = rotation * moments.asDiagonal() * rotation.transpose();
    return 0.5 * (full + full.transpose());
}

TEST(InertiaTensor, KeepsPrincipalMomentsExactlyAndInOrder) {
    const Vector3d given(0.3, 0.1, 0.25);
    const InertiaTensor inertia = InertiaTensor::from_principal_moments(given);
    EXPECT_EQ(inertia.moments_kg_m2(), given);
    EXPECT_TRUE(inertia.body_axes_are_principal());
    EXPECT_TRUE(inertia.note().empty());
}

TEST(InertiaTensor, RefusesMomentsByNameAndRule) {
    EXPECT_NE(refusal_of_moments({0.0, 1.0, 1.0}).find("moments_kg_m2[0] (I1) = 0"),
              std::string::npos);
    EXPECT_NE(refusal_of_moments({1.0, -1.0, 1.0}).find("moments_kg_m2[1] (I2) = -1"),
              std::string::npos);
    EXPECT_NE(refusal_of_moments({1.0, 1.0, std::nan("")}).find("finite"), std::string::npos);
    EXPECT_NE(refusal_of_moments({1.0, infinity, 1.0}).find("finite"), std::string::npos);
}

TEST(InertiaTensor, ExplainsTheTriangleInequality) {
    const std::string message = refusal_of_moments({1.0, 2.0, 3.5});
    EXPECT_NE(message.find("I1 + I2 - I3 = 2 times the integral of x3^2 dm"), std::string::npos)
        << message;
    EXPECT_NE(message.find("at most 3"), std::string::npos) << message;
    EXPECT_NE(refusal_of_moments({3.5, 1.0, 2.0}).find("I2 + I3 - I1"), std::string::npos);
    EXPECT_NE(refusal_of_moments({1e-12, 1.0, 1e12}), "");
    // The check also works where sums overflow.
    EXPECT_EQ(refusal_of_moments({1.2e308, 1.2e308, 1.7e308}), "");
    EXPECT_NE(refusal_of_moments({0.1e308, 0.2e308, 1.7e308}), "");
}

TEST(InertiaTensor, AcceptsUnphysicalMomentsWhenAllowed) {
    const Vector3d given(1e-12, 1.0, 1e12);
    const InertiaTensor inertia = InertiaTensor::from_principal_moments(given, Physicality::waived);
    EXPECT_EQ(inertia.moments_kg_m2(), given);
    EXPECT_FALSE(inertia.planar());
    EXPECT_NE(refusal_message([&] {
                  InertiaTensor::from_principal_moments({-1.0, 1.0, 1.0}, Physicality::waived);
              }),
              "");
}

TEST(InertiaTensor, TreatsALaminaAsPlanarToFourUlp) {
    const auto planar = [](double high) {
        return InertiaTensor::from_principal_moments({1.25, 2.5, high}).planar();
    };
    double high = 3.75;
    EXPECT_TRUE(planar(high));
    for (int n = 1; n <= 4; ++n) {
        high = std::nextafter(high, infinity);
        EXPECT_TRUE(planar(high)) << n << " ulp beyond the sum";
    }
    EXPECT_NE(refusal_of_moments({1.25, 2.5, std::nextafter(high, infinity)}), "");
    EXPECT_TRUE(planar(3.75 - 4 * 2.0 * epsilon));
    EXPECT_FALSE(planar(3.75 - 6 * 2.0 * epsilon));
    EXPECT_FALSE(planar(3.0));
}

TEST(InertiaTensor, KeepsADiagonalTensorExactly) {
    const Vector3d moments(0.7, 0.30000000000000004, 0.5);
    const InertiaTensor inertia = InertiaTensor::from_matrix(moments.asDiagonal());
    EXPECT_EQ(inertia.moments_kg_m2(), moments);
    EXPECT_TRUE(inertia.body_axes_are_principal());
    EXPECT_EQ(inertia.matrix_body(), Matrix3d(moments.asDiagonal()));
}

TEST(InertiaTensor, FindsPrincipalAxesNearestTheBodyAxes) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    for (int n = 0; n < 500; ++n) {
        const Vector3d moments(1.0 + 0.5 * std::abs(std::sin(n)), 1.7, 2.2);
        // Rotated by at most 0.35 rad, so that the nearest axes are the body's own.
        const Vector3d axis = Vector3d(normal(random), normal(random), normal(random)).normalized();
        const Matrix3d rotation =
            Eigen::AngleAxisd(0.35 * std::sin(3.0 * n), axis).toRotationMatrix();
        const Matrix3d tensor = turned(moments, rotation);
        const InertiaTensor inertia = InertiaTensor::from_matrix(tensor);
        const Matrix3d& axes = inertia.body_from_principal();
        EXPECT_LE((inertia.moments_kg_m2() - moments).cwiseAbs().maxCoeff(),
                  2e-15);                                           // measured 8.9e-16
        EXPECT_LE((axes - rotation).cwiseAbs().maxCoeff(), 4e-15);  // 2.1e-15
        EXPECT_LE((axes.transpose() * axes - Matrix3d::Identity()).cwiseAbs().maxCoeff(), 4e-16);
        EXPECT_GT(axes.determinant(), 0.0);
        EXPECT_LE((inertia.matrix_body() - tensor).cwiseAbs().maxCoeff(), 2e-15);
    }
}

TEST(InertiaTensor, KeepsTheSmallestMomentOfARotatedNeedle) {
    // The tensor is taken as exact: its doubles have this smallest eigenvalue to 60 digits. The
    // entries must be dyadic: e = (3, 4, 0)/5 would be rounded, so a rotation of 45° about e3 is
    // used.
    const double thin = 0x1p-36;
    const Matrix3d tensor{{0.5 * (thin + 1.0), 0.5 * (thin - 1.0), 0.0},
                          {0.5 * (thin - 1.0), 0.5 * (thin + 1.0), 0.0},
                          {0.0, 0.0, 1.0}};
    const InertiaTensor inertia = InertiaTensor::from_matrix(tensor);
    EXPECT_DOUBLE_EQ(inertia.moments_kg_m2().minCoeff(), thin);
}

TEST(InertiaTensor, RepeatedMomentsGiveAxesNearestTheBodyAxes) {
    // A sphere's tensor with rounding noise off the diagonal.
    Matrix3d sphere = 2.0 * Matrix3d::Identity();
    sphere(0, 1) = sphere(1, 0) = 2e-16;
    const InertiaTensor ball = InertiaTensor::from_matrix(sphere);
    EXPECT_EQ(ball.body_from_principal(), Matrix3d::Identity());
    EXPECT_EQ(ball.moments_kg_m2(), Vector3d::Constant(2.0));

    // A symmetric body whose axis is rotated from e3 by 0.3 rad about e1: the nearest axes have
    // only this rotation.
    const Matrix3d rotation = Eigen::AngleAxisd(0.3, Vector3d::UnitX()).toRotationMatrix();
    const InertiaTensor spindle = InertiaTensor::from_matrix(turned({2.0, 2.0, 1.0}, rotation));
    EXPECT_LE((spindle.body_from_principal() - rotation).cwiseAbs().maxCoeff(), 4e-16);
    EXPECT_EQ(spindle.moments_kg_m2()[0], spindle.moments_kg_m2()[1]);
}

TEST(InertiaTensor, AveragesASmallAsymmetryAndRefusesALargeOne) {
    const Matrix3d tensor =
        turned({1.0, 2.0, 2.5},
               Eigen::AngleAxisd(0.4, Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix());
    const double largest = tensor.cwiseAbs().maxCoeff();
    for (const double unit : {1e-300, 1.0, 1e300}) {
        Matrix3d slight = tensor;
        slight(0, 1) += 0.9e-12 * largest;
        const InertiaTensor averaged = InertiaTensor::from_matrix(unit * slight);
        EXPECT_EQ(averaged.note(), "asymmetry of 9e-13 of its largest element averaged away");
        slight(0, 1) = slight(1, 0) = 0.5 * slight(0, 1) + 0.5 * slight(1, 0);
        EXPECT_EQ(InertiaTensor::from_matrix(unit * slight).note(), "");
        EXPECT_LE(
            (averaged.moments_kg_m2() - InertiaTensor::from_matrix(unit * slight).moments_kg_m2())
                .cwiseAbs()
                .maxCoeff(),
            4.0 * epsilon * unit);
        Matrix3d gross = tensor;
        gross(0, 1) += 1.1e-12 * largest;
        EXPECT_NE(refusal_of_tensor(unit * gross).find("[0][1]"), std::string::npos);
    }
    // Elements that are roundings alone.
    Matrix3d noisy = Vector3d(1.0, 2.0, 2.5).asDiagonal();
    noisy(0, 1) = 1e-17;
    noisy(1, 0) = -3e-17;
    EXPECT_EQ(refusal_of_tensor(noisy), "");
    Matrix3d smallest = std::numeric_limits<double>::denorm_min() * Matrix3d::Identity();
    smallest(0, 1) = smallest(0, 0);
    EXPECT_NE(refusal_of_tensor(smallest).find("not symmetric"), std::string::npos);
}

// R D Rᵀ and sums of m (r² 1 − r rᵀ), as programs compute them: not symmetric to the last bit.
TEST(InertiaTensor, TakesTensorsOutOfComputations) {
    std::mt19937_64 random(13);
    std::normal_distribution<double> normal;
    int n_asymmetric = 0;
    for (int n = 0; n < 2000; ++n) {
        const Vector3d moments(1.0 + 0.5 * std::abs(std::sin(n)), 1.7, 2.2);
        const Matrix3d rotation =
            Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                .normalized()
                .toRotationMatrix();
        const Matrix3d scaled = rotation * moments.asDiagonal();
        const Matrix3d tensor = scaled * rotation.transpose();
        n_asymmetric += tensor != tensor.transpose() ? 1 : 0;
        Vector3d found = InertiaTensor::from_matrix(tensor).moments_kg_m2();
        std::sort(found.data(), found.data() + 3);
        EXPECT_LE((found - moments).cwiseAbs().maxCoeff(), 2e-14);  // measured 4.4e-15

        Matrix3d sum = Matrix3d::Zero();
        for (int k = 0; k < 50; ++k) {
            const Vector3d at(normal(random), normal(random), normal(random));
            const Matrix3d of_mass = at.squaredNorm() * Matrix3d::Identity() - at * at.transpose();
            sum += std::abs(normal(random)) * of_mass;
        }
        const Matrix3d turned_sum = rotation * sum * rotation.transpose();
        n_asymmetric += turned_sum != turned_sum.transpose() ? 1 : 0;
        EXPECT_EQ(refusal_of_tensor(turned_sum), "");
    }
    EXPECT_GT(n_asymmetric, 2000);
}

// One element of any size beside others of order one: its square alone enters the moments.
TEST(InertiaTensor, DoesNotMindATinyElement) {
    const Matrix3d without{{3.0, 0.1, 0.0}, {0.1, 2.0, 0.0}, {0.0, 0.0, 2.5}};
    const InertiaTensor expected = InertiaTensor::from_matrix(without);
    for (const double tiny : {1e-20, 1e-150, 1e-160, 1e-295, 1e-300, 1e-305, 1e-310, 5e-324}) {
        Matrix3d tensor = without;
        tensor(0, 2) = tensor(2, 0) = tiny;
        const InertiaTensor inertia = InertiaTensor::from_matrix(tensor);
        EXPECT_LE((inertia.moments_kg_m2() - expected.moments_kg_m2()).cwiseAbs().maxCoeff(), 1e-15)
            << tiny;
        EXPECT_LE(
            (inertia.body_from_principal() - expected.body_from_principal()).cwiseAbs().maxCoeff(),
            1e-15)
            << tiny;
    }
}

// D A D with any D: the invariants of the tensor, in long double, are those of the moments, to the
// digits of the smallest one. Only moments that rounding tells apart are asked for.
TEST(InertiaTensor, KeepsMomentsOfEverySize) {
    std::mt19937_64 random(14);
    std::uniform_real_distribution<double> decades(-90.0, 90.0), moment(0.3, 1.0);
    std::normal_distribution<double> normal;
    for (int n = 0; n < 3000; ++n) {
        const Matrix3d rotation =
            Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                .normalized()
                .toRotationMatrix();
        const Matrix3d core = turned({moment(random), moment(random), moment(random)}, rotation);
        const Vector3d sizes(std::pow(10.0, decades(random)), std::pow(10.0, decades(random)),
                             std::pow(10.0, decades(random)));
        Matrix3d tensor = sizes.asDiagonal() * core * sizes.asDiagonal();
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < i; ++j) tensor(i, j) = tensor(j, i);
        const InertiaTensor inertia = InertiaTensor::from_matrix(tensor, Physicality::waived);
        using LongMatrix = Eigen::Matrix<long double, 3, 3>;
        const LongMatrix T = tensor.cast<long double>();
        const Eigen::Matrix<long double, 3, 1> I = inertia.moments_kg_m2().cast<long double>();
        const auto minor = [&](int i, int j) { return T(i, i) * T(j, j) - T(i, j) * T(i, j); };
        const long double minors = minor(0, 1) + minor(0, 2) + minor(1, 2);
        const long double products = I[0] * I[1] + I[0] * I[2] + I[1] * I[2];
        EXPECT_LE(std::abs(static_cast<double>(I.sum() / T.trace() - 1.0L)), 1e-14);
        EXPECT_LE(std::abs(static_cast<double>(products / minors - 1.0L)), 1e-14) << tensor;
        EXPECT_LE(std::abs(static_cast<double>(I.prod() / T.determinant() - 1.0L)), 1e-14)
            << tensor;
    }
}

TEST(InertiaTensor, RefusesMomentsBeyondDoubles) {
    const Matrix3d large{{1.5e308, 1e308, 0.0}, {1e308, 1.5e308, 0.0}, {0.0, 0.0, 1e308}};
    const std::string message =
        refusal_message([&] { InertiaTensor::from_matrix(large, Physicality::waived); });
    EXPECT_EQ(message.find("tensor_kg_m2: its principal moment I"), 0U) << message;
    const Matrix3d indefinite = large - 1e308 * Matrix3d::Identity();
    EXPECT_NE(refusal_of_tensor(indefinite).find("not positive definite"), std::string::npos);
    EXPECT_EQ(refusal_of_tensor(indefinite).find("nan"), std::string::npos);
}

TEST(InertiaTensor, RefusesAnIndefiniteTensorWithItsEigenvalues) {
    const Matrix3d tensor{{1.0, 2.0, 0.0}, {2.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    const std::string message = refusal_of_tensor(tensor);
    EXPECT_NE(message.find("not positive definite"), std::string::npos) << message;
    EXPECT_NE(message.find("-1, 3, 1"), std::string::npos) << message;
    Matrix3d not_finite = Matrix3d::Identity();
    not_finite(2, 1) = std::nan("");
    EXPECT_NE(refusal_of_tensor(not_finite).find("tensor_kg_m2[2][1]"), std::string::npos);
    EXPECT_NE(refusal_of_tensor(Matrix3d::Zero()), "");
}

TEST(InertiaTensor, AcceptsARotatedLamina) {
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    for (int n = 0; n < 2000; ++n) {
        const Eigen::Quaterniond q =
            Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                .normalized();
        const Matrix3d tensor = turned({1.25, 2.5, 3.75}, q.toRotationMatrix());
        EXPECT_TRUE(InertiaTensor::from_matrix(tensor).planar());
    }
    const Matrix3d broken =
        turned({1.0, 2.0, 3.5}, Eigen::AngleAxisd(1.0, Vector3d::UnitY()).toRotationMatrix());
    EXPECT_NE(refusal_of_tensor(broken).find("allow_unphysical"), std::string::npos);
}

TEST(InertiaTensor, NamesTheTensorInMessages) {
    const Matrix3d tensor = Vector3d(1.0, 2.0, 3.5).asDiagonal();
    EXPECT_EQ(refusal_of_tensor(tensor).find("tensor_kg_m2: no distribution of mass"), 0U);
}

TEST(InertiaTensor, GivenAxesMustBeARotation) {
    EXPECT_NE(refusal_message([] {
                  InertiaTensor::from_principal_axes({1.0, 2.0, 2.5}, -Matrix3d::Identity());
              }),
              "");
    const InertiaTensor inertia = InertiaTensor::from_principal_axes(
        {1.0, 2.0, 2.5}, Eigen::AngleAxisd(0.5, Vector3d::UnitZ()).toRotationMatrix());
    EXPECT_FALSE(inertia.body_axes_are_principal());
}

}  // namespace
}  // namespace poinsot::inertia_tests
