// Ctrl-C stops cleanly what asks, and ends what does not.
#include "system/interrupt.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <optional>

#include "error/error.h"

namespace poinsot {
namespace {

// In a process of its own each: a signal that came is not forgotten.
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

TEST(Interrupt, IsAskedFor) {
    for (const int signal_number : {SIGINT, SIGTERM})
        EXPECT_EXIT(std::_Exit(stops_cleanly(signal_number)), testing::ExitedWithCode(7), "");
}

TEST(Interrupt, EndsTheProcessTheSecondTime) {
    EXPECT_EXIT(
        {
            stops_cleanly(SIGINT);
            std::raise(SIGINT);
        },
        testing::KilledBySignal(SIGINT), "");
}

// Two at a time, as where one picture is read while another is drawn: the first that goes leaves
// the other's.
TEST(Interrupt, EndsWhatDoesNotAsk) {
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
