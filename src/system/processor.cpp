#include "system/processor.h"

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

}  // namespace poinsot
