// Too small limits of memory and stack are refused by name.
#include "system/files/memory_limits.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <functional>
#include <string>

#include "error/error.h"
#include "sanitized.h"

namespace poinsot {
namespace {

constexpr rlim_t MiB = 1 << 20;

// In a process of its own: 7 if the check refuses with these words in one line, 0 if it accepts.
int checked_within(decltype(RLIMIT_AS) resource, rlim_t bytes, const std::function<void()>& check,
                   const std::string& words) {
    const rlimit limit{bytes, RLIM_INFINITY};
    if (setrlimit(resource, &limit) != 0) return 1;
    try {
        check();
    } catch (const EnvironmentError& error) {
        const std::string said = error.what();
        return said.find(words) != std::string::npos && said.find('\n') == std::string::npos ? 7
                                                                                             : 2;
    }
    return 0;
}

void need_half_a_GiB() {
    check_memory("this test", {.address_MiB = 512, .data_MiB = 512, .n_threads = 1});
}

TEST(MemoryLimits, NameTheLimitThatIsTooSmall) {
    // More than the need, since the process itself and the thread's stack count, too; a sanitizer's
    // shadow memory would count as address space.
    for (const auto& [resource, letter] :
         {std::pair{RLIMIT_AS, "(ulimit -v)"}, std::pair{RLIMIT_DATA, "(ulimit -d)"}})
        EXPECT_EXIT(std::_Exit(checked_within(resource, 512 * MiB, need_half_a_GiB, letter)),
                    testing::ExitedWithCode(7), "");
    // A sanitizer takes more than that.
    if (!sanitized) {
        EXPECT_EXIT(std::_Exit(checked_within(RLIMIT_DATA, 4096 * MiB, need_half_a_GiB, "")),
                    testing::ExitedWithCode(0), "");
    }
    EXPECT_EXIT(std::_Exit(checked_within(RLIMIT_AS, RLIM_INFINITY, need_half_a_GiB, "")),
                testing::ExitedWithCode(0), "");
}

TEST(MemoryLimits, NameASmallStack) {
    EXPECT_EXIT(std::_Exit(checked_within(RLIMIT_STACK, MiB / 4, check_stack, "256 kB")),
                testing::ExitedWithCode(7), "");
    EXPECT_EXIT(std::_Exit(checked_within(RLIMIT_STACK, MiB, check_stack, "")),
                testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace poinsot
