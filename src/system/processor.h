// What the processor can do, where pixels depend on it.
#pragma once

#include <string>

namespace poinsot {

// The widest vectors, and whether products are rounded before they are added: "x86 sse4.1 avx avx2
// fma". A renderer that is not told otherwise uses what is there.
std::string processor_capabilities();

}  // namespace poinsot
