// Simulated disk faults for all file accesses of this process in one folder: failing_disk.cpp
// replaces the file system calls of the C library.
#pragma once

#include <cstdint>
#include <string>

namespace poinsot::testing {

// The fault to simulate. Modifying calls are counted: open for writing, write, fsync, ftruncate,
// rename, unlink.
struct DiskFault {
    enum class Kind {
        none,
        kill,   // from call n on nothing reaches the disk, as if the process had been killed
        error,  // call n fails once, with an error number
        full    // n more bytes can be written, then ENOSPC until the disk is freed
    };
    Kind kind = Kind::none;
    std::int64_t n = 0;
    int error_number = 0;
};

// Calls with names that start with `folder` are counted and may fail. fsync does nothing, since it
// is slow and its effect is the kernel's responsibility.
void watch_folder(const std::string& folder);

// Sets the fault from now on and resets the count. Kind::none: no fault.
void set_fault(const DiskFault& fault);

// Since then: the number of modifying calls, and the files that got their final names.
std::int64_t n_disk_calls();
std::int64_t n_renames();
// Whether the fault has occurred.
bool has_struck();

}  // namespace poinsot::testing
