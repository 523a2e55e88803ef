// Fits of attitudes, as of video and motion capture, to the motion's own attitude.
#include "measured/flight_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "measured/fit.h"
#include "measured/joint_fit.h"
#include "measured/prediction.h"
#include "mechanics/free/free_rotation.h"
#include "sanitized.h"

namespace poinsot {

namespace {

struct Filmed {
    Eigen::Vector3d moments{3.0, 2.0, 1.0};
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // instrument from principal
    Eigen::Vector3d omega{1.0, 6.0, 2.0};                // at the first row, instrument axes
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
    double damping_1_s = 0.0;
};

Eigen::Quaterniond turned(const Eigen::Vector3d& by) {
    const double angle = by.norm();
    return angle > 0.0 ? Eigen::Quaterniond(Eigen::AngleAxisd(angle, by / angle))
                       : Eigen::Quaterniond::Identity();
}

// The attitudes of the exact motion; with the torque −γL it does in t what the free motion does in
// (1 − e^(−γt))/γ.
MeasuredMotion filmed(const Filmed& body, double span_s, double frames_a_s, double noise_rad,
                      std::mt19937& random, bool has_gaps = false) {
    const FreeRotation free(
        InertiaTensor::from_matrix(body.axes * body.moments.asDiagonal() * body.axes.transpose(),
                                   Physicality::waived),
        RotationState{0.0, body.attitude, body.omega});
    std::normal_distribution<double> scatter;
    MeasuredMotion made;
    made.has_attitude = true;
    for (int i = 0; i <= static_cast<int>(span_s * frames_a_s); ++i) {
        const double t = i / frames_a_s;
        // A body that is hidden for some frames now and then.
        if (has_gaps && i % 60 > 52) continue;
        const double slowed =
            body.damping_1_s > 0.0 ? -std::expm1(-body.damping_1_s * t) / body.damping_1_s : t;
        MeasuredRow row;
        row.time_s = 3.0 + t;
        const Eigen::Vector3d noise(scatter(random), scatter(random), scatter(random));
        row.space_from_body = free.at(slowed).space_from_body * turned(noise_rad * noise);
        made.rows.push_back(row);
    }
    add_omega_by_differences(made);
    return made;
}

Filmed random_body(std::mt19937& random) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Filmed body;
    const auto direction = [&] {
        return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
            .normalized();
    };
    body.axes = direction().toRotationMatrix();
    body.attitude = direction();
    const double second = 0.65 + 0.25 * unit(random);
    body.moments = {1.0, second, 1.03 - second + 0.1 * unit(random)};
    Eigen::Vector3d along;
    do along = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    while (along.cwiseAbs().maxCoeff() > 0.9);
    body.omega = body.axes * ((4.0 + 3.0 * unit(random)) * along);
    body.damping_1_s = 0.05 * unit(random);
    return body;
}

TEST(AttitudeFit, OfExactAttitudesGivesTheBodyThatMadeThem) {
    std::mt19937 random(1);
    for (const double frames_a_s : {24.0, 30.0, 60.0, 120.0, 240.0}) {
        const FittedMotion fit = fit_motion(filmed({}, 8.0, frames_a_s, 0.0, random).rows);
        ASSERT_TRUE(fit.attitude) << frames_a_s;
        EXPECT_NEAR(fit.moments[1], 2.0 / 3.0, 1e-7) << frames_a_s;
        EXPECT_NEAR(fit.moments[2], 1.0 / 3.0, 1e-7) << frames_a_s;
        EXPECT_EQ(fit.drag, DragModel::linear);
        EXPECT_NEAR(fit.drag_rates[0], 0.0, 1e-7) << frames_a_s;
        EXPECT_LT(fit.residual, 1e-7) << frames_a_s;
        EXPECT_LT((fit.omega_rad_s - Filmed{}.omega).norm(), 1e-6) << frames_a_s;
        EXPECT_LT(fit.attitude->angularDistance(Eigen::Quaterniond::Identity()), 1e-7);
    }
}

// 3 : 2 : 1 at 6 rad/s, 30 frames a second and 2 mrad.
TEST(AttitudeFit, OfAVideoIsAsGoodAsItsNoise) {
    std::mt19937 random(2);
    for (int i = 0; i < 8; ++i) {
        const FittedMotion fit = fit_motion(filmed({}, 8.0, 30.0, 0.002, random).rows);
        EXPECT_NEAR(fit.moments[1], 2.0 / 3.0, 0.0008) << i;
        EXPECT_LT(fit.moments_sd[1], 0.0004);
        EXPECT_NEAR(fit.residual, 0.002, 0.0003) << i;
        EXPECT_NEAR(fit.noise, 0.002, 0.0005) << i;
        EXPECT_EQ(fit.drag, DragModel::linear) << i;
    }
}

// Eleven minutes of a video: 4,000 rad, in which a small error of a moment loses count of the
// turns.
TEST(AttitudeFit, OfALongMotionGoesOnToTheMinimum) {
    std::mt19937 random(8);
    const double length_s = sanitized ? 60.0 : 660.0;
    const FittedMotion fit = fit_motion(filmed({}, length_s, 30.0, 0.005, random).rows);
    EXPECT_NEAR(fit.residual, 0.005, sanitized ? 0.0002 : 0.00006);
    EXPECT_NEAR(fit.moments[1], 2.0 / 3.0, 5.0 * fit.moments_sd[1]);
    EXPECT_NEAR(fit.moments[2], 1.0 / 3.0, 5.0 * fit.moments_sd[2]);
}

// The deviations are meant as they are said, at every rate and noise, with gaps and drag.
TEST(AttitudeFit, DeviationsAreThoseOfTheNumbers) {
    std::mt19937 random(3);
    double squares = 0.0;
    int n = 0, n_richer = 0, n_fits = 0;
    for (const double frames_a_s : {24.0, 30.0, 60.0, 120.0, 240.0})
        for (const double noise_rad : {0.0005, 0.002, 0.01})
            for (int i = 0; i < (sanitized ? 1 : 6); ++i) {
                const Filmed body = random_body(random);
                const FittedMotion fit =
                    fit_motion(filmed(body, 6.0, frames_a_s, noise_rad, random, i % 2 == 1).rows);
                const auto add = [&](double off, double sd) {
                    squares += off * off / (sd * sd);
                    ++n;
                };
                add(fit.moments[1] - body.moments[1], fit.moments_sd[1]);
                add(fit.moments[2] - body.moments[2], fit.moments_sd[2]);
                for (int k = 0; k < 3; ++k)
                    add(fit.omega_rad_s[k] - body.omega[k], fit.omega_sd_rad_s[k]);
                const Eigen::AngleAxisd off(*fit.attitude * body.attitude.conjugate());
                for (int k = 0; k < 3; ++k)
                    add(off.angle() * off.axis()[k], fit.attitude_sd_rad[k]);
                add(fit.drag_rates[0] - body.damping_1_s, fit.drag_rates_sd[0]);
                n_richer += fit.drag != DragModel::linear;
                ++n_fits;
            }
    const double rms = std::sqrt(squares / n);
    EXPECT_GT(rms, sanitized ? 0.5 : 0.7);
    EXPECT_LT(rms, sanitized ? 1.6 : 1.3);
    // By chance, noise looks like a richer drag now and then.
    EXPECT_LE(n_richer, n_fits / 20);
    RecordProperty("rms_z", std::to_string(rms));
    RecordProperty("n_richer", n_richer);
}

TEST(AttitudeFit, OfEachDragHasTheGradientOfItsSquares) {
    std::mt19937 random(4);
    const Filmed body = random_body(random);
    const std::vector<MeasuredRow> all = filmed(body, 4.0, 30.0, 0.05, random).rows;
    const double rate = rate_of(all);
    const std::vector<MeasuredRow> rows = scaled_by(all, rate);
    for (const DragModel drag : drag_models) {
        Flight flight;
        flight.moments = body.moments;
        flight.axes = body.axes;
        flight.omega = body.omega / rate;
        flight.drag = drag;
        flight.drag_rates = {0.02, 0.03, 0.01};
        flight.attitude = body.attitude;
        const FlightSums sums = flight_sums(flight, rows);
        const IsFitted is_fitted = fitted_changes({}, drag, true);
        for (int k = 0; k < most_flight_changes; ++k) {
            if (!is_fitted[static_cast<std::size_t>(k)]) continue;
            constexpr double h = 1e-5;
            const double above =
                flight_sums(changed(flight, h * FlightChange::Unit(k)), rows).squares;
            const double below =
                flight_sums(changed(flight, -h * FlightChange::Unit(k)), rows).squares;
            // The derivative of rᵀr is 2 Jᵀr.
            EXPECT_NEAR(2.0 * sums.gradient[k], (above - below) / (2.0 * h),
                        2e-4 * (1.0 + std::abs(sums.gradient[k])))
                << name_of(drag) << ' ' << k;
        }
    }
}

// Rows with a gyroscope's ω are fitted to it, whatever attitudes stand beside it.
TEST(AttitudeFit, IsOnlyOfRowsWithoutMeasuredOmega) {
    std::mt19937 random(5);
    MeasuredMotion motion = filmed({}, 8.0, 100.0, 0.0, random);
    for (MeasuredRow& row : motion.rows) row.is_omega_derived = false;
    EXPECT_FALSE(fit_motion(motion.rows).attitude);
}

TEST(AttitudeFit, OfManyFlightsIsThatOfTheirBody) {
    std::mt19937 random(6);
    const Filmed one = random_body(random);
    std::vector<MeasuredMotion> flights;
    for (int i = 0; i < 5; ++i) {
        Filmed body = random_body(random);
        body.axes = one.axes;
        body.moments = one.moments;
        flights.push_back(filmed(body, 3.0, 60.0, 0.003, random));
    }
    std::vector<std::span<const MeasuredRow>> spans;
    for (const MeasuredMotion& flight : flights) spans.emplace_back(flight.rows);
    const JointFit joint = fit_together(spans);
    EXPECT_EQ(joint.n_used, 5U);
    ASSERT_TRUE(joint.residual_rad);
    EXPECT_FALSE(joint.residual_rad_s);
    EXPECT_NEAR(*joint.residual_rad, 0.003, 0.0004);
    for (int k = 1; k < 3; ++k) {
        EXPECT_NEAR(joint.moments[k], one.moments[k], 4.0 * joint.moments_sd[k]) << k;
        EXPECT_LT(joint.moments_sd[k], 0.001) << k;
    }
    const Prediction predicted = predicted_by_others(spans[0], 30, joint, 0);
    EXPECT_TRUE(predicted.has_attitude);
    EXPECT_LT(predicted.rms, 0.05);
}

}  // namespace

}  // namespace poinsot
