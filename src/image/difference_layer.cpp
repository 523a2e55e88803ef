// The differences of two pictures as a layer that is shown over one of them.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "image/compare.h"
#include "image/pixel_differences.h"

namespace poinsot {

namespace {

constexpr Rgba8 absent{217, 0, 54, 255}, antialiased{30, 110, 255, 255},
    left_out{128, 128, 128, 110};

// Amber at one level or less, red at 16 levels and more; evenly by the logarithm between.
Rgba8 heat(double levels) {
    const double share = std::clamp(std::log2(std::max(levels, 1.0)) / 4.0, 0.0, 1.0);
    const auto between = [share](int from, int to) {
        return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
    };
    return {between(255, 217), between(176, 0), between(0, 54), 255};
}

template <typename Sample>
void paint(const PictureSamples<Sample>& a, const PictureSamples<Sample>& b,
           const CompareLimits& limits, const PixelMask& ignored, Image& layer) {
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::size_t pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) +
                static_cast<std::size_t>(x);
            if (ignored.has(pixel)) {
                layer.set(x, y, left_out);
                continue;
            }
            int largest = 0;
            for (std::size_t c = 0; c < 4; ++c)
                largest = std::max(largest, std::abs(int{a.samples[4 * pixel + c]} -
                                                     int{b.samples[4 * pixel + c]}));
            if (largest == 0) continue;
            layer.set(x, y,
                      limits.antialiasing && is_antialiasing(a, b, x, y)
                          ? antialiased
                          : heat(1.0 * largest / samples_a_level<Sample>));
        }
    }
}

}  // namespace

Image difference_layer(const StoredPicture& expected, const StoredPicture& actual,
                       const CompareLimits& limits, std::span<const PictureRegion> ignored) {
    const int width = std::max(expected.image.width(), actual.image.width());
    const int height = std::max(expected.image.height(), actual.image.height());
    Image layer(width, height);
    if (expected.image.width() != actual.image.width() ||
        expected.image.height() != actual.image.height()) {
        const auto has = [](const Image& image, int x, int y) {
            return x < image.width() && y < image.height();
        };
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                if (!has(expected.image, x, y) || !has(actual.image, x, y)) {
                    layer.set(x, y, absent);
                    continue;
                }
                const Rgba8 a = expected.image.at(x, y), b = actual.image.at(x, y);
                const int largest = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g),
                                              std::abs(a.b - b.b), std::abs(a.a - b.a)});
                if (largest > 0) layer.set(x, y, heat(largest));
            }
        return layer;
    }
    const PixelMask mask(width, height, ignored);
    if (!expected.deep.empty() && !actual.deep.empty())
        paint(samples_of(expected.deep), samples_of(actual.deep), limits, mask, layer);
    else
        paint(samples_of(expected.image), samples_of(actual.image), limits, mask, layer);
    return layer;
}

}  // namespace poinsot
