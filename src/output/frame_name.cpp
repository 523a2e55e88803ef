#include "output/frame_name.h"

#include <fmt/format.h>

namespace poinsot {

bool has_frame_number(const std::filesystem::path& pattern) {
    return pattern.filename().string().find('#') != std::string::npos;
}

std::filesystem::path frame_name(const std::filesystem::path& pattern, std::int64_t number) {
    std::string name = pattern.filename().string();
    const std::size_t start = name.find('#');
    const std::size_t end = name.find_first_not_of('#', start);
    const std::size_t n_digits = (end == std::string::npos ? name.size() : end) - start;
    name.replace(start, n_digits, fmt::format("{:0{}}", number, n_digits));
    return pattern.parent_path() / name;
}

}  // namespace poinsot
