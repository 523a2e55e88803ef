#include "system/files/control_group.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace poinsot {

namespace {

// The group's path below the root; empty for the root itself, which a container sees as its own
// group.
std::filesystem::path group_of(std::string_view own) {
    constexpr std::string_view unified = "0::/";
    for (std::size_t at = 0; at < own.size();) {
        const std::size_t end = std::min(own.find('\n', at), own.size());
        const std::string_view line = own.substr(at, end - at);
        if (line.starts_with(unified))
            return std::filesystem::path(line.substr(unified.size())).relative_path();
        at = end + 1;
    }
    return {};
}

template <class Number>
void lower(std::optional<Number>& bound, Number other) {
    bound = std::min(bound.value_or(other), other);
}

}  // namespace

ResourceLimits resource_limits_of(const std::filesystem::path& root, std::string_view own) {
    ResourceLimits limits;
    std::filesystem::path group = group_of(own);
    while (true) {
        // "200000 100000" is the time of two processors; "max 100000" is no limit.
        std::ifstream processors(root / group / "cpu.max");
        double granted = 0.0, period = 0.0;
        if (processors >> granted >> period && granted > 0.0 && period > 0.0)
            lower(limits.n_processors, granted / period);
        std::ifstream memory(root / group / "memory.max");
        std::int64_t bytes = 0;
        if (memory >> bytes && bytes > 0) lower(limits.memory_bytes, bytes);
        if (group.empty()) return limits;
        group = group.parent_path();
    }
}

ResourceLimits process_resource_limits() {
    // If the file is not readable, no limit is known.
    std::ifstream groups("/proc/self/cgroup");
    std::string own;
    for (std::string line; std::getline(groups, line);) own += line + '\n';
    return resource_limits_of("/sys/fs/cgroup", own);
}

}  // namespace poinsot
