// Gaps and saturation of measured tables.
#include "measured/table_faults.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace poinsot {
namespace {

std::vector<MeasuredRow> rows_at(const std::vector<double>& times_s) {
    std::vector<MeasuredRow> rows;
    for (const double time_s : times_s) {
        MeasuredRow row;
        row.time_s = time_s;
        row.omega_body = {std::sin(time_s), 1.0, std::cos(time_s)};
        rows.push_back(row);
    }
    return rows;
}

TEST(Gaps, AreStepsOfMoreThanThreeMedianSteps) {
    // Steps 1, 1, 3, 1, 1, 3.1, 1.
    const auto rows = rows_at({0.0, 1.0, 2.0, 5.0, 6.0, 7.0, 10.1, 11.1});
    const auto gaps = gaps_of(rows);
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_EQ(gaps[0].before, 5u);
    EXPECT_EQ(gaps[0].from_s, 7.0);
    EXPECT_EQ(gaps[0].to_s, 10.1);
    EXPECT_EQ(in_words(gaps), "no rows for 3.1 s from 7 s on");
    EXPECT_TRUE(gaps_of(rows_at({0.0, 100.0})).empty());  // one step is the usual one
    EXPECT_EQ(in_words(gaps_of(rows_at({0.0, 1.0, 2.0}))), "");
}

TEST(Stretches, EndAtGapsAndAtTheTimesAskedFor) {
    const auto rows = rows_at({0.0, 1.0, 2.0, 3.0, 9.0, 10.0, 11.0, 20.0});
    const auto stretches = stretches_of(rows, 1.0, 10.5);
    ASSERT_EQ(stretches.size(), 2u);
    EXPECT_EQ(stretches[0].front().time_s, 1.0);
    EXPECT_EQ(stretches[0].back().time_s, 3.0);
    EXPECT_EQ(stretches[1].front().time_s, 9.0);
    EXPECT_EQ(stretches[1].back().time_s, 10.0);
    EXPECT_TRUE(stretches_of(rows, 4.0, 8.0).empty());
}

// A sine of 40 rad/s that a sensor cuts at ±34.9.
TEST(Saturation, IsAnExtremeValueInThreeRowsOrMore) {
    std::vector<MeasuredRow> rows;
    std::size_t n_high = 0, n_low = 0;
    double first_high = -1.0;
    for (int i = 0; i < 400; ++i) {
        MeasuredRow row;
        row.time_s = 0.01 * i;
        const double omega = 40.0 * std::sin(3.0 * row.time_s + 0.1);
        row.omega_body = {5.0 * std::cos(row.time_s), std::min(std::max(omega, -34.9), 34.9), 0.0};
        n_high += row.omega_body[1] == 34.9;
        n_low += row.omega_body[1] == -34.9;
        if (first_high < 0.0 && row.omega_body[1] == 34.9) first_high = row.time_s;
        rows.push_back(row);
    }
    const auto found = saturations_of(rows);
    // A component that is zero throughout, and one whose extreme is a maximum, are not at a limit.
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].component, 1);
    EXPECT_EQ(found[0].value_rad_s, 34.9);
    EXPECT_EQ(found[0].n_rows, n_high);
    EXPECT_EQ(found[0].from_s, first_high);
    EXPECT_EQ(found[1].value_rad_s, -34.9);
    EXPECT_EQ(found[1].n_rows, n_low);
    EXPECT_EQ(in_words(found[0]).substr(0, 30), "omega_y stays at 34.9 rad/s fo");

    // Two rows at the extreme value may be the top of a curve.
    rows[50].omega_body[0] = rows[51].omega_body[0] = 7.0;
    EXPECT_EQ(saturations_of(rows).size(), 2u);
    rows[52].omega_body[0] = 7.0;
    EXPECT_EQ(saturations_of(rows).size(), 3u);
}

std::vector<MeasuredRow> rows_of(const std::vector<double>& omega_x) {
    std::vector<MeasuredRow> rows;
    for (std::size_t i = 0; i < omega_x.size(); ++i) {
        MeasuredRow row;
        row.time_s = 0.01 * static_cast<double>(i);
        row.omega_body = {omega_x[i], 0.0, 0.0};
        rows.push_back(row);
    }
    return rows;
}

TEST(Saturation, IsNeitherRestNorTheRoundedTopOfACurve) {
    // The body rests, then it is thrown.
    EXPECT_TRUE(saturations_of(rows_of({0.1, 0.1, 0.1, 0.1, 0.5, 1.5, 3.0, 2.0})).empty());
    EXPECT_TRUE(saturations_of(rows_of({3.0, 2.0, 1.5, 0.9, 1.0, 1.0, 1.0, 1.2})).empty());
    // A cosine near its top, rounded to 0.01 rad/s.
    std::vector<double> top;
    for (int i = -20; i <= 20; ++i) top.push_back(std::round(200.0 * std::cos(0.01 * i)) / 100.0);
    EXPECT_TRUE(saturations_of(rows_of(top)).empty());
}

// ω about a turning axis, of this size in rad/s, at this many rows a second.
std::vector<MeasuredRow> turning(double size, double rate_Hz, double unit_s = 1.0) {
    std::vector<MeasuredRow> rows(200);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double t = static_cast<double>(i) / rate_Hz;
        rows[i].time_s = t / unit_s;
        rows[i].omega_body = size * Eigen::Vector3d(std::sin(t), 0.3, std::cos(t));
    }
    return rows;
}

TEST(UnitDoubt, KnowsDegreesAndSmallerUnitsOfTime) {
    EXPECT_NE(unit_doubt_of(turning(600.0, 100.0)).find("look like degrees a second"),
              std::string::npos);
    EXPECT_NE(unit_doubt_of(turning(10.0, 100.0, 1e-3)).find("the times look like milliseconds"),
              std::string::npos);
    EXPECT_NE(unit_doubt_of(turning(10.0, 100.0, 1e-6)).find("the times look like microseconds"),
              std::string::npos);
    EXPECT_NE(unit_doubt_of(turning(10.0, 100.0, 1e-9)).find("the times look like nanoseconds"),
              std::string::npos);
}

TEST(UnitDoubt, IsNoneOfThrowsSlowTurnsAndMotionsOfPlanets) {
    for (const double size : {0.01, 1.0, 20.0, 34.9})
        EXPECT_EQ(unit_doubt_of(turning(size, 60.0)), "") << size;
    EXPECT_EQ(unit_doubt_of(turning(1e-4, 1e-3)), "");
    EXPECT_EQ(unit_doubt_of({}), "");
}

}  // namespace
}  // namespace poinsot
