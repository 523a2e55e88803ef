// Processor features on which pixels depend.
#pragma once

#include <cstdint>
#include <string>

namespace poinsot {

// The widest vector instructions and fused multiply-add, which rounds differently: "x86 sse4.1 avx
// avx2 fma". By default, the renderer uses all that are available.
std::string processor_capabilities();

// The number of processors that this process may use, by its affinity and its control groups; at
// least 1.
int n_processors();

// The memory of the machine, or the limit of the process's control groups if smaller; 0 if unknown.
std::int64_t memory_MiB();

// Whether the processor has SSE4.1, the minimum for portable pictures. True on other architectures,
// where SSE4.1 does not apply.
bool has_sse41();

}  // namespace poinsot
