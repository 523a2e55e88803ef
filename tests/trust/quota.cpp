// Preloaded by fault_matrix.py: simulates a disk quota of POINSOT_QUOTA bytes for regular files in
// the folder POINSOT_QUOTA_FOLDER. The write that exceeds it is done in part, later ones fail with
// EDQUOT; a quota of 0 also rejects new files, as a limit on their number does. For kernels without
// quotas, and for users who have none.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

const char* folder() {
    static const char* const name = std::getenv("POINSOT_QUOTA_FOLDER");
    return name;
}

std::atomic<long>& n_left() {
    static std::atomic<long> left = [] {
        const char* const text = std::getenv("POINSOT_QUOTA");
        return text ? std::atol(text) : 0L;
    }();
    return left;
}

bool in_folder(const char* path) {
    return folder() != nullptr && std::strncmp(path, folder(), std::strlen(folder())) == 0;
}

// Whether an open file is a regular one in the folder, by the kernel's path of it.
bool counts(int descriptor) {
    struct stat status {};
    if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return false;
    std::array<char, 64> link{};
    std::array<char, 4096> path{};
    std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", descriptor);
    return readlink(link.data(), path.data(), path.size() - 1) > 0 && in_folder(path.data());
}

template <typename Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

int open_within_quota(const char* name, const char* path, int flags, mode_t mode) {
    const bool makes = (flags & O_CREAT) != 0 && access(path, F_OK) != 0;
    if (makes && in_folder(path) && n_left() <= 0) {
        errno = EDQUOT;
        return -1;
    }
    return next<int (*)(const char*, int, ...)>(name)(path, flags, mode);
}

}  // namespace

extern "C" ssize_t write(int descriptor, const void* bytes, size_t size) {
    static const auto real = next<ssize_t (*)(int, const void*, size_t)>("write");
    if (size == 0 || !counts(descriptor)) return real(descriptor, bytes, size);
    const long allowed = std::min(static_cast<long>(size), n_left().load());
    if (allowed <= 0) {
        errno = EDQUOT;
        return -1;
    }
    n_left() -= allowed;
    return real(descriptor, bytes, static_cast<size_t>(allowed));
}

extern "C" int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return open_within_quota("open", path, flags, mode);
}

extern "C" int open64(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return open_within_quota("open64", path, flags, mode);
}
