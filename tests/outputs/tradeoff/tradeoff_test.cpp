// The Pareto front of a tradeoff, and the number of runs of a measurement.
#include "tradeoff/tradeoff.h"

#include <gtest/gtest.h>

#include "tradeoff/measure.h"

namespace poinsot {
namespace {

struct Row {
    double cost, error;
    bool on_front = false;
};

TEST(Tradeoff, NoRowOfTheFrontIsDominated) {
    std::vector<Row> rows{{1.0, 5.0}, {2.0, 2.0}, {3.0, 2.0}, {2.0, 3.0}, {4.0, 1.0}, {5.0, 5.0}};
    mark_front(rows, &Row::cost, &Row::error);
    const std::vector<bool> expected{true, true, false, false, true, false};
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].on_front, expected[i]) << i;
}

TEST(Tradeoff, EqualRowsAreOnTheFrontTogether) {
    std::vector<Row> rows{{1.0, 1.0}, {1.0, 1.0}};
    mark_front(rows, &Row::cost, &Row::error);
    EXPECT_TRUE(rows[0].on_front && rows[1].on_front);
}

TEST(Measure, RunsWithinTheRequestedLimits) {
    int n_calls = 0;
    const auto count = [&] { ++n_calls; };
    EXPECT_EQ(timed(count, 3, 25, 0.0).n_runs, 3);
    EXPECT_EQ(n_calls, 3);
    EXPECT_EQ(timed(count, 1, 7, 1e9).n_runs, 7);
    EXPECT_EQ(n_calls, 10);
}

}  // namespace
}  // namespace poinsot
