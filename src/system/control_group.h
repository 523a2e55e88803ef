// What Linux grants a process of the machine: containers and clusters bound it by control groups.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

namespace poinsot {

struct Grant {
    std::optional<double> n_processors;        // processors' time; not whole ones
    std::optional<std::int64_t> memory_bytes;  // past which the process is killed
};

// The least that a group and those above it grant. Nothing where nobody bounds it, or where the
// files are not there: version 1, other systems. Source: Linux, admin-guide/cgroup-v2.rst.
//   root  where the groups are mounted
//   own   the text of /proc/self/cgroup, of which the line "0::/PATH" counts
Grant grant_of(const std::filesystem::path& root, std::string_view own);

// The grant of this process.
Grant own_grant();

}  // namespace poinsot
