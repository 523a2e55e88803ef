#include "image/downsample.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "numerics/srgb.h"

namespace poinsot {

namespace {

// Linear light of every 16-bit level.
const std::vector<double>& deep_linear_levels() {
    static const std::vector<double> levels = [] {
        std::vector<double> table(65536);
        for (std::size_t k = 0; k < table.size(); ++k)
            table[k] = linear_from_srgb(static_cast<double>(k) / 65535.0);
        return table;
    }();
    return levels;
}

// Linear light of every 8-bit sRGB level.
const std::array<float, 256>& linear_levels() {
    static const std::array<float, 256> levels = [] {
        std::array<float, 256> table{};
        for (std::size_t i = 0; i < table.size(); ++i) {
            table[i] = static_cast<float>(linear_from_srgb(static_cast<double>(i) / 255.0));
        }
        return table;
    }();
    return levels;
}

// The search for a level begins at the nearest level at or below the light k/n_bins.
constexpr int n_bins = 4096;
const std::array<std::uint8_t, n_bins + 1>& first_levels() {
    static const std::array<std::uint8_t, n_bins + 1> levels = [] {
        const auto& linear = linear_levels();
        std::array<std::uint8_t, n_bins + 1> table{};
        std::size_t level = 0;
        for (std::size_t k = 0; k < table.size(); ++k) {
            while (level < 255 && linear[level + 1] <= static_cast<float>(k) / n_bins) ++level;
            table[k] = static_cast<std::uint8_t>(level);
        }
        return table;
    }();
    return levels;
}

// Sums of light over the pixels of a block, weighted by alpha.
struct Light {
    float r = 0.0F, g = 0.0F, b = 0.0F;
    int alpha = 0;
};

class Averager {
 public:
    explicit Averager(int factor)
        : factor_(factor), linear_(linear_levels()), first_levels_(first_levels()) {
        for (std::size_t k = 0; k < linear_.size(); ++k) opaque_[k] = linear_[k] * 255.0F;
    }

    // `from` is the block's upper left pixel; stride in bytes.
    void average(const std::uint8_t* from, std::ptrdiff_t stride, std::uint8_t* to) const {
        Light light;
        for (int j = 0; j < factor_; ++j) {
            const std::uint8_t* pixel = from + j * stride;
            for (int i = 0; i < factor_; ++i, pixel += 4) add(pixel, light);
        }
        if (light.alpha == 0) {
            std::fill_n(to, 4, std::uint8_t{0});
            return;
        }
        const float weight = 1.0F / static_cast<float>(light.alpha);
        const int n = factor_ * factor_;
        to[0] = encoded(light.r * weight);
        to[1] = encoded(light.g * weight);
        to[2] = encoded(light.b * weight);
        to[3] = static_cast<std::uint8_t>((light.alpha + n / 2) / n);
    }

 private:
    void add(const std::uint8_t* pixel, Light& light) const {
        light.alpha += pixel[3];
        if (pixel[3] == 255) {
            light.r += opaque_[pixel[0]];
            light.g += opaque_[pixel[1]];
            light.b += opaque_[pixel[2]];
            return;
        }
        const auto alpha = static_cast<float>(pixel[3]);
        light.r += linear_[pixel[0]] * alpha;
        light.g += linear_[pixel[1]] * alpha;
        light.b += linear_[pixel[2]] * alpha;
    }

    // The level with the nearest linear light.
    std::uint8_t encoded(float light) const {
        const auto bin = static_cast<std::size_t>(std::min(light, 1.0F) * n_bins);
        std::size_t level = first_levels_[bin];
        while (level < 255 && light - linear_[level] >= linear_[level + 1] - light) ++level;
        return static_cast<std::uint8_t>(level);
    }

    int factor_;
    const std::array<float, 256>& linear_;
    const std::array<std::uint8_t, n_bins + 1>& first_levels_;
    std::array<float, 256> opaque_{};
};

}  // namespace

void downsample_into(const Image& image, int factor, Image& small) {
    assert(factor >= 1 && image.width() % factor == 0 && image.height() % factor == 0);
    const int width = image.width() / factor, height = image.height() / factor;
    if (small.width() != width || small.height() != height) small = Image(width, height);
    if (factor == 1) {
        small = image;
        return;
    }
    const Averager averager(factor);
    const std::ptrdiff_t stride = std::ptrdiff_t{4} * image.width();
    const std::uint8_t* row = image.bytes().data();
    std::uint8_t* to = small.bytes().data();
    for (int y = 0; y < height; ++y, row += factor * stride)
        for (int x = 0; x < width; ++x, to += 4)
            averager.average(row + std::ptrdiff_t{4} * factor * x, stride, to);
}

Image downsampled(const Image& image, int factor) {
    Image small;
    downsample_into(image, factor, small);
    return small;
}

void downsample_into(const DeepImage& image, int factor, DeepImage& small) {
    assert(factor >= 1 && image.width() % factor == 0 && image.height() % factor == 0);
    const int width = image.width() / factor, height = image.height() / factor;
    if (small.width() != width || small.height() != height) small = DeepImage(width, height);
    const std::vector<double>& linear = deep_linear_levels();
    const auto stride = std::size_t{4} * static_cast<std::size_t>(image.width());
    const auto n = static_cast<std::size_t>(factor);
    std::size_t to = 0;
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x, to += 4) {
            // Sums of light over the block, each pixel weighted by its alpha.
            std::array<double, 3> light{};
            double alpha = 0.0;
            for (std::size_t k = 0; k < n * n; ++k) {
                const std::uint16_t* pixel = image.samples().data() + (n * y + k / n) * stride +
                                             std::size_t{4} * (n * x + k % n);
                for (std::size_t c = 0; c < 3; ++c) light[c] += linear[pixel[c]] * pixel[3];
                alpha += pixel[3];
            }
            std::uint16_t* out = small.samples().data() + to;
            for (std::size_t c = 0; c < 3; ++c) {
                const double mean = alpha > 0.0 ? light[c] / alpha : 0.0;
                out[c] = static_cast<std::uint16_t>(std::lround(65535.0 * srgb_from_linear(mean)));
            }
            out[3] = static_cast<std::uint16_t>(std::lround(alpha / static_cast<double>(n * n)));
        }
    }
}

}  // namespace poinsot
