#include "system/files/memory_limits.h"

#include <fmt/format.h>
#include <malloc.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <optional>

#include "error/error.h"

namespace poinsot {

namespace {

constexpr std::int64_t MiB = 1 << 20;

// The most bytes that the process may have; none without a limit.
std::optional<std::int64_t> limit_of(decltype(RLIMIT_AS) resource) {
    rlimit limit{};
    constexpr rlim_t most = INT64_MAX;
    if (::getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY ||
        limit.rlim_cur > most)
        return std::nullopt;
    return static_cast<std::int64_t>(limit.rlim_cur);
}

struct Usage {
    std::int64_t address_bytes = 0, data_bytes = 0;
};

// 0 where /proc is missing.
Usage usage_now() {
    std::ifstream file("/proc/self/statm");
    std::int64_t size = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
    file >> size >> resident >> shared >> text >> library >> data;
    const std::int64_t page = ::sysconf(_SC_PAGESIZE);
    return {page * size, page * data};
}

std::int64_t stack_bytes_of_threads() {
    pthread_attr_t attributes;
    std::size_t bytes = 0;
    if (::pthread_getattr_default_np(&attributes) != 0) return 0;
    ::pthread_attr_getstacksize(&attributes, &bytes);
    ::pthread_attr_destroy(&attributes);
    return static_cast<std::int64_t>(bytes);
}

void check(std::string_view what, std::string_view of, char letter, std::int64_t needed,
           std::int64_t left) {
    if (needed <= left) return;
    throw EnvironmentError(
        fmt::format("{} needs {} MiB of {}, and the limit of this process (ulimit -{}) leaves {}; "
                    "raise the limit",
                    what, needed / MiB, of, letter, std::max<std::int64_t>(0, left) / MiB));
}

}  // namespace

void check_memory(std::string_view what, const MemoryNeed& need) {
    const std::optional<std::int64_t> address = limit_of(RLIMIT_AS), data = limit_of(RLIMIT_DATA);
    if (!address && !data) return;
    if (address) mallopt(M_ARENA_MAX, 1);
    static const Usage used = usage_now();
    const std::int64_t stacks = need.n_threads * stack_bytes_of_threads();
    if (address)
        check(what, "address space", 'v', MiB * need.address_MiB + stacks,
              *address - used.address_bytes);
    if (data) check(what, "memory", 'd', MiB * need.data_MiB + stacks, *data - used.data_bytes);
}

void check_stack() {
    // The commands, over the scenes that come along, take at most 96 kB.
    constexpr std::int64_t least_kB = 512;
    const std::optional<std::int64_t> stack = limit_of(RLIMIT_STACK);
    if (!stack || *stack >= 1024 * least_kB) return;
    throw EnvironmentError(
        fmt::format("poinsot needs a stack of {} kB, and the limit of this process (ulimit -s) is "
                    "{} kB; raise the limit",
                    least_kB, *stack / 1024));
}

void set_stack_of_threads() {
    pthread_attr_t attributes;
    if (::pthread_attr_init(&attributes) != 0) return;
    ::pthread_attr_setstacksize(&attributes, 8 * MiB);
    ::pthread_setattr_default_np(&attributes);
    ::pthread_attr_destroy(&attributes);
}

}  // namespace poinsot
