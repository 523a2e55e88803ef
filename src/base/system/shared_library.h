// A shared library loaded at run time, and its functions by name.
#pragma once

#include <dlfcn.h>
#include <sys/resource.h>

#include <string>
#include <string_view>

#include "error/error.h"

namespace poinsot {

// The library is never unloaded: Mesa keeps threads and thread-local data that outlive a context.
class SharedLibrary {
 public:
    // Throws EnvironmentError saying what to install, as "the Debian package libegl1", or that
    // there is no memory for the library.
    SharedLibrary(const char* file, const char* what_to_install)
        : handle_(dlopen(file, RTLD_NOW | RTLD_LOCAL)), file_(file) {
        if (handle_ != nullptr) return;
        const char* const reason = dlerror();
        const std::string_view why = reason == nullptr ? "" : reason;
        // Of a library that is there: "failed to map segment from shared object", "cannot allocate
        // memory in static TLS block" and others.
        const bool is_missing = why.find("cannot open shared object file") != why.npos &&
                                why.find("No such file") != why.npos;
        if (is_missing)
            throw EnvironmentError(std::string("cannot open ") + file + "; install " +
                                   what_to_install);
        throw EnvironmentError(std::string("cannot load ") + file + ": " + std::string(why) +
                               (memory_is_limited() ? "; raise the limit of memory (ulimit -v, -d)"
                                                    : std::string("; install ") + what_to_install));
    }

    template <class Function>
    Function* function(const char* name) const {
        void* found = dlsym(handle_, name);
        if (found == nullptr) throw EnvironmentError(file_ + " has no function " + name);
        return reinterpret_cast<Function*>(found);
    }

 private:
    static bool memory_is_limited() {
        rlimit limit{};
        return (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) ||
               (getrlimit(RLIMIT_DATA, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY);
    }

    void* handle_;
    std::string file_;
};

}  // namespace poinsot
