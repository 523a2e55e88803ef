#include "compare/pixel_differences.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>

namespace poinsot {

PixelMask::PixelMask(int width, int height, std::span<const PictureRegion> regions) {
    for (const PictureRegion& region : regions) {
        const int left = std::clamp(region.left, 0, width);
        const int top = std::clamp(region.top, 0, height);
        const auto end = [](int begin, int length, int most) {
            return static_cast<int>(
                std::clamp<std::int64_t>(std::int64_t{begin} + length, 0, most));
        };
        const int right = end(region.left, region.width, width);
        const int bottom = end(region.top, region.height, height);
        if (left >= right || top >= bottom) continue;
        bytes_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        for (int y = top; y < bottom; ++y)
            std::fill_n(bytes_.begin() + std::ptrdiff_t{y} * width + left, right - left,
                        std::uint8_t{1});
    }
    count_ = std::accumulate(bytes_.begin(), bytes_.end(), std::int64_t{0});
}

namespace {

struct Range {
    int least = 1 << 16, most = 0;
    void add(int value) { least = std::min(least, value), most = std::max(most, value); }
    bool has(int value) const { return least <= value && value <= most; }
};

// The range of each channel in the 3×3 pixels around one.
template <typename Sample>
std::array<Range, 4> ranges_around(const PictureSamples<Sample>& picture, int x, int y) {
    std::array<Range, 4> ranges;
    for (int j = std::max(0, y - 1); j <= std::min(picture.height - 1, y + 1); ++j) {
        for (int i = std::max(0, x - 1); i <= std::min(picture.width - 1, x + 1); ++i) {
            const std::size_t at =
                4 * (static_cast<std::size_t>(j) * static_cast<std::size_t>(picture.width) +
                     static_cast<std::size_t>(i));
            for (std::size_t c = 0; c < 4; ++c) ranges[c].add(picture.samples[at + c]);
        }
    }
    return ranges;
}

}  // namespace

template <typename Sample>
bool is_antialiasing(const PictureSamples<Sample>& a, const PictureSamples<Sample>& b, int x,
                     int y) {
    constexpr int least_contrast = 25 * samples_a_level<Sample>;
    const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) +
                                static_cast<std::size_t>(x));
    const std::array<Range, 4> around_a = ranges_around(a, x, y), around_b = ranges_around(b, x, y);
    bool is_edge = false;
    for (std::size_t c = 0; c < 4; ++c) {
        if (!around_a[c].has(b.samples[at + c]) || !around_b[c].has(a.samples[at + c]))
            return false;
        is_edge = is_edge || around_a[c].most - around_a[c].least >= least_contrast ||
                  around_b[c].most - around_b[c].least >= least_contrast;
    }
    return is_edge;
}

template <typename Sample>
void count_differences(const PictureSamples<Sample>& a, const PictureSamples<Sample>& b,
                       const CompareLimits& limits, const PixelMask& ignored, Comparison& result) {
    constexpr int a_level = samples_a_level<Sample>;
    const auto row_length = 4 * static_cast<std::size_t>(a.width);
    std::int64_t sum = 0;
    int largest_of_all = 0;
    for (int y = 0; y < a.height; ++y) {
        // Most rows are equal, and ten times as quickly found to be.
        const std::size_t row = static_cast<std::size_t>(y) * row_length;
        const auto row_a = a.samples.subspan(row, row_length);
        const auto row_b = b.samples.subspan(row, row_length);
        if (std::equal(row_a.begin(), row_a.end(), row_b.begin())) continue;
        for (int x = 0; x < a.width; ++x) {
            const std::size_t i = row + 4 * static_cast<std::size_t>(x);
            int largest = 0, sum_here = 0;
            for (std::size_t c = 0; c < 4; ++c) {
                const int difference = std::abs(int{a.samples[i + c]} - int{b.samples[i + c]});
                sum_here += difference;
                largest = std::max(largest, difference);
            }
            if (largest == 0) continue;
            if (ignored.has(i / 4)) {
                ++result.n_ignored_differing;
                continue;
            }
            if (limits.antialiasing && is_antialiasing(a, b, x, y)) {
                ++result.n_antialiased;
                continue;
            }
            sum += sum_here;
            ++result.n_differing;
            result.n_over_level += largest > a_level * limits.level;
            largest_of_all = std::max(largest_of_all, largest);
        }
    }
    result.largest_difference = 1.0 * largest_of_all / a_level;
    if (result.n_pixels > 0)
        result.mean_difference =
            static_cast<double>(sum) / (4.0 * static_cast<double>(result.n_pixels)) / a_level;
}

template bool is_antialiasing(const PictureSamples<std::uint8_t>&,
                              const PictureSamples<std::uint8_t>&, int, int);
template bool is_antialiasing(const PictureSamples<std::uint16_t>&,
                              const PictureSamples<std::uint16_t>&, int, int);
template void count_differences(const PictureSamples<std::uint8_t>&,
                                const PictureSamples<std::uint8_t>&, const CompareLimits&,
                                const PixelMask&, Comparison&);
template void count_differences(const PictureSamples<std::uint16_t>&,
                                const PictureSamples<std::uint16_t>&, const CompareLimits&,
                                const PixelMask&, Comparison&);

}  // namespace poinsot
