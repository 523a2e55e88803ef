// What the processor can do, where pixels depend on it.
#pragma once

#include <cstdint>
#include <string>

namespace poinsot {

// The widest vectors, and whether products are rounded before they are added: "x86 sse4.1 avx avx2
// fma". A renderer that is not told otherwise uses what is there.
std::string processor_capabilities();

// Processors that this process may use: those it is bound to, or as much of them as its control
// groups grant, 1 at least.
int n_processors();

// Memory of the machine, or as much of it as the process's control groups grant; 0 if nobody says.
std::int64_t memory_MiB();

// Whether it has SSE4.1, the least that portable pictures are drawn with. True on other families,
// which the question is not for.
bool has_sse41();

}  // namespace poinsot
