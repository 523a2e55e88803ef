// Fault injection: a child process with limited resources.
#pragma once

#include <fcntl.h>
#include <grp.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <system_error>
#include <vector>

#include "error/error.h"
#include "temporary_folder.h"

namespace poinsot {

// Runs the action in a child process. Returns "" if it succeeded, the message of the
// EnvironmentError that it threw, or "other: …" for any other outcome.
inline std::string outcome_in_child(const std::function<void()>& action) {
    std::array<int, 2> pipe_ends{};
    if (pipe(pipe_ends.data()) != 0) return "other: no pipe";
    const pid_t child = fork();
    if (child == 0) {
        close(pipe_ends[0]);
        std::string outcome;
        try {
            action();
        } catch (const EnvironmentError& error) {
            outcome = error.what();
        } catch (const std::exception& error) {
            outcome = std::string("other: ") + error.what();
        }
        const ssize_t n = write(pipe_ends[1], outcome.data(), outcome.size());
        _exit(n == static_cast<ssize_t>(outcome.size()) ? 0 : 1);
    }
    close(pipe_ends[1]);
    std::string outcome;
    std::array<char, 4096> buffer{};
    for (ssize_t n = 0; (n = read(pipe_ends[0], buffer.data(), buffer.size())) > 0;)
        outcome.append(buffer.data(), static_cast<std::size_t>(n));
    close(pipe_ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) outcome = "other: the child process died";
    return outcome;
}

// Only in a child: limits the size of files, as `ulimit -f` does.
inline void limit_file_size(rlim_t n_bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{n_bytes, n_bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
}

// Only in a child: drops root's permission to write everywhere.
inline void drop_privileges() {
    constexpr uid_t nobody = 65534;
    if (geteuid() != 0) return;
    if (setgroups(0, nullptr) != 0 || setgid(nobody) != 0 || setuid(nobody) != 0)
        throw std::runtime_error("privileges could not be dropped");
}

// Only in a child: mounts a file system of this size on the folder. Returns false if this machine
// does not permit that.
inline bool mount_small(const std::filesystem::path& folder, const std::string& size) {
    // Others than root mount in a namespace of users of their own.
    const uid_t user = geteuid();
    const gid_t group = getegid();
    if (unshare(user == 0 ? CLONE_NEWNS : CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
    if (user != 0) {
        std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
        std::ofstream("/proc/self/setgroups") << "deny";
        std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
    }
    mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr);
    return mount("tmpfs", folder.c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
}

inline constexpr const char* no_mount = "other: this machine does not let us mount";

}  // namespace poinsot
