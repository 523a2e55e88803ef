// The clock changes during a film and fits its place, for all spans and start times.
#include "drawing/stage/type/clock_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "typeset/files/installed_fonts.h"
#include "typeset/typesetter.h"

namespace poinsot {
namespace {

TEST(ClockText, ShowsSecondsForAFilmOfSeconds) {
    EXPECT_EQ(ClockText(0.0, 16.0).at(3.25), "$t$ = 3.25 s");
    EXPECT_EQ(ClockText(-6.5, 5.5).at(-6.5), "$t$ = \u22126.50 s");
    EXPECT_EQ(ClockText(0.0, 0.4).at(0.1), "$t$ = 0.10 s");
    EXPECT_EQ(ClockText(0.0, 5.2704e7).at(86400.0), "$t$ = 1.00 d");
}

TEST(ClockText, HasUnitsFromPicosecondsToGigayears) {
    EXPECT_EQ(ClockText(0.0, 5e-12).at(2.5e-12), "$t$ = 2.50 ps");
    EXPECT_EQ(ClockText(0.0, 1e-9).at(2.5e-10), "$t$ = 0.25 ns");
    EXPECT_EQ(ClockText(0.0, 1e-5).at(2.5e-6), "$t$ = 2.50 \u00b5s");
    EXPECT_EQ(ClockText(0.0, 1e-3).at(2.5e-4), "$t$ = 0.25 ms");
    EXPECT_EQ(ClockText(0.0, 1e9).at(365.25 * 86400.0), "$t$ = 1.00 yr");
    EXPECT_EQ(ClockText(0.0, 1e15).at(1e15), "$t$ = 31.69 Myr");
    EXPECT_EQ(ClockText(0.0, 1e18).at(1e18), "$t$ = 31.69 Gyr");
    // A minute of a film that starts at 1e15 s.
    EXPECT_EQ(ClockText(1e15, 1e15 + 60.0).at(1e15), "$t$ = 31.688088 Myr");
    EXPECT_EQ(ClockText(1e4, 1e4 + 1.0).at(1e4), "$t$ = 10000.00 s");
}

// The clock's width is 270 pixels at 1080 rows, an eighth of the picture's width.
TEST(ClockText, ChangesAndFitsAtAnySpan) {
    const Typesetter typesetter(installed_fonts());
    const TypeStyle style{.size_px = 26.0, .mode = TypeMode::text};
    for (int power = -320; power <= 300; power += 5) {
        const double span_s = std::pow(10.0, power);
        for (const double first_s : {0.0, -span_s, 1e3 * span_s, 1.0, 1e15}) {
            const ClockText clock(first_s, first_s + span_s);
            std::set<std::string> seen;
            for (int k = 0; k <= 20; ++k) {
                const std::string text = clock.at(first_s + k * span_s / 20.0);
                seen.insert(text);
                EXPECT_LE(typesetter.measure(text, style).advance_px, 270.0) << text;
            }
            // If eight digits are enough for both the instant and the span.
            if (first_s == 0.0 || first_s == -span_s) {
                EXPECT_GE(seen.size(), 20u) << span_s;
            }
        }
    }
}

}  // namespace
}  // namespace poinsot
