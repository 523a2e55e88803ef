#include "image/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>

#include "image/alpha.h"
#include "image/channel.h"

namespace poinsot {

namespace {

bool same_size(const Image& a, const Image& b) {
    return a.width() == b.width() && a.height() == b.height();
}

// The number of sample levels in one 8-bit level.
template <typename Sample>
constexpr int one_level = sizeof(Sample) == 2 ? 257 : 1;

template <typename Sample>
void count_differences(std::span<const Sample> a, std::span<const Sample> b, int level,
                       Comparison& result) {
    result.n_pixels = static_cast<std::int64_t>(a.size() / 4);
    // Most pairs are equal, and ten times as quickly found to be.
    if (std::equal(a.begin(), a.end(), b.begin(), b.end())) return;
    std::int64_t sum = 0;
    int largest_of_all = 0;
    for (std::size_t i = 0; i < a.size(); i += 4) {
        int largest = 0;
        for (std::size_t c = 0; c < 4; ++c) {
            const int difference = std::abs(int{a[i + c]} - int{b[i + c]});
            sum += difference;
            largest = std::max(largest, difference);
        }
        result.n_differing += largest > 0;
        result.n_over_level += largest > one_level<Sample> * level;
        largest_of_all = std::max(largest_of_all, largest);
    }
    result.largest_difference = 1.0 * largest_of_all / one_level<Sample>;
    if (!a.empty())
        result.mean_difference =
            static_cast<double>(sum) / static_cast<double>(a.size()) / one_level<Sample>;
}

void judge(const CompareLimits& limits, Comparison& result) {
    const auto share = [&](std::int64_t n) {
        return static_cast<double>(n) / static_cast<double>(result.n_pixels);
    };
    if (result.n_differing == 0) return;
    const bool too_many = share(result.n_differing) > limits.differing_share;
    const bool too_strong = share(result.n_over_level) > limits.over_level_share;
    result.verdict = too_many || too_strong ? Verdict::pixels_differ : Verdict::within_limits;
    const auto allowed = [](double most) {
        return most > 0.0 ? fmt::format("{:.3g} % allowed", 100 * most) : "none allowed";
    };
    // From level 0 on both caps count the same pixels, and the lower one decides.
    const bool same_count = limits.level == 0;
    const double share_allowed = same_count
                                     ? std::min(limits.differing_share, limits.over_level_share)
                                     : limits.differing_share;
    result.reason =
        fmt::format("{} of {} pixels differ ({:.3g} %, {})", result.n_differing, result.n_pixels,
                    100 * share(result.n_differing), allowed(share_allowed));
    if (!same_count)
        result.reason +=
            fmt::format(", {} by more than {} {} ({:.3g} %, {})", result.n_over_level, limits.level,
                        limits.level == 1 ? "level" : "levels", 100 * share(result.n_over_level),
                        allowed(limits.over_level_share));
    result.reason += fmt::format("; the largest difference is {:.3g} {}", result.largest_difference,
                                 result.largest_difference == 1.0 ? "level" : "levels");
}

// Luma of the sRGB values, 0 to 255 (Rec. ITU-R BT.709).
Channel luma_of(const Image& image) {
    Image flat;
    flatten_on_white(image, flat);
    Channel luma(image.width(), image.height());
    const auto bytes = flat.bytes();
    for (std::size_t i = 0; i < luma.values.size(); ++i)
        luma.values[i] =
            0.2126f * bytes[4 * i] + 0.7152f * bytes[4 * i + 1] + 0.0722f * bytes[4 * i + 2];
    return luma;
}

Channel product(const Channel& a, const Channel& b) {
    Channel result(a.width, a.height);
    for (std::size_t i = 0; i < a.values.size(); ++i) result.values[i] = a.values[i] * b.values[i];
    return result;
}

}  // namespace

namespace {

Comparison compare_samples(const Image& expected, const Image& actual,
                           const DeepImage* deep_expected, const DeepImage* deep_actual,
                           const CompareLimits& limits) {
    Comparison result;
    result.expected_width = expected.width(), result.expected_height = expected.height();
    result.actual_width = actual.width(), result.actual_height = actual.height();
    if (!same_size(expected, actual)) {
        result.verdict = Verdict::size_differs;
        result.reason = fmt::format("expected {}×{} pixels, found {}×{}", expected.width(),
                                    expected.height(), actual.width(), actual.height());
        return result;
    }
    if (deep_expected != nullptr && deep_actual != nullptr)
        count_differences(deep_expected->samples(), deep_actual->samples(), limits.level, result);
    else
        count_differences(expected.bytes(), actual.bytes(), limits.level, result);
    judge(limits, result);
    return result;
}

}  // namespace

Comparison compare(const Image& expected, const Image& actual, const CompareLimits& limits) {
    return compare_samples(expected, actual, nullptr, nullptr, limits);
}

Comparison compare(const StoredPicture& expected, const StoredPicture& actual,
                   const CompareLimits& limits) {
    const bool deep = !expected.deep.empty() && !actual.deep.empty();
    Comparison result =
        compare_samples(expected.image, actual.image, deep ? &expected.deep : nullptr,
                        deep ? &actual.deep : nullptr, limits);
    if (result.verdict == Verdict::size_differs) return result;
    if (expected.info.bit_depth != actual.info.bit_depth) {
        result.verdict = Verdict::depth_differs;
        result.reason = fmt::format("expected {} bits per component, found {}",
                                    expected.info.bit_depth, actual.info.bit_depth);
    } else if (expected.info.colours != actual.info.colours) {
        result.verdict = Verdict::colours_differ;
        result.reason = fmt::format("expected the colour space {}, found {}", expected.info.colours,
                                    actual.info.colours);
    }
    return result;
}

Likeness likeness_of(const Image& expected, const Image& actual) {
    return {structural_similarity(expected, actual), flip_error(expected, actual)};
}

double structural_similarity(const Image& expected, const Image& actual) {
    assert(same_size(expected, actual) && !expected.empty());
    // Values relative to middle grey, so that variances of light pictures do not cancel in single
    // precision.
    constexpr float middle = 128;
    constexpr double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
    Channel a = luma_of(expected), b = luma_of(actual);
    for (float& value : a.values) value -= middle;
    for (float& value : b.values) value -= middle;
    const std::vector<float> window = gaussian_kernel(1.5, 5);
    const auto local_mean = [&](const Channel& channel) {
        return convolved(channel, window, window);
    };
    const Channel mean_a = local_mean(a), mean_b = local_mean(b);
    const Channel aa = local_mean(product(a, a)), bb = local_mean(product(b, b));
    const Channel ab = local_mean(product(a, b));
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const double ma = mean_a.values[i], mb = mean_b.values[i];
        const double variance_a = aa.values[i] - ma * ma, variance_b = bb.values[i] - mb * mb;
        const double covariance = ab.values[i] - ma * mb;
        const double level_a = ma + middle, level_b = mb + middle;
        sum += (2 * level_a * level_b + c1) * (2 * covariance + c2) /
               ((level_a * level_a + level_b * level_b + c1) * (variance_a + variance_b + c2));
    }
    return sum / static_cast<double>(a.values.size());
}

Image difference_picture(const Image& expected, const Image& actual) {
    const int width = std::max(expected.width(), actual.width());
    const int height = std::max(expected.height(), actual.height());
    Image sheet(3 * width, height);
    const auto within = [](const Image& image, int x, int y) {
        return x < image.width() && y < image.height();
    };
    const auto magnified = [](int a, int b, int alpha) {
        return static_cast<std::uint8_t>(std::min(255, 16 * (std::abs(a - b) + alpha)));
    };
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool in_expected = within(expected, x, y), in_actual = within(actual, x, y);
            const Rgba8 e = in_expected ? expected.at(x, y) : Rgba8{0, 0, 0, 0};
            const Rgba8 a = in_actual ? actual.at(x, y) : Rgba8{0, 0, 0, 0};
            const int alpha = std::abs(int{e.a} - int{a.a});
            sheet.set(x, y, e);
            sheet.set(2 * width + x, y, a);
            sheet.set(width + x, y,
                      in_expected && in_actual
                          ? Rgba8{magnified(e.r, a.r, alpha), magnified(e.g, a.g, alpha),
                                  magnified(e.b, a.b, alpha), 255}
                          : Rgba8{255, 255, 255, 255});
        }
    }
    return sheet;
}

Image difference_picture(const StoredPicture& expected, const StoredPicture& actual) {
    Image sheet = difference_picture(expected.image, actual.image);
    const bool deep = !expected.deep.empty() && !actual.deep.empty();
    if (!deep || !same_size(expected.image, actual.image)) return sheet;
    const auto e = expected.deep.samples(), a = actual.deep.samples();
    const int width = expected.deep.width();
    for (int y = 0; y < expected.deep.height(); ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t at =
                4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x));
            const auto difference = [&](std::size_t c) { return std::abs(e[at + c] - a[at + c]); };
            const auto magnified = [&](std::size_t c) {
                return static_cast<std::uint8_t>(
                    std::min(255, 16 * (difference(c) + difference(3))));
            };
            sheet.set(width + x, y, {magnified(0), magnified(1), magnified(2), 255});
        }
    }
    return sheet;
}

}  // namespace poinsot
