#include "system/files/processor.h"

#include <unistd.h>

#include <algorithm>
#include <optional>
#include <thread>

#include "system/files/control_group.h"

namespace poinsot {

std::string processor_capabilities() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_cpu_init();
    std::string text = "x86";
    if (__builtin_cpu_supports("sse4.1")) text += " sse4.1";
    if (__builtin_cpu_supports("avx")) text += " avx";
    if (__builtin_cpu_supports("avx2")) text += " avx2";
    if (__builtin_cpu_supports("fma")) text += " fma";
    if (__builtin_cpu_supports("avx512f")) text += " avx512";
    return text;
#elif defined(__aarch64__)
    return "aarch64";
#else
    return "other";
#endif
}

int n_processors() {
    const int n_bound = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    const std::optional<double> granted = process_resource_limits().n_processors;
    return granted && *granted < n_bound ? std::max(1, static_cast<int>(*granted)) : n_bound;
}

std::int64_t memory_MiB() {
    constexpr std::int64_t MiB = 1 << 20;
    const std::int64_t pages = ::sysconf(_SC_PHYS_PAGES), page_bytes = ::sysconf(_SC_PAGESIZE);
    const std::int64_t all_MiB = pages > 0 && page_bytes > 0 ? pages / 1024 * page_bytes / 1024 : 0;
    const std::optional<std::int64_t> granted = process_resource_limits().memory_bytes;
    if (!granted) return all_MiB;
    const std::int64_t granted_MiB = std::max<std::int64_t>(1, *granted / MiB);
    return all_MiB > 0 ? std::min(all_MiB, granted_MiB) : granted_MiB;
}

bool has_sse41() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_cpu_init();
    return __builtin_cpu_supports("sse4.1") != 0;
#else
    return true;
#endif
}

}  // namespace poinsot
