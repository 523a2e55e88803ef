#include "production/films/sidecar_place.h"

#include <fmt/format.h>

#include <system_error>

#include "system/files/own_files.h"

namespace poinsot {

void check_sidecar(const std::filesystem::path& path, std::string_view beginning,
                   std::string_view contents) {
    const std::string what = fmt::format("the film's {}", contents);
    check_replaceable({.path = path, .is_own = sealed_with(beginning), .what = what});
}

void remove_stale_sidecar(const std::filesystem::path& path, std::string_view beginning) {
    std::error_code ignored;
    if (is_own_file(path, sealed_with(beginning))) std::filesystem::remove(path, ignored);
}

}  // namespace poinsot
