#include "system/processor.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <thread>

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
    // "200000 100000" is two processors' time, "max 100000" no limit. Source: Linux, cgroup-v2.rst.
    std::ifstream limit("/sys/fs/cgroup/cpu.max");
    double granted = 0.0, period = 0.0;
    if (!(limit >> granted >> period) || granted <= 0.0 || period <= 0.0) return n_bound;
    return std::clamp(static_cast<int>(granted / period), 1, n_bound);
}

std::int64_t memory_MiB() {
    const std::int64_t pages = ::sysconf(_SC_PHYS_PAGES), page_bytes = ::sysconf(_SC_PAGESIZE);
    return pages > 0 && page_bytes > 0 ? pages / 1024 * page_bytes / 1024 : 0;
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
