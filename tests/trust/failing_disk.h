// A disk that fails as it is told, for all that this process does in one folder: its file system
// calls are answered here instead of by the C library (failing_disk.cpp defines them).
#pragma once

#include <cstdint>
#include <string>

namespace poinsot::testing {

// What is to happen, counted in the calls that change something: open for writing, write, fsync,
// ftruncate, rename, unlink.
struct DiskFault {
    enum class Kind {
        none,
        kill,   // from call n on nothing reaches the disk, as if the process had been killed there
        error,  // call n fails with an error number, once
        full    // n bytes more can be written, then ENOSPC until the disk is freed
    };
    Kind kind = Kind::none;
    std::int64_t n = 0;
    int error_number = 0;
};

// Calls on names that begin with it are counted and fail. Nothing is synced: that is the kernel's
// affair, and slow.
void watch_folder(const std::string& folder);

// Sets what happens from now on; the count begins anew. Under Kind::none all is well.
void set_fault(const DiskFault& fault);

// Since then: the calls that change something, and the files that got their names.
std::int64_t n_disk_calls();
std::int64_t n_renames();
// Whether the fault has struck.
bool has_struck();

}  // namespace poinsot::testing
