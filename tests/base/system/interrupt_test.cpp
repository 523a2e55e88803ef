// Ctrl-C stops work that checks for it cleanly, and ends other work at once.
#include "system/interrupt.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <optional>

#include "error/error.h"

namespace poinsot {
namespace {

// Each case runs in a separate process, since a recorded signal stays recorded.
int stops_cleanly(int signal_number) {
    watch_for_interrupts();
    stop_if_interrupted();
    std::raise(signal_number);
    try {
        stop_if_interrupted();
    } catch (const EnvironmentError&) {
        return 7;
    }
    return 0;
}

TEST(Interrupt, StopsWorkThatChecks) {
    for (const int signal_number : {SIGINT, SIGTERM, SIGHUP})
        EXPECT_EXIT(std::_Exit(stops_cleanly(signal_number)), testing::ExitedWithCode(7), "");
}

TEST(Interrupt, LeavesAnIgnoredHangupIgnored) {
    EXPECT_EXIT(
        {
            std::signal(SIGHUP, SIG_IGN);
            std::_Exit(stops_cleanly(SIGHUP));
        },
        testing::ExitedWithCode(0), "");
}

TEST(Interrupt, EndsTheProcessAtTheSecondSignal) {
    EXPECT_EXIT(
        {
            stops_cleanly(SIGINT);
            std::raise(SIGINT);
        },
        testing::KilledBySignal(SIGINT), "");
}

// Two objects at a time, as when one picture is read while another is drawn: destroying the first
// leaves the second in effect.
TEST(Interrupt, EndsWorkThatDoesNotCheck) {
    EXPECT_EXIT(
        {
            std::optional<EndsAtOnce> reading{std::in_place};
            const EndsAtOnce drawing;
            watch_for_interrupts();
            reading.reset();
            std::raise(SIGTERM);
        },
        testing::KilledBySignal(SIGTERM), "");
    EXPECT_EXIT(
        {
            std::optional<EndsAtOnce> reading{std::in_place};
            reading.reset();
            std::_Exit(stops_cleanly(SIGINT));
        },
        testing::ExitedWithCode(7), "");
}

}  // namespace
}  // namespace poinsot
