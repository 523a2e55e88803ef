// One body behind many flights: made ones, whose body is known, and real throws of one racket.
#include "measured/joint_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "error/error.h"
#include "measured/made_recording.h"
#include "places.h"

namespace poinsot {

namespace {

using testing::MadeRecording;
using testing::ThrownBody;

std::vector<std::span<const MeasuredRow>> spans_of(
    const std::vector<std::vector<MeasuredRow>>& tables) {
    return {tables.begin(), tables.end()};
}

// Flights of one body, of which each is cut exactly.
std::vector<std::vector<MeasuredRow>> made_flights(const ThrownBody& body, int n, unsigned seed,
                                                   double noise) {
    std::vector<std::vector<MeasuredRow>> tables;
    MadeRecording random(seed);
    for (int i = 0; i < n; ++i) {
        MadeRecording one(1000 * seed + static_cast<unsigned>(i));
        const double rate = 7.0 + 10.0 * random.unit();
        // One after the other: the order of arguments is the compiler's.
        const double along_e3 = random.unit() - 0.5, along_e1 = random.unit() - 0.5;
        one.fly(body, rate * (body.axes * Eigen::Vector3d(along_e1, 1.0, along_e3)), 1.0);
        tables.push_back(one.rows({.noise_rad_s = noise}));
    }
    return tables;
}

// The body lies within 1.96 standard deviations in 95 of 100 cases, and mostly smaller than those
// of one flight.
TEST(JointFit, FindsTheBodyWithinItsStatedDeviations) {
    constexpr int n_bodies = 25, n_flights = 5;
    int covered = 0, n = 0, n_better = 0;
    for (unsigned seed = 1; seed <= n_bodies; ++seed) {
        MadeRecording axes(seed);
        // Linear drag is what is fitted: none here.
        const ThrownBody body{{1.0, 0.8, 0.3}, axes.rotation(), Eigen::Vector3d::Zero()};
        const auto tables = made_flights(body, n_flights, seed, 0.1);
        const JointFit joint = fit_together(spans_of(tables), {}, DragModel::linear);
        ASSERT_EQ(joint.n_used, static_cast<std::size_t>(n_flights));
        const auto count = [&](double error, double sd) {
            covered += std::abs(error) <= 1.96 * sd;
            ++n;
        };
        count(joint.moments[1] - 0.8, joint.moments_sd[1]);
        count(joint.moments[2] - 0.3, joint.moments_sd[2]);
        Eigen::Matrix3d true_axes = body.axes;
        for (int k = 0; k < 3; ++k)
            if (true_axes.col(k).dot(joint.instrument_from_principal.col(k)) < 0.0)
                true_axes.col(k) *= -1.0;
        const Eigen::Matrix3d turn = joint.instrument_from_principal.transpose() * true_axes;
        count(turn(2, 1), joint.axes_sd_rad[0]);
        count(turn(0, 2), joint.axes_sd_rad[1]);
        count(turn(1, 0), joint.axes_sd_rad[2]);
        std::vector<double> alone;
        for (const JointFlight& flight : joint.flights)
            if (flight.own) alone.push_back(flight.own->moments_sd[2]);
        std::sort(alone.begin(), alone.end());
        n_better += joint.moments_sd[2] < alone[alone.size() / 2];
    }
    // Four standard deviations of the count; the larger of two deviations may cover more.
    EXPECT_GT(n_better, n_bodies * 9 / 10);
    EXPECT_GT(1.0 * covered / n, 0.95 - 4.0 * std::sqrt(0.95 * 0.05 / n));
}

TEST(JointFit, LeavesFlightsOfAnotherBodyOut) {
    MadeRecording axes(7);
    const ThrownBody body{{1.0, 0.8, 0.3}, axes.rotation(), Eigen::Vector3d::Zero()};
    const ThrownBody other{{1.0, 0.6, 0.5}, axes.rotation(), Eigen::Vector3d::Zero()};
    auto tables = made_flights(body, 6, 8, 0.02);
    tables.push_back(made_flights(other, 1, 9, 0.02).front());
    const JointFit joint = fit_together(spans_of(tables));
    EXPECT_EQ(joint.n_used, 6U);
    EXPECT_FALSE(joint.flights.back().left_out.empty());
    EXPECT_NEAR(joint.moments[2], 0.3, 4.0 * joint.moments_sd[2]);
}

// Of ω with quadratic drag, the three coefficients that all flights share.
TEST(JointFit, FindsTheDragThatFlightsShare) {
    MadeRecording axes(10);
    const ThrownBody body{{1.0, 0.93, 0.07}, axes.rotation(), {0.02, 0.03, 0.01}};
    const auto tables = made_flights(body, 6, 11, 0.005);
    const JointFit joint = fit_together(spans_of(tables), {}, DragModel::quadratic, true);
    ASSERT_TRUE(joint.shares_drag);
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(joint.drag_rates[k], body.drag[k], 4.0 * joint.drag_rates_sd[k] + 1e-4) << k;
}

// Throws of a racket, in two halves: they agree within what is stated, and with pendulums.
TEST(JointFit, HalvesOfRealThrowsAgree) {
    std::vector<std::vector<MeasuredRow>> tables;
    const auto folder = source_folder() / "tests" / "motion" / "measured" / "racket";
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".csv") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& path : files) {
        std::ifstream file(path, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        tables.push_back(read_measured(text, path.string()).rows);
    }
    std::vector<std::span<const MeasuredRow>> halves[2];
    for (std::size_t i = 0; i < tables.size(); ++i) halves[i % 2].emplace_back(tables[i]);
    const JointFit first = fit_together(halves[0]), second = fit_together(halves[1]);
    for (const int k : {1, 2})
        EXPECT_NEAR(first.moments[k], second.moments[k],
                    3.0 * std::hypot(first.moments_sd[k], second.moments_sd[k]));
    for (const JointFit& joint : {first, second}) {
        EXPECT_NEAR(joint.moments[2], 0.067, 0.013);
        EXPECT_LT(joint.moments_sd[2], 0.005);
        EXPECT_GT(joint.n_used, 25U);
    }
}

// A measurement counts once: as a whole, and as a part that was cut from it.
TEST(JointFit, RefusesAFlightThatIsGivenTwice) {
    MadeRecording axes(14);
    const ThrownBody body{{1.0, 0.8, 0.3}, axes.rotation(), Eigen::Vector3d::Zero()};
    auto tables = made_flights(body, 3, 15, 0.02);
    EXPECT_FALSE(repeated_flight(spans_of(tables)));
    tables.push_back(tables[1]);
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(repeated_flight(spans_of(tables)), std::pair(std::size_t{1}, std::size_t{3}));
        EXPECT_THROW(fit_together(spans_of(tables)), InputError);
        tables.back().resize(40);
        for (MeasuredRow& row : tables.back()) row.time_s += 100.0;
    }
}

// Flights about one axis each, whose ω is exact or almost: none of them tells the body.
TEST(JointFit, RefusesSteadyFlights) {
    for (int i = 0; i < 40; ++i) {
        MadeRecording random(static_cast<unsigned>(100 + i));
        const ThrownBody body{{1.0, 0.8, 0.3}, random.rotation(), Eigen::Vector3d::Zero()};
        std::vector<std::vector<MeasuredRow>> tables;
        for (int k = 0; k < 4; ++k) {
            const Eigen::Vector3d omega =
                (4.0 + 6.0 * random.unit()) * body.axes.col((i + k) % 2 * 2);
            tables.emplace_back(100);
            for (std::size_t j = 0; j < tables.back().size(); ++j) {
                tables.back()[j].time_s = 0.01 * static_cast<double>(j);
                tables.back()[j].omega_body = omega + 1e-9 * (i % 2) * random.direction();
            }
        }
        EXPECT_THROW(fit_together(spans_of(tables)), InputError) << i;
    }
}

TEST(JointFit, RefusesFewerThanTwoFlights) {
    EXPECT_THROW(fit_together({}), InputError);
    MadeRecording axes(12);
    const ThrownBody body{{1.0, 0.8, 0.3}, axes.rotation()};
    EXPECT_THROW(fit_together(spans_of(made_flights(body, 1, 13, 0.02))), InputError);
}

}  // namespace

}  // namespace poinsot
