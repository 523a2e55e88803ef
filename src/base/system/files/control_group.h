// The resource limits that Linux control groups set for a process in a container or cluster.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

namespace poinsot {

struct ResourceLimits {
    std::optional<double> n_processors;        // CPU time in processors; may be a fraction
    std::optional<std::int64_t> memory_bytes;  // the process is killed above this limit
};

// The smallest limits of a control group and its ancestors. Empty where there is no limit, or no
// such files (version 1, other systems). Source: Linux, admin-guide/cgroup-v2.rst.
// root: the mount point of the control groups
// own: the text of /proc/self/cgroup, of which the line "0::/PATH" is used
ResourceLimits resource_limits_of(const std::filesystem::path& root, std::string_view own);

// The limits of this process.
ResourceLimits process_resource_limits();

}  // namespace poinsot
