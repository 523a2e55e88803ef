// Instants on the command line: lists, ranges and files of them.
#include "cli/instants.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "cli/small_scene.h"
#include "cli/sweep.h"
#include "error/error.h"
#include "text/random_decimals.h"

namespace poinsot::testing {
namespace {

TEST(SampleTimes, ARangeGivesTheDoublesOfItsDecimals) {
    EXPECT_EQ(parse_times("0:1:0.1"),
              (std::vector<double>{0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}));
    EXPECT_EQ(parse_times("0:1/11"), parse_times("0:1:0.1"));
    EXPECT_EQ(parse_times("5:-1:-2,7"), (std::vector<double>{5.0, 3.0, 1.0, -1.0, 7.0}));
    EXPECT_EQ(parse_times("0:1:0.4"), (std::vector<double>{0.0, 0.4, 0.8}));
    EXPECT_EQ(parse_times("2:2:1"), std::vector<double>{2.0});
    // The ends of a division are the given numbers, whatever lies between.
    const std::vector<double> thirds = parse_times("-0.7:1e9/1000");
    ASSERT_EQ(thirds.size(), 1000u);
    EXPECT_EQ(thirds.front(), -0.7);
    EXPECT_EQ(thirds.back(), 1e9);
    // Every k/1000 is the double nearest to it.
    const std::vector<double> fine = parse_times("0:1000:0.001");
    ASSERT_EQ(fine.size(), 1'000'001u);
    for (std::size_t k = 0; k < fine.size(); ++k)
        ASSERT_EQ(fine[k], static_cast<double>(k) / 1000.0) << k;
}

TEST(SampleTimes, AreRoundedOnce) {
    // Rounded to 64 bits first, it would become the next double.
    EXPECT_EQ(parse_times("4.155289061186346"), std::vector<double>{4.155289061186346});
    EXPECT_EQ(parse_times("+4.155289061186346,1e-400"),
              (std::vector<double>{4.155289061186346, 0.0}));
    testing::RandomDecimals random(37);
    for (int i = 0; i < 100'000; ++i) {
        const std::string text = i % 4 == 0   ? random.near_a_middle(random.ordinary_double())
                                 : i % 4 == 1 ? random.any(300)
                                              : random.any(3);
        const double right = testing::read_by_mpfr(text);
        if (!std::isfinite(right)) continue;
        ASSERT_EQ(parse_times(text), std::vector<double>{right}) << text;
    }
}

// Compared with GMP's rationals: first + k·step, and first + k·(last − first)/(n − 1).
TEST(SampleTimes, OfARangeAreRoundedOnce) {
    using testing::Exact;
    testing::RandomDecimals random(38);
    for (int i = 0; i < 5'000; ++i) {
        const std::string first = random.any(i % 3 == 0 ? 12 : 1), last = random.any(3);
        const Exact a = Exact::of_decimal(first), b = Exact::of_decimal(last);
        const std::int64_t n = random.between(2, 40);
        const std::string range = first + ":" + last;
        const std::vector<double> divided = parse_times(range + "/" + std::to_string(n));
        ASSERT_EQ(divided.size(), static_cast<std::size_t>(n)) << range;
        const Sweep sweep = parse_sweep("a=" + range + ":" + std::to_string(n));
        ASSERT_EQ(sweep.values.size(), divided.size()) << range;
        for (std::int64_t k = 0; k < n; ++k) {
            const double right = (a + (b - a) * Exact(k) / Exact(n - 1)).nearest();
            ASSERT_EQ(divided[static_cast<std::size_t>(k)], right) << range << "/" << n;
            ASSERT_EQ(testing::read_by_mpfr(sweep.values[static_cast<std::size_t>(k)]), right)
                << range << ":" << n;
        }
        // 40 steps with the same number of digits, except where the last instant's rounding is a
        // tenth of a step.
        const std::string step = random.any(0);
        const Exact s = Exact::of_decimal(step);
        const double end = (a + s * Exact(40)).nearest();
        if (std::abs(end) > 1e14 * std::abs(s.nearest())) continue;
        const std::vector<double> stepped =
            parse_times(first + ":" + fmt::format("{}", end) + ":" + step);
        ASSERT_GE(stepped.size(), 40u) << first << " " << step;
        for (std::size_t k = 0; k < stepped.size(); ++k)
            ASSERT_EQ(stepped[k], (a + s * Exact(static_cast<std::int64_t>(k))).nearest())
                << first << " + " << k << " * " << step;
    }
}

TEST(SampleTimes, ABadRangeIsRefusedByName) {
    for (const char* bad : {"0:1", "0:1:0", "0:1:-0.1", "1:0:0.1", "0:1/1", "0:1/2.5", "0:1/0",
                            "0:x:1", "0:1:1:1", ":1:1", "0:1:1e-12", "0:1/1e12", "0:1/"}) {
        try {
            parse_times(bad);
            ADD_FAILURE() << bad;
        } catch (const InputError& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with("--times: \"" + std::string(bad)))
                << error.what();
        }
    }
}

TEST(SampleTimes, AreReadFromAFileAndStandardInput) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    folder.write("times.txt", "# seconds\n0, 0.5\r\n\n1e0 2 # and the last\n");
    const ProgramRun asked = run_program_in(folder, "sample scene.toml --times 0,0.5,1,2");
    ASSERT_EQ(asked.code, 0) << asked.err;
    EXPECT_EQ(run_program_in(folder, "sample scene.toml --times-file times.txt").out, asked.out);
    EXPECT_EQ(run_program_in(folder, "sample scene.toml --times - <times.txt").out, asked.out);
    EXPECT_EQ(run_program_in(folder, "sample scene.toml --times-file - <times.txt").out, asked.out);

    folder.write("bad.txt", "0\n 1 two\n");
    const ProgramRun bad = run_program_in(folder, "sample scene.toml --times-file bad.txt");
    EXPECT_EQ(bad.code, 2);
    EXPECT_EQ(bad.err,
              "bad.txt:2:4: \"two\" is not a time in seconds; write one instant per line\n");
    folder.write("empty.txt", "# nothing\n");
    for (const char* file : {"empty.txt", "missing.txt", "."}) {
        const ProgramRun run =
            run_program_in(folder, std::string("sample scene.toml --times-file ") + file);
        EXPECT_EQ(run.code, 2) << file;
        EXPECT_NE(run.err.find(file), std::string::npos) << run.err;
        EXPECT_EQ(run.out, "");
    }
    const ProgramRun none = run_program_in(folder, "sample scene.toml");
    EXPECT_EQ(none.code, 2);
    EXPECT_NE(none.err.find("give --times"), std::string::npos) << none.err;
    EXPECT_EQ(run_program_in(folder, "sample scene.toml --times 0 --times-file times.txt").code, 2);
}

}  // namespace
}  // namespace poinsot::testing
