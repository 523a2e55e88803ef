// The flights that are found in recordings: real ones, against the cuts of those who measured them,
// and made ones, whose flights are known.
#include "measured/flights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "measured/fit.h"
#include "measured/made_recording.h"
#include "mechanics/free/free_rotation.h"
#include "places.h"

namespace poinsot {

namespace {

using testing::Gyroscope;
using testing::MadeRecording;
using testing::ThrownBody;
using testing::TrueFlight;

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

struct Score {
    int n_found = 0, n_false = 0;
};

// A flight is found if both its ends are near; it is false if it overlaps no true one by half of
// its length.
Score score_of(const std::vector<FreeFlight>& found, const std::vector<TrueFlight>& truth,
               double most_off_s) {
    Score score;
    for (const TrueFlight& one : truth)
        for (const FreeFlight& flight : found)
            if (std::abs(flight.begin_s() - one.begin_s) < most_off_s &&
                std::abs(flight.end_s() - one.end_s) < most_off_s)
                ++score.n_found;
    for (const FreeFlight& flight : found) {
        double most = 0.0;
        for (const TrueFlight& one : truth)
            most = std::max(most, std::min(flight.end_s(), one.end_s) -
                                      std::max(flight.begin_s(), one.begin_s));
        if (most < 0.5 * (flight.end_s() - flight.begin_s())) ++score.n_false;
    }
    return score;
}

TEST(Flights, OfARealRecordingAreThoseThatItsAuthorsCut) {
    const auto folder = source_folder() / "tests" / "motion" / "measured" / "recording";
    const auto table = read_measured(text_of(folder / "round3_093502.csv"), "recording");
    std::vector<TrueFlight> cuts;
    std::ifstream segments(folder / "round3_093502_segments.csv");
    std::string line;
    std::getline(segments, line);
    while (std::getline(segments, line)) {
        TrueFlight cut;
        ASSERT_EQ(std::sscanf(line.c_str(), "%*d,%lf,%lf", &cut.begin_s, &cut.end_s), 2) << line;
        cuts.push_back(cut);
    }
    ASSERT_EQ(cuts.size(), 25U);
    const Score score = score_of(flights_of(table.rows), cuts, 0.1);
    EXPECT_GE(score.n_found, 24);
    EXPECT_EQ(score.n_false, 0);
}

// A gyroscope on an air bearing, for 100 s: noise must not cut its motion into pieces.
TEST(Flights, ALongMotionWithNoiseIsOneFlight) {
    MadeRecording made(31);
    made.fly({{3.0, 2.0, 1.0}, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()},
             {0.3, 6.0, 0.2}, 100.0);
    const auto rows = made.rows({.noise_rad_s = 0.01});
    const auto found = flights_of(rows);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().rows.size(), rows.size());
    EXPECT_LT(found.front().residual_rad_s, 0.011);
}

// Throws about the middle axis of a body, with walking and catching between them.
MadeRecording thrown(unsigned seed, int n_throws, const std::vector<ThrownBody>& bodies) {
    MadeRecording made(seed);
    for (int i = 0; i < n_throws; ++i) {
        const int number = i % static_cast<int>(bodies.size());
        const ThrownBody& body = bodies[static_cast<std::size_t>(number)];
        made.walk(3.0 + 4.0 * made.unit());
        const double rate = 7.0 + 15.0 * made.unit();
        // One after the other: the order of arguments is the compiler's.
        const double along_e3 = 0.3 * (made.unit() - 0.5);
        const double along_e2 = made.unit() < 0.5 ? 1.0 : -1.0;
        const double along_e1 = 0.3 * (made.unit() - 0.5);
        const Eigen::Vector3d principal = rate * Eigen::Vector3d(along_e1, along_e2, along_e3);
        made.toss(body, body.axes * principal, 0.7 + 0.4 * made.unit(), number);
        made.hit();
    }
    made.walk(3.0);
    return made;
}

TEST(Flights, AreFoundAmongWalkingAndCatchingWithAnyGyroscope) {
    MadeRecording axes(1);
    const ThrownBody racket{{1.0, 0.93, 0.07}, axes.rotation()};
    const ThrownBody phone{{1.0, 0.8, 0.21}, axes.rotation(), {0.002, 0.002, 0.002}};
    unsigned seed = 2;
    int n_found = 0, n = 0;
    for (const ThrownBody& body : {racket, phone})
        for (const Gyroscope& gyroscope :
             {Gyroscope{50.0, 0.01}, Gyroscope{100.0, 0.01}, Gyroscope{100.0, 0.12},
              Gyroscope{100.0, 0.01, 0.6}, Gyroscope{100.0, 0.01, 0.0, 0.1}, Gyroscope{200.0, 0.03},
              Gyroscope{500.0, 0.05}}) {
            constexpr int n_throws = 5;
            MadeRecording made = thrown(++seed, n_throws, {body});
            const Score score = score_of(flights_of(made.rows(gyroscope)), made.flights(), 0.1);
            n_found += score.n_found;
            n += n_throws;
            EXPECT_EQ(score.n_false, 0) << gyroscope.rate_Hz;
        }
    // Measured: 270 of 280 in recordings of other seeds.
    EXPECT_GE(n_found, 0.9 * n);
}

TEST(Flights, OfTwoBodiesInOneRecordingAreFound) {
    MadeRecording axes(3);
    MadeRecording made = thrown(4, 12,
                                {{{1.0, 0.93, 0.07}, axes.rotation()},
                                 {{1.0, 0.6, 0.5}, axes.rotation(), {0.0, 0.0, 0.0}}});
    const Score score = score_of(flights_of(made.rows({})), made.flights(), 0.1);
    // Measured: 8 of 12 here, and 11 in another recording; a hand that turns the body steadily
    // looks free, too.
    EXPECT_GE(score.n_found, 7);
    EXPECT_EQ(score.n_false, 0);
}

// A ball that bounces: each flight ends where the next begins.
TEST(Flights, EndAtEachBounce) {
    MadeRecording made(5);
    const ThrownBody body{{1.0, 0.75, 0.5}, made.rotation(), {0.001, 0.001, 0.001}};
    made.walk(2.0);
    made.toss(body, {4.0, 9.0, -3.0}, 0.9);
    for (int i = 0; i < 4; ++i) {
        made.hit(0.01);
        made.fly(body, 11.0 * made.direction(), 0.8);
    }
    made.hit();
    made.walk(2.0);
    const Score score = score_of(flights_of(made.rows({200.0, 0.02})), made.flights(), 0.06);
    EXPECT_EQ(score.n_found, 5);
    EXPECT_EQ(score.n_false, 0);
}

// 2000 degrees a second is the usual limit. A flight reaches across the rows at the limit, and
// across rows that were lost.
TEST(Flights, ReachAcrossSaturationAndGaps) {
    MadeRecording made(6);
    const ThrownBody body{{1.0, 0.8, 0.3}, Eigen::Matrix3d::Identity(), {0.0, 0.0, 0.0}};
    made.walk(3.0);
    made.toss(body, {3.0, 30.0, 20.0}, 0.8);
    made.hit();
    made.walk(2.0);
    made.toss(body, {1.0, 12.0, 3.0}, 0.9);
    made.hit();
    made.walk(2.0);
    std::vector<MeasuredRow> rows = made.rows({.rate_Hz = 200.0, .limit_rad_s = 33.0});
    const double lost_s = made.flights()[1].begin_s + 0.4;
    std::erase_if(rows, [lost_s](const MeasuredRow& row) {
        return row.time_s > lost_s && row.time_s < lost_s + 0.05;
    });
    const auto found = flights_of(rows);
    const Score score = score_of(found, made.flights(), 0.1);
    EXPECT_EQ(score.n_found, 2);
    EXPECT_EQ(score.n_false, 0);
    std::size_t n_at_limit = 0;
    for (const FreeFlight& flight : found)
        for (const MeasuredRow& row : flight.rows)
            n_at_limit += row.omega_body.cwiseAbs().maxCoeff() >= 33.0;
    EXPECT_LE(n_at_limit, 4U);
}

// A long flight costs little more to find than to fit: no part of it is grown again and again.
TEST(Flights, OfAMotionThatNeverEndsCostSomeFits) {
    const FreeRotation free(
        InertiaTensor::from_matrix(Eigen::Vector3d(3.0, 2.0, 1.0).asDiagonal().toDenseMatrix()),
        RotationState{0.0, Eigen::Quaterniond::Identity(), {0.3, 6.0, 0.2}});
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 0.02);
    std::vector<MeasuredRow> rows(10'000);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].time_s = 0.01 * static_cast<double>(i);
        rows[i].omega_body = free.at(rows[i].time_s).omega_body +
                             Eigen::Vector3d(noise(random), noise(random), noise(random));
    }
    // Of the processor, so that other work does not matter.
    const std::clock_t start = std::clock();
    fit_motion(rows);
    const std::clock_t fitted = std::clock();
    const auto found = flights_of(rows);
    const std::clock_t end = std::clock();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().rows.size(), rows.size());
    EXPECT_LT(static_cast<double>(end - fitted), 5.0 * static_cast<double>(fitted - start));
}

TEST(Flights, AreNoneWhereNothingFlies) {
    for (unsigned seed = 10; seed < 14; ++seed) {
        MadeRecording made(seed);
        for (int i = 0; i < 5; ++i) {
            made.walk(10.0, 1.0 + 2.0 * made.unit());
            made.hit();
        }
        EXPECT_TRUE(flights_of(made.rows({})).empty()) << seed;
    }
    EXPECT_TRUE(flights_of({}).empty());
    EXPECT_TRUE(flights_of(std::vector<MeasuredRow>(1)).empty());
}

}  // namespace

}  // namespace poinsot
