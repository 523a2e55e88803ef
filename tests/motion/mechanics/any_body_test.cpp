// Free bodies with moments, tensors and ω of every size that a double holds, in principal and in
// turned axes.
#include "mechanics/any_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "mechanics/free/free_rotation.h"
#include "mechanics/free_rotation_oracle.h"

namespace poinsot::any_body {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double decades = 300.0;

class Source {
 public:
    explicit Source(unsigned seed) : random_(seed) {}

    double between(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random_);
    }
    // Of either sign and any size.
    double any() { return std::copysign(size(), between(-1.0, 1.0)); }
    double size(double most_decades = decades) {
        return std::pow(10.0, between(-most_decades, most_decades));
    }
    Vector3d direction() { return {between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0)}; }
    // Each component of a size of its own, or all of one size.
    Vector3d omega(bool one_size) {
        if (one_size) return size() * direction();
        return {any(), any(), any()};
    }
    Quaterniond attitude() {
        return Quaterniond(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0),
                           between(-1.0, 1.0))
            .normalized();
    }
    // Moments that a body can have, of order one.
    Vector3d physical() {
        const double a = between(0.1, 1.0), b = between(0.1, 1.0), least = std::abs(a - b);
        return {a, b, least + (a + b - least) * between(0.0, 1.0)};
    }
    Matrix3d turned(const Vector3d& moments) {
        const Matrix3d axes = attitude().toRotationMatrix();
        const Matrix3d full = axes * moments.asDiagonal() * axes.transpose();
        return 0.5 * full + 0.5 * full.transpose();
    }

 private:
    std::mt19937_64 random_;
};

// What the families have besides: whether a body of it may be refused for more than the overflow of
// L, and whether most have a twin of order one.
struct Family {
    const char* name;
    Body (*make)(Source& source, bool one_size);
    bool always_moves;
    bool has_twins;
};

Body physical_in_principal_axes(Source& source, bool one_size) {
    Body body;
    body.tensor_kg_m2 = source.size() * Matrix3d(source.physical().asDiagonal());
    body.omega_rad_s = source.omega(one_size);
    body.physicality = Physicality::required;
    return body;
}

Body physical_turned(Source& source, bool one_size) {
    Body body = physical_in_principal_axes(source, one_size);
    body.tensor_kg_m2 = source.size() * source.turned(source.physical());
    return body;
}

Body needle(Source& source, bool one_size) {
    Body body = physical_in_principal_axes(source, one_size);
    const double thin_decades = source.between(0.0, 280.0);
    const double thin = std::pow(10.0, -thin_decades);
    const Vector3d moments(thin, 1.0, 1.0 + thin * source.between(0.0, 1.0));
    body.tensor_kg_m2 = std::pow(10.0, source.between(thin_decades - decades, decades)) *
                        Matrix3d(moments.asDiagonal());
    return body;
}

Body turned_needle(Source& source, bool one_size) {
    Body body = physical_in_principal_axes(source, one_size);
    const Vector3d moments(std::pow(10.0, -source.between(0.0, 12.0)), 1.0, 1.0);
    body.tensor_kg_m2 = source.size() * source.turned(moments);
    body.physicality = Physicality::waived;
    return body;
}

// A good tensor beside one small element.
Body tiny_element(Source& source, bool one_size) {
    Body body = physical_in_principal_axes(source, one_size);
    const double tiny = std::pow(10.0, -source.between(1.0, 323.0));
    body.tensor_kg_m2 = Matrix3d{{3.0, 0.1, tiny}, {0.1, 2.0, 0.0}, {tiny, 0.0, 2.5}};
    return body;
}

Body any_moments(Source& source, bool one_size) {
    Body body;
    body.tensor_kg_m2 = Vector3d(source.size(), source.size(), source.size()).asDiagonal();
    body.omega_rad_s = source.omega(one_size);
    return body;
}

// D A D with any D: positive definite, with moments of any sizes in axes that are hardly turned.
Body graded(Source& source, bool one_size) {
    Body body;
    const Vector3d sizes(source.size(145.0), source.size(145.0), source.size(145.0));
    const Matrix3d tensor =
        sizes.asDiagonal() * source.turned(source.physical()) * sizes.asDiagonal();
    body.tensor_kg_m2 = 0.5 * tensor + 0.5 * tensor.transpose();
    body.omega_rad_s = source.omega(one_size);
    return body;
}

// Most are not positive definite.
Body any_elements(Source& source, bool one_size) {
    Body body;
    for (int i = 0; i < 3; ++i) {
        body.tensor_kg_m2(i, i) = source.size();
        for (int j = 0; j < i; ++j)
            body.tensor_kg_m2(i, j) = body.tensor_kg_m2(j, i) = 1e-100 * source.any();
    }
    body.omega_rad_s = source.omega(one_size);
    return body;
}

constexpr Family families[] = {
    {"physical", physical_in_principal_axes, true, true},
    {"physical, turned", physical_turned, true, true},
    {"needle", needle, true, false},
    {"turned needle", turned_needle, true, true},
    {"tiny element", tiny_element, true, false},
    {"any moments", any_moments, false, false},
    {"graded", graded, false, false},
    {"any elements", any_elements, false, false},
};

TEST(AnyBody, MovesRightlyOrIsRefusedByName) {
    constexpr int n_bodies = 12500;
    unsigned seed = 1;
    for (const Family& family : families) {
        Source source(seed++);
        int n_faults = 0, n_moved = 0, n_twins = 0;
        for (int n = 0; n < n_bodies && n_faults < 3; ++n) {
            Body body = family.make(source, n % 2 == 0);
            body.attitude = source.attitude();
            const Outcome outcome = moved(body);
            n_moved += outcome.refusal.empty() ? 1 : 0;
            n_twins += outcome.is_twin ? 1 : 0;
            if (family.always_moves && outcome.fault.empty() && !outcome.refusal.empty() &&
                outcome.refusal.find("overflows") == std::string::npos)
                ADD_FAILURE() << family.name << " " << n << ": " << outcome.refusal;
            if (outcome.fault.empty()) continue;
            ++n_faults;
            ADD_FAILURE() << family.name << " " << n << ": " << outcome.fault << "\n"
                          << body.tensor_kg_m2 << "\nomega " << body.omega_rad_s.transpose();
        }
        EXPECT_GT(n_moved, n_bodies / (family.always_moves ? 2 : 50)) << family.name;
        EXPECT_GT(n_twins, family.has_twins ? n_bodies / 5 : 0) << family.name;
    }
}

// The largest error against the oracle, of ω relative to |ω| and of the attitude in rad.
double error_of(const Body& body, double turn) {
    const InertiaTensor inertia = InertiaTensor::from_matrix(body.tensor_kg_m2, body.physicality);
    RotationState start;
    start.omega_body = body.omega_rad_s;
    const double time_s = turn / body.omega_rad_s.stableNorm();
    const RotationState state = FreeRotation(inertia, start).at(time_s);
    using LongVector = Eigen::Matrix<long double, 3, 1>;
    using LongQuaternion = Eigen::Quaternion<long double>;
    const Eigen::Matrix<long double, 3, 3> axes = inertia.body_from_principal().cast<long double>();
    const LongVector omega = axes.transpose() * body.omega_rad_s.cast<long double>();
    const oracle::Answer truth =
        oracle::FreeMotion(inertia.moments_kg_m2(), omega.cast<double>()).at(time_s);
    const LongVector expected = axes * LongVector(truth.omega[0], truth.omega[1], truth.omega[2]);
    const LongQuaternion turned(axes);
    const LongQuaternion attitude =
        turned *
        LongQuaternion(truth.attitude[0], truth.attitude[1], truth.attitude[2], truth.attitude[3]) *
        turned.conjugate();
    const auto got = state.space_from_body.coeffs().cast<long double>();
    const long double off =
        2.0L * std::min((got - attitude.coeffs()).norm(), (got + attitude.coeffs()).norm());
    return static_cast<double>(
        std::max(off, (state.omega_body.cast<long double>() - expected).norm() / expected.norm()));
}

// In turned axes ω is rounded in the principal ones once more.
TEST(AnyBody, AgreesWithTheOracle) {
    Source source(17);
    int n_moved = 0;
    for (int n = 0; n < 60; ++n) {
        for (const auto& make : {physical_in_principal_axes, needle, physical_turned}) {
            const Body body = make(source, true);
            if (!moved(body).refusal.empty()) continue;
            const double bound = make == physical_turned ? 4e-15 : 2e-15;
            EXPECT_LE(error_of(body, 7.7), bound)
                << body.tensor_kg_m2 << "\nomega " << body.omega_rad_s.transpose();
            ++n_moved;
        }
    }
    EXPECT_GT(n_moved, 100);
}

// The calls that did not end, or whose tensor was refused.
TEST(AnyBody, EndsForTheLargestOmegaInTurnedAxes) {
    Body body;
    body.tensor_kg_m2 = Matrix3d{{3.0, 0.1, 0.0}, {0.1, 2.0, 0.0}, {0.0, 0.0, 2.0}};
    for (const double size : {1e299, 1e300, 2e300, 1e307}) {
        body.omega_rad_s = {0.0, 0.0, size};
        EXPECT_EQ(moved(body).fault, "") << size;
        EXPECT_EQ(moved(body).refusal, "") << size;
        body.omega_rad_s = {size, -0.5 * size, size};
        EXPECT_EQ(moved(body).fault, "") << size;
        EXPECT_EQ(moved(body).refusal, "") << size;
    }
    body.omega_rad_s.setConstant(std::numeric_limits<double>::max());
    EXPECT_EQ(moved(body).refusal.find("omega_rad_s"), 0U) << moved(body).refusal;
}

TEST(AnyBody, EndsForATinyElement) {
    Body body;
    body.omega_rad_s = {1.0, 2.0, 3.0};
    body.tensor_kg_m2 = Matrix3d{
        {1.0000001, 1.0000001e-8, 1e-300}, {1.0000001e-8, 1e-150, 0.0}, {1e-300, 0.0, 1.0}};
    EXPECT_EQ(moved(body).fault, "");
    body.tensor_kg_m2 = Matrix3d{{1e308, 9e307, 0.0}, {9e307, 1e308, 0.0}, {0.0, 0.0, 1e308}};
    EXPECT_EQ(moved(body).fault, "");
    EXPECT_EQ(moved(body).refusal.find("tensor_kg_m2"), 0U) << moved(body).refusal;
}

}  // namespace
}  // namespace poinsot::any_body
