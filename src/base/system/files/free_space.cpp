#include "system/files/free_space.h"

#include <fmt/format.h>

#include <system_error>

#include "error/error.h"

namespace poinsot {

void check_free_space(const std::filesystem::path& path, std::uint64_t n_bytes_done,
                      std::int64_t n_done, std::int64_t n_frames) {
    if (n_done <= 0 || n_frames <= n_done) return;
    std::error_code error;
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    const std::filesystem::space_info space = std::filesystem::space(folder, error);
    if (error) return;
    constexpr double megabyte = 1e6;
    const double needed = static_cast<double>(n_bytes_done) / static_cast<double>(n_done) *
                          static_cast<double>(n_frames - n_done);
    if (needed > 2 * static_cast<double>(space.available))
        throw EnvironmentError(
            fmt::format("cannot write {}: the {} remaining frames need about {:.2g} MB, but only "
                        "{:.2g} MB are free",
                        path.string(), n_frames - n_done, needed / megabyte,
                        static_cast<double>(space.available) / megabyte));
}

}  // namespace poinsot
