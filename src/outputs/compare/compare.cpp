#include "compare/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>

#include "compare/pixel_differences.h"
#include "image/alpha.h"
#include "image/channel.h"

namespace poinsot {

namespace {

bool same_size(const Image& a, const Image& b) {
    return a.width() == b.width() && a.height() == b.height();
}

double share_of(std::int64_t n, std::int64_t n_all) {
    return n_all > 0 ? static_cast<double>(n) / static_cast<double>(n_all) : 0.0;
}

std::string levels_in_words(double n) {
    return fmt::format("{:.3g} {}", n, n == 1.0 ? "level" : "levels");
}

std::string allowed_in_words(double most) {
    return most > 0.0 ? fmt::format("{:.3g} % allowed", 100 * most) : "none allowed";
}

// "7 of 100 pixels differ (7 %, none allowed), 3 by more than 2 levels (3 %, none allowed)"
std::string counts_in_words(const CompareLimits& limits, const Comparison& result) {
    const double differing = share_of(result.n_differing, result.n_pixels);
    if (!limits.limits_pixels())
        return fmt::format("{} of {} pixels differ ({:.3g} %)", result.n_differing, result.n_pixels,
                           100 * differing);
    // From level 0 on both caps count the same pixels, and the lower one decides.
    const bool same_count = limits.level == 0;
    const double share_allowed = same_count
                                     ? std::min(limits.differing_share, limits.over_level_share)
                                     : limits.differing_share;
    std::string words =
        fmt::format("{} of {} pixels differ ({:.3g} %, {})", result.n_differing, result.n_pixels,
                    100 * differing, allowed_in_words(share_allowed));
    if (!same_count)
        words += fmt::format(", {} by more than {} ({:.3g} %, {})", result.n_over_level,
                             levels_in_words(limits.level),
                             100 * share_of(result.n_over_level, result.n_pixels),
                             allowed_in_words(limits.over_level_share));
    return words;
}

// Sets the verdict and the reason from the counts and the measures.
void judge(const CompareLimits& limits, Comparison& result) {
    if (result.n_differing == 0 && result.n_antialiased == 0) {
        if (result.n_ignored_differing == 0) return;
        result.verdict = Verdict::within_limits;
        result.reason = "the pictures differ only where differences are ignored";
        return;
    }
    const bool too_many = share_of(result.n_differing, result.n_pixels) > limits.differing_share;
    const bool too_strong =
        share_of(result.n_over_level, result.n_pixels) > limits.over_level_share;
    const bool too_visible = limits.most_flip && *result.flip > *limits.most_flip;
    const bool too_unlike = limits.least_ssim && *result.ssim < *limits.least_ssim;
    result.verdict = too_many || too_strong || too_visible || too_unlike ? Verdict::pixels_differ
                                                                         : Verdict::within_limits;
    result.reason = counts_in_words(limits, result);
    if (result.n_antialiased > 0)
        result.reason +=
            fmt::format("; anti-aliasing explains {} more, which {} allowed", result.n_antialiased,
                        result.n_antialiased == 1 ? "is" : "are");
    if (result.n_differing > 0)
        result.reason += fmt::format("; the largest difference is {}",
                                     levels_in_words(result.largest_difference));
    if (result.flip) result.reason += fmt::format("; FLIP {:.3g}", *result.flip);
    if (limits.most_flip) result.reason += fmt::format(" ({:.3g} allowed)", *limits.most_flip);
    if (result.ssim) result.reason += fmt::format("; SSIM {:.5f}", *result.ssim);
    if (limits.least_ssim)
        result.reason += fmt::format(" (at least {:.5g} required)", *limits.least_ssim);
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

Comparison size_difference(int expected_width, int expected_height, int actual_width,
                           int actual_height) {
    Comparison result;
    result.verdict = Verdict::size_differs;
    result.expected_width = expected_width, result.expected_height = expected_height;
    result.actual_width = actual_width, result.actual_height = actual_height;
    result.reason = fmt::format("expected {}×{} pixels, found {}×{}", expected_width,
                                expected_height, actual_width, actual_height);
    return result;
}

namespace {

// A picture whose ignored pixels are those of the expected picture.
Image without_ignored(const Image& expected, Image actual, const PixelMask& ignored) {
    const std::span<const std::uint8_t> from = expected.bytes();
    const std::span<std::uint8_t> to = actual.bytes();
    for (std::size_t i = 0; i < ignored.bytes().size(); ++i)
        if (ignored.bytes()[i] != 0)
            std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(4 * i), 4,
                        to.begin() + static_cast<std::ptrdiff_t>(4 * i));
    return actual;
}

// Measures are means over all pixels; differences are only in those that are not ignored.
void measure(const Image& expected, const Image& actual, const CompareLimits& limits,
             const CompareExtras& extras, Comparison& result) {
    const double rest = 1.0 / share_of(result.n_pixels, result.n_pixels + result.n_ignored);
    if (extras.flip || limits.most_flip)
        result.flip = std::min(1.0, flip_error(expected, actual) * rest);
    if (extras.ssim || limits.least_ssim)
        result.ssim = 1.0 - (1.0 - structural_similarity(expected, actual)) * rest;
}

Comparison compare_samples(const Image& expected, const Image& actual,
                           const DeepImage* deep_expected, const DeepImage* deep_actual,
                           const CompareLimits& limits, const CompareExtras& extras) {
    if (!same_size(expected, actual))
        return size_difference(expected.width(), expected.height(), actual.width(),
                               actual.height());
    Comparison result;
    result.expected_width = result.actual_width = expected.width();
    result.expected_height = result.actual_height = expected.height();
    const PixelMask ignored(expected.width(), expected.height(), extras.ignored);
    result.n_ignored = ignored.count();
    result.n_pixels = std::int64_t{expected.width()} * expected.height() - result.n_ignored;
    if (deep_expected != nullptr && deep_actual != nullptr)
        count_differences(samples_of(*deep_expected), samples_of(*deep_actual), limits, ignored,
                          result);
    else
        count_differences(samples_of(expected), samples_of(actual), limits, ignored, result);
    if (result.n_differing + result.n_antialiased > 0) {
        if (ignored.count() == 0)
            measure(expected, actual, limits, extras, result);
        else
            measure(expected, without_ignored(expected, actual, ignored), limits, extras, result);
    }
    judge(limits, result);
    return result;
}

}  // namespace

Comparison compare(const Image& expected, const Image& actual, const CompareLimits& limits,
                   const CompareExtras& extras) {
    return compare_samples(expected, actual, nullptr, nullptr, limits, extras);
}

Comparison compare(const StoredPicture& expected, const StoredPicture& actual,
                   const CompareLimits& limits, const CompareExtras& extras) {
    const bool deep = !expected.deep.empty() && !actual.deep.empty();
    Comparison result =
        compare_samples(expected.image, actual.image, deep ? &expected.deep : nullptr,
                        deep ? &actual.deep : nullptr, limits, extras);
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

Image difference_picture(const StoredPicture& expected, const StoredPicture& actual,
                         std::span<const PictureRegion> ignored) {
    Image sheet = difference_picture(expected.image, actual.image);
    if (!same_size(expected.image, actual.image)) return sheet;
    const bool deep = !expected.deep.empty() && !actual.deep.empty();
    const int width = expected.image.width(), height = expected.image.height();
    const PixelMask mask(width, height, ignored);
    if (!deep && mask.count() == 0) return sheet;
    constexpr Rgba8 left_out{110, 110, 110, 255};
    const auto e = expected.deep.samples(), a = actual.deep.samples();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x);
            if (mask.has(pixel)) {
                sheet.set(width + x, y, left_out);
                continue;
            }
            if (!deep) continue;
            const std::size_t at = 4 * pixel;
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
