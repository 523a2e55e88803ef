#include "output/frame_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

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

std::vector<std::int64_t> frames_there(const std::filesystem::path& pattern) {
    std::vector<std::int64_t> frames;
    const std::string name = pattern.filename().string();
    const std::size_t start = name.find('#');
    const std::string_view front = std::string_view(name).substr(0, start);
    const std::filesystem::path folder = pattern.has_parent_path() ? pattern.parent_path() : ".";
    std::error_code error;
    std::filesystem::directory_iterator at(folder, error);
    for (; !error && at != std::filesystem::directory_iterator(); at.increment(error)) {
        const std::string found = at->path().filename().string();
        if (!found.starts_with(front)) continue;
        std::int64_t frame = 0;
        const auto [end, failed] =
            std::from_chars(found.data() + front.size(), found.data() + found.size(), frame);
        // Only the exact name of that frame counts.
        if (failed == std::errc{} && frame >= 0 && frame_name(pattern, frame).filename() == found)
            frames.push_back(frame);
    }
    std::sort(frames.begin(), frames.end());
    return frames;
}

}  // namespace poinsot
