#include "trust/failing_disk.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <mutex>

namespace poinsot::testing {
namespace {

std::mutex mutex;  // guards the variables below
std::string watched;
DiskFault fault;
std::int64_t n_calls = 0, n_names = 0, n_bytes_left = 0;
bool struck = false;
std::array<bool, 4096> is_watched_file{};

template <typename Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

bool is_below(const char* path) {
    return !watched.empty() && std::strncmp(path, watched.c_str(), watched.size()) == 0;
}

// The result of a modifying call: 0 if it may proceed, or an error number.
int verdict() {
    ++n_calls;
    if (fault.kind == DiskFault::Kind::kill && n_calls >= fault.n) {
        struck = true;
        return EIO;
    }
    if (fault.kind == DiskFault::Kind::error && n_calls == fault.n) {
        struck = true;
        return fault.error_number;
    }
    return 0;
}

int failed(int error_number) {
    errno = error_number;
    return -1;
}

int open_watched(const char* name, const char* path, int flags, mode_t mode) {
    const auto real = next<int (*)(const char*, int, ...)>(name);
    const std::lock_guard lock(mutex);
    const bool writes = (flags & (O_WRONLY | O_RDWR | O_CREAT | O_TRUNC)) != 0;
    const bool counts = writes && is_below(path);
    if (counts)
        if (const int error_number = verdict(); error_number != 0) return failed(error_number);
    const int descriptor = real(path, flags, mode);
    if (descriptor >= 0 && descriptor < static_cast<int>(is_watched_file.size()))
        is_watched_file[static_cast<std::size_t>(descriptor)] = counts;
    return descriptor;
}

bool is_watched(int descriptor) {
    return descriptor >= 0 && descriptor < static_cast<int>(is_watched_file.size()) &&
           is_watched_file[static_cast<std::size_t>(descriptor)];
}

// A call with a file name; `renames`: whether the call gives a file its final name.
template <typename Call>
int on_name(const char* path, bool renames, const Call& call) {
    const std::lock_guard lock(mutex);
    if (!is_below(path)) return call();
    if (const int error_number = verdict(); error_number != 0) return failed(error_number);
    const int result = call();
    if (renames && result == 0) ++n_names;
    return result;
}

}  // namespace

void watch_folder(const std::string& folder) {
    const std::lock_guard lock(mutex);
    watched = folder;
}

void set_fault(const DiskFault& wanted) {
    const std::lock_guard lock(mutex);
    fault = wanted;
    n_calls = n_names = 0;
    n_bytes_left = wanted.n;
    struck = false;
}

std::int64_t n_disk_calls() {
    const std::lock_guard lock(mutex);
    return n_calls;
}

std::int64_t n_renames() {
    const std::lock_guard lock(mutex);
    return n_names;
}

bool has_struck() {
    const std::lock_guard lock(mutex);
    return struck;
}

}  // namespace poinsot::testing

// The C library's functions. A write that is interrupted by a kill or a full disk is written in
// part.
extern "C" {

ssize_t write(int descriptor, const void* bytes, size_t size) {
    using namespace poinsot::testing;
    static const auto real = next<ssize_t (*)(int, const void*, size_t)>("write");
    const std::lock_guard lock(mutex);
    if (!is_watched(descriptor)) return real(descriptor, bytes, size);
    const bool was_struck = struck;
    if (const int error_number = verdict(); error_number != 0) {
        const bool cut = fault.kind == DiskFault::Kind::kill && !was_struck && size > 1;
        if (cut && real(descriptor, bytes, size / 2) < 0) return -1;
        return failed(error_number);
    }
    if (fault.kind == DiskFault::Kind::full) {
        if (n_bytes_left <= 0 && size > 0) {
            struck = true;
            return failed(ENOSPC);
        }
        size = std::min(size, static_cast<size_t>(n_bytes_left));
        n_bytes_left -= static_cast<std::int64_t>(size);
    }
    return real(descriptor, bytes, size);
}

int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return poinsot::testing::open_watched("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return poinsot::testing::open_watched("open64", path, flags, mode);
}

int close(int descriptor) {
    using namespace poinsot::testing;
    static const auto real = next<int (*)(int)>("close");
    const std::lock_guard lock(mutex);
    if (is_watched(descriptor)) is_watched_file[static_cast<std::size_t>(descriptor)] = false;
    return real(descriptor);
}

int fsync(int descriptor) {
    using namespace poinsot::testing;
    static const auto real = next<int (*)(int)>("fsync");
    const std::lock_guard lock(mutex);
    if (!is_watched(descriptor)) return watched.empty() ? real(descriptor) : 0;
    const int error_number = verdict();
    return error_number == 0 ? 0 : failed(error_number);
}

int ftruncate(int descriptor, off_t size) {
    using namespace poinsot::testing;
    static const auto real = next<int (*)(int, off_t)>("ftruncate");
    const std::lock_guard lock(mutex);
    if (!is_watched(descriptor)) return real(descriptor, size);
    const int error_number = verdict();
    return error_number == 0 ? real(descriptor, size) : failed(error_number);
}

int rename(const char* from, const char* to) {
    static const auto real = poinsot::testing::next<int (*)(const char*, const char*)>("rename");
    return poinsot::testing::on_name(to, true, [&] { return real(from, to); });
}

int unlink(const char* path) {
    static const auto real = poinsot::testing::next<int (*)(const char*)>("unlink");
    return poinsot::testing::on_name(path, false, [&] { return real(path); });
}

int remove(const char* path) {
    static const auto real = poinsot::testing::next<int (*)(const char*)>("remove");
    return poinsot::testing::on_name(path, false, [&] { return real(path); });
}

}  // extern "C"
