// What the first rows of a flight predict, against the rows that follow.
#include "measured/prediction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "error/error.h"
#include "measured/made_recording.h"
#include "mechanics/free/free_rotation.h"
#include "places.h"

namespace poinsot {

namespace {

using testing::MadeRecording;
using testing::ThrownBody;

// Without drag, the period is that of Jacobi's solution, and the flip is where ω along e2 changes
// its sign in rows without noise.
TEST(Prediction, OfAFreeFlightIsRightWithinItsDeviation) {
    int n_covered = 0, n = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        MadeRecording made(seed), exact(seed);
        const Eigen::Matrix3d axes = made.rotation();
        const ThrownBody body{{1.0, 0.8, 0.3}, axes, Eigen::Vector3d::Zero()};
        const Eigen::Vector3d principal(2.0, 9.0, 2.5);
        made.fly(body, axes * principal, 2.0);
        exact.fly(body, axes * principal, 2.0);
        const auto rows = made.rows({.noise_rad_s = 0.02});
        const auto clean = exact.rows({.noise_rad_s = 0.0});
        constexpr std::size_t n_fitted = 120;
        const Prediction predicted = predicted_alone(rows, n_fitted, {}, DragModel::linear);
        const FreeRotation free(
            InertiaTensor::from_matrix(Eigen::Matrix3d(body.moments.asDiagonal())),
            RotationState{0.0, Eigen::Quaterniond::Identity(), principal});
        ASSERT_TRUE(predicted.period_s && predicted.flip_s);
        n_covered += std::abs(predicted.period_s->value - *free.constants().polhode_period_s) <
                     1.96 * predicted.period_s->sd;
        const Eigen::Vector3d middle = axes.col(1);
        for (std::size_t i = n_fitted; i < clean.size(); ++i) {
            const double a = middle.dot(clean[i - 1].omega_body);
            const double b = middle.dot(clean[i].omega_body);
            if ((a < 0.0) == (b < 0.0)) continue;
            const double flip_s = clean[i - 1].time_s + 0.01 * a / (a - b);
            n_covered += std::abs(predicted.flip_s->value - flip_s) < 1.96 * predicted.flip_s->sd;
            ++n;
            break;
        }
        ++n;
        EXPECT_EQ(predicted.n_rest, rows.size() - n_fitted);
    }
    EXPECT_GT(1.0 * n_covered / n, 0.95 - 4.0 * std::sqrt(0.95 * 0.05 / n));
}

// The students who threw the racket predicted periods from the first row by explicit Euler with
// moments of pendulums, off by 14.8 % on average.
TEST(Prediction, OfRealThrowsFromTenRowsIsOffByTwoPerCent) {
    std::vector<std::vector<MeasuredRow>> tables;
    for (const auto& entry : std::filesystem::directory_iterator(
             source_folder() / "tests" / "motion" / "measured" / "racket")) {
        if (entry.path().extension() != ".csv") continue;
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        tables.push_back(read_measured(text, entry.path().string()).rows);
    }
    const std::vector<std::span<const MeasuredRow>> flights(tables.begin(), tables.end());
    const JointFit joint = fit_together(flights);
    double sum = 0.0;
    std::vector<double> flips_s;
    std::size_t n = 0;
    for (std::size_t i = 0; i < flights.size(); ++i) {
        const Prediction predicted = predicted_by_others(flights[i], 10, joint, i);
        ASSERT_TRUE(predicted.period_s && predicted.measured_period_s) << i;
        sum += std::abs(predicted.period_s->value / *predicted.measured_period_s - 1.0);
        ++n;
        if (predicted.flip_s && predicted.measured_flip_s)
            flips_s.push_back(std::abs(predicted.flip_s->value - *predicted.measured_flip_s));
    }
    EXPECT_LT(sum / static_cast<double>(n), 0.02);
    std::sort(flips_s.begin(), flips_s.end());
    ASSERT_GT(flips_s.size(), 50U);
    EXPECT_LT(flips_s[flips_s.size() / 2], 0.002);
}

TEST(Prediction, NeedsRowsOnBothSides) {
    MadeRecording made(3);
    made.fly({{1.0, 0.8, 0.3}}, {1.0, 9.0, 2.0}, 1.0);
    const auto rows = made.rows({});
    MadeRecording more(4);
    more.fly({{1.0, 0.8, 0.3}}, {2.0, 8.0, 1.0}, 1.0);
    const auto others = more.rows({});
    EXPECT_THROW(predicted_alone(rows, rows.size()), InputError);
    EXPECT_THROW(predicted_alone(rows, 5), InputError);
    const std::vector<std::span<const MeasuredRow>> flights{rows, others};
    const JointFit joint = fit_together(flights);
    EXPECT_THROW(predicted_by_others(rows, 2, joint, 0), InputError);
    EXPECT_THROW(predicted_by_others(rows, rows.size(), joint, 0), InputError);
}

}  // namespace

}  // namespace poinsot
