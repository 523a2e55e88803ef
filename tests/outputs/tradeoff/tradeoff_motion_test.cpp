// The motion's table, of a free body, for which the exact motion is the reference; its CSV and its
// chart.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "production/session/film_plan.h"
#include "production/session/session.h"
#include "scene/parse_scene.h"
#include "tradeoff/tradeoff.h"
#include "tradeoff/tradeoff_report.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

constexpr double px_per_rad = 250.0;

const MotionTrades& trades() {
    static const MotionTrades made = [] {
        const Session session = session_of(
            parse_scene(
                "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.5]\n[start]\nomega_rad_s = [0.3, 1.0, 0.2]\n"
                "[film]\nsize = [64, 36]\nfps = 10\nduration_s = 6.0\n",
                "a.toml"),
            {installed_fonts()});
        return trade_motion(session, film_plan(session), px_per_rad);
    }();
    return made;
}

// The rows of a method, from its coarsest setting to its finest.
std::map<std::string, std::vector<MotionTrade>> rows_by_method() {
    std::map<std::string, std::vector<MotionTrade>> rows;
    for (const MotionTrade& row : trades().rows) rows[row.method].push_back(row);
    return rows;
}

TEST(TradeoffMotion, ErrorsFallAsTheOrderOfTheMethodSays) {
    // Each step is half of the one before: the error falls by 2 to the power of the order, which is
    // the method's in its source, where it is neither coarse nor rounding.
    const std::map<std::string, double> order_of{
        {"euler", 1.0}, {"midpoint", 2.0}, {"splitting", 2.0}, {"rk4", 4.0},
        {"rkmk4", 4.0}, {"dmv-2", 2.0},    {"dmv-4", 4.0},     {"dmv-6", 6.0}};
    const auto rows = rows_by_method();
    for (const auto& [method, order] : order_of) {
        ASSERT_TRUE(rows.contains(method)) << method;
        std::vector<double> slopes;
        const std::vector<MotionTrade>& of = rows.at(method);
        for (std::size_t i = 1; i < of.size(); ++i)
            if (of[i - 1].attitude_rad < 0.05 && of[i].attitude_rad > 1e-12)
                slopes.push_back(std::log2(of[i - 1].attitude_rad / of[i].attitude_rad));
        ASSERT_GE(slopes.size(), 2u) << method;
        std::nth_element(slopes.begin(),
                         slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2),
                         slopes.end());
        EXPECT_NEAR(slopes[slopes.size() / 2], order, 0.35) << method;
    }
}

TEST(TradeoffMotion, TheExactMotionIsItsOwnReference) {
    EXPECT_EQ(trades().truth, "exact");
    EXPECT_EQ(trades().n_frames, 60);
    const auto rows = rows_by_method();
    ASSERT_EQ(rows.at("exact").size(), 1u);
    const MotionTrade& exact = rows.at("exact").front();
    EXPECT_EQ(exact.attitude_rad, 0.0);
    EXPECT_TRUE(exact.on_front);
    EXPECT_LT(exact.energy, 1e-13);
    EXPECT_LT(exact.momentum, 1e-13);
}

TEST(TradeoffMotion, DriftsAreThoseThatTheMethodsAllow) {
    for (const MotionTrade& row : trades().rows) {
        EXPECT_GT(row.ns_a_frame, 0.0) << row.method;
        EXPECT_DOUBLE_EQ(row.displacement_px, row.attitude_rad * px_per_rad) << row.method;
        // These keep L in space by construction; Euler's method keeps nothing.
        if (row.method == "splitting" || row.method == "rkmk4" || row.method.starts_with("dmv")) {
            EXPECT_LT(row.momentum, 1e-10) << row.method << ' ' << row.setting;
        }
        if (row.method == "euler") {
            EXPECT_GT(row.energy, 1e-9) << row.setting;
        }
    }
}

TEST(TradeoffMotion, MoreEvaluationsAreNeededForSmallerSteps) {
    // Of explicit methods; implicit ones iterate less often in small steps.
    const auto rows = rows_by_method();
    for (const char* method : {"euler", "rk4", "rkmk4"}) {
        const std::vector<MotionTrade>& of = rows.at(method);
        for (std::size_t i = 1; i < of.size(); ++i)
            EXPECT_GT(of[i].evaluations_a_frame, of[i - 1].evaluations_a_frame) << method;
    }
}

TEST(TradeoffMotion, TheTableOfNumbersHasEveryRow) {
    Tradeoff all;
    all.motion = trades();
    std::istringstream lines(csv_of(all));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "table,name,setting,cost_ns_a_frame,error,error_is,on_front");
    std::size_t n = 0;
    while (std::getline(lines, line)) {
        ASSERT_LT(n, all.motion.rows.size());
        const MotionTrade& row = all.motion.rows[n++];
        std::vector<std::string> fields;
        std::istringstream parts(line);
        for (std::string field; std::getline(parts, field, ',');) fields.push_back(field);
        ASSERT_EQ(fields.size(), 7u) << line;
        EXPECT_EQ(fields[1], row.method);
        // Every digit: the same double is read back.
        EXPECT_EQ(std::stod(fields[3]), row.ns_a_frame);
        EXPECT_EQ(std::stod(fields[4]), row.attitude_rad);
        EXPECT_EQ(fields[6], row.on_front ? "true" : "false");
    }
    EXPECT_EQ(n, all.motion.rows.size());
}

TEST(TradeoffMotion, TheChartHasALineForEachMethodAndAPointForEachRow) {
    const Session session = session_of(
        parse_scene(
            "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.5]\n[start]\nomega_rad_s = [0.3, 1.0, 0.2]\n",
            "a.toml"),
        {installed_fonts()});
    Tradeoff all;
    all.motion = trades();
    const Chart chart = motion_chart(session, all);
    EXPECT_EQ(chart.series.size(), rows_by_method().size());
    std::size_t n = 0;
    for (const auto& series : chart.series) n += series.points.size();
    EXPECT_EQ(n, trades().rows.size());
}

}  // namespace
}  // namespace poinsot
