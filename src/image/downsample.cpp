#include "image/downsample.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace poinsot {

namespace {

// Linear light of every sRGB level (IEC 61966-2-1).
const std::array<float, 256>& linear_levels() {
    static const std::array<float, 256> levels = [] {
        std::array<float, 256> table{};
        for (std::size_t i = 0; i < table.size(); ++i) {
            const double encoded = static_cast<double>(i) / 255.0;
            table[i] = static_cast<float>(
                encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
        }
        return table;
    }();
    return levels;
}

// The level whose linear light is nearest.
std::uint8_t encoded_level(float linear) {
    const auto& levels = linear_levels();
    const auto above = std::lower_bound(levels.begin(), levels.end(), linear);
    if (above == levels.begin()) return 0;
    if (above == levels.end()) return 255;
    const auto level = static_cast<std::uint8_t>(above - levels.begin());
    return linear - *(above - 1) < *above - linear ? static_cast<std::uint8_t>(level - 1) : level;
}

}  // namespace

Image downsampled(const Image& image, int factor) {
    assert(factor >= 1 && image.width() % factor == 0 && image.height() % factor == 0);
    if (factor == 1) return image;
    Image small(image.width() / factor, image.height() / factor);
    const auto& linear = linear_levels();
    for (int y = 0; y < small.height(); ++y) {
        for (int x = 0; x < small.width(); ++x) {
            float r = 0.0F;
            float g = 0.0F;
            float b = 0.0F;
            int alpha = 0;
            for (int j = 0; j < factor; ++j) {
                for (int i = 0; i < factor; ++i) {
                    const Rgba8 c = image.at(x * factor + i, y * factor + j);
                    r += linear[c.r] * static_cast<float>(c.a);
                    g += linear[c.g] * static_cast<float>(c.a);
                    b += linear[c.b] * static_cast<float>(c.a);
                    alpha += c.a;
                }
            }
            if (alpha == 0) {
                small.set(x, y, {0, 0, 0, 0});
                continue;
            }
            const auto weight = 1.0F / static_cast<float>(alpha);
            const int n = factor * factor;
            small.set(x, y,
                      {encoded_level(r * weight), encoded_level(g * weight),
                       encoded_level(b * weight), static_cast<std::uint8_t>((alpha + n / 2) / n)});
        }
    }
    return small;
}

}  // namespace poinsot
