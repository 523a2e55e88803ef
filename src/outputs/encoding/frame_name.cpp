#include "encoding/frame_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
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

namespace {

// The number of the frame of a pattern that has this name. Only its exact name counts.
std::optional<std::int64_t> frame_of(const std::string& name,
                                     const std::filesystem::path& pattern) {
    const std::string pattern_name = pattern.filename().string();
    const std::size_t n_front = pattern_name.find('#');
    if (name.compare(0, n_front, pattern_name, 0, n_front) != 0) return std::nullopt;
    std::int64_t frame = 0;
    const auto [end, failed] =
        std::from_chars(name.data() + n_front, name.data() + name.size(), frame);
    if (failed != std::errc{} || frame < 0 || frame_name(pattern, frame).filename() != name)
        return std::nullopt;
    return frame;
}

}  // namespace

bool is_frame_of(const std::filesystem::path& file, const std::filesystem::path& pattern) {
    return frame_of(file.filename().string(), pattern).has_value();
}

std::string with_film_length(const std::string& name, std::int64_t n_frames,
                             const FrameRate& rate) {
    return fmt::format("{} ({:.4g} s of film)", name,
                       static_cast<double>(n_frames) / rate.per_second());
}

std::vector<std::int64_t> frames_there(const std::filesystem::path& pattern) {
    std::vector<std::int64_t> frames;
    const std::filesystem::path folder = pattern.has_parent_path() ? pattern.parent_path() : ".";
    std::error_code error;
    std::filesystem::directory_iterator at(folder, error);
    for (; !error && at != std::filesystem::directory_iterator(); at.increment(error)) {
        if (const auto frame = frame_of(at->path().filename().string(), pattern))
            frames.push_back(*frame);
    }
    std::sort(frames.begin(), frames.end());
    return frames;
}

}  // namespace poinsot
