#include "scene/frame_rate.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numeric>

namespace poinsot {

namespace {

TEST(FrameRate, BroadcastDecimalsAreTheirRatios) {
    EXPECT_EQ(rate_of_decimal(23.976), RateRatio(24000, 1001));
    EXPECT_EQ(rate_of_decimal(29.97), RateRatio(30000, 1001));
    EXPECT_EQ(rate_of_decimal(59.94), RateRatio(60000, 1001));
    EXPECT_EQ(rate_of_decimal(119.88), RateRatio(120000, 1001));
}

TEST(FrameRate, OtherDecimalsAreExact) {
    EXPECT_EQ(rate_of_decimal(30.0), RateRatio(30, 1));
    EXPECT_EQ(rate_of_decimal(12.5), RateRatio(25, 2));
    EXPECT_EQ(rate_of_decimal(0.001), RateRatio(1, 1000));
    EXPECT_EQ(rate_of_decimal(1000.0), RateRatio(1000, 1));
}

TEST(FrameRate, InvalidRatesGiveNone) {
    for (const double bad : {0.0, -30.0, 0.0001, 1000.5, 1e300, std::nan(""), HUGE_VAL, 29.97001}) {
        EXPECT_FALSE(rate_of_decimal(bad)) << bad;
    }
    for (const char* const bad :
         {"", "/", "30/", "/1", "30/0", "0/30", "-30/1", "30/-1", "a", "30 ", "30/1/1",
          "3000000/1001", "99999999999999999999/1", "1001/1", "1/1001", "nan", "inf"}) {
        EXPECT_FALSE(rate_of_text(bad)) << bad;
    }
}

TEST(FrameRate, RatiosAreReduced) {
    EXPECT_EQ(rate_of_text("60/2"), RateRatio(30, 1));
    EXPECT_EQ(rate_of_text("30000/1001"), RateRatio(30000, 1001));
    EXPECT_EQ(rate_of_text("24"), RateRatio(24, 1));
    EXPECT_EQ(rate_of_text("29.97"), RateRatio(30000, 1001));
}

TEST(FrameRate, TextIsReadBack) {
    EXPECT_TRUE(rc::check([] {
        const std::int64_t denominator = *rc::gen::inRange<std::int64_t>(1, 2000);
        const std::int64_t numerator =
            *rc::gen::inRange<std::int64_t>((denominator + 999) / 1000, 1000 * denominator);
        const std::int64_t common = std::gcd(numerator, denominator);
        RC_PRE(numerator / common <= 1'000'000);
        const RateRatio rate{numerator / common, denominator / common};
        RC_ASSERT(rate_of_text(text_of_rate(rate)) == rate);
    }));
}

}  // namespace

}  // namespace poinsot
