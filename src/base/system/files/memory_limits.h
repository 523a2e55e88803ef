// The limits of this process on memory and stack (ulimit -v, -d, -s), checked before code runs that
// a signal would end: Mesa does not check its allocations, and a full stack is a fault.
#pragma once

#include <cstdint>
#include <string_view>

namespace poinsot {

// What work takes beyond what the process has.
struct MemoryNeed {
    std::int64_t address_MiB = 0;  // address space, without the stacks of threads
    std::int64_t data_MiB = 0;     // private memory, without these stacks
    int n_threads = 0;             // each has a stack
};

// Throws EnvironmentError, which names the limit, if `what` needs more than the process may take.
// Compared with what the process had at its first call of this function, before such work began.
// If the address space is limited, malloc keeps one heap for all threads from then on: one for each
// would take 64 MiB of it.
void check_memory(std::string_view what, const MemoryNeed& need);

// Throws EnvironmentError if the stack is too small for any command.
void check_stack();

// Gives threads stacks of 8 MiB, whatever the limit of the main thread's is: by default they have
// that limit's size, and with a large one a limited address space has no room for them.
void set_stack_of_threads();

}  // namespace poinsot
