#include "render/encoding.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "numerics/srgb.h"

namespace poinsot {
namespace {

static_assert(std::endian::native == std::endian::little, "pixels are taken apart as words");

constexpr int side = 8;  // of the dither matrix

// Bayer's threshold matrix, in 1/256 of a level: 128 ± 0.42 levels.
constexpr std::array<std::array<std::uint16_t, side>, side> make_thresholds() {
    std::array<std::array<std::uint16_t, side>, side> thresholds{};
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const int z = x ^ y;
            const int rank = ((z & 1) << 5) | ((y & 1) << 4) | ((z & 2) << 2) | ((y & 2) << 1) |
                             ((z & 4) >> 1) | ((y & 4) >> 2);
            constexpr int amplitude = 216;
            thresholds[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] =
                static_cast<std::uint16_t>(128 + (2 * rank - 63) * amplitude / 128);
        }
    }
    return thresholds;
}
constexpr auto thresholds = make_thresholds();

}  // namespace

Encoder::Encoder() : levels_(65536), deep_levels_(65536) {
    for (std::size_t k = 0; k < levels_.size(); ++k) {
        const double encoded = srgb_from_linear(static_cast<double>(k) / 65535.0);
        levels_[k] = static_cast<std::uint16_t>(std::lround(255.0 * 256.0 * encoded));
        deep_levels_[k] = static_cast<std::uint16_t>(std::lround(65535.0 * encoded));
    }
}

std::vector<std::uint16_t> Encoder::table() const {
    std::vector<std::uint16_t> table = levels_;
    for (const auto& row : thresholds) table.insert(table.end(), row.begin(), row.end());
    table.resize(levels_.size() + 256);
    return table;
}

void Encoder::encode_opaque(const std::uint16_t* linear, int x, int y, int n,
                            std::uint8_t* out) const {
    const std::uint16_t* levels = levels_.data();
    const auto& row = thresholds[static_cast<std::size_t>(y % side)];
    // Loads and stores each pixel as one word: three loads would take half as much time again.
    for (int k = 0; k < n; ++k, linear += 4, out += 4) {
        const std::uint32_t threshold = row[static_cast<std::size_t>(x + k) % side];
        std::uint64_t pixel = 0;
        std::memcpy(&pixel, linear, sizeof pixel);
        const std::uint32_t r = levels[pixel & 0xffff] + threshold;
        const std::uint32_t g = levels[(pixel >> 16) & 0xffff] + threshold;
        const std::uint32_t b = levels[(pixel >> 32) & 0xffff] + threshold;
        const std::uint32_t encoded = 0xff000000u | (r >> 8) | (g & 0xff00) | ((b & 0xff00) << 8);
        std::memcpy(out, &encoded, sizeof encoded);
    }
}

void Encoder::encode_transparent(const std::uint16_t* linear, int x, int y, int n,
                                 std::uint8_t* out) const {
    const auto& row = thresholds[static_cast<std::size_t>(y % side)];
    for (int k = 0; k < n; ++k, linear += 4, out += 4) {
        const unsigned threshold = row[static_cast<std::size_t>((x + k) % side)];
        const unsigned alpha = linear[3];
        for (int c = 0; c < 3; ++c) {
            const unsigned part =
                alpha == 0 ? 0u : std::min(65535u, (65535u * linear[c] + alpha / 2) / alpha);
            out[c] = static_cast<std::uint8_t>((levels_[part] + threshold) >> 8);
        }
        out[3] = static_cast<std::uint8_t>((255u * alpha + 32767u) / 65535u);
    }
}

void Encoder::encode_deep(const std::uint16_t* linear, int n, bool transparent,
                          std::uint16_t* out) const {
    for (int k = 0; k < n; ++k, linear += 4, out += 4) {
        const unsigned alpha = transparent ? linear[3] : 65535u;
        for (int c = 0; c < 3; ++c) {
            const unsigned part =
                alpha == 0 ? 0u : std::min(65535u, (65535u * linear[c] + alpha / 2) / alpha);
            out[c] = deep_levels_[part];
        }
        out[3] = static_cast<std::uint16_t>(alpha);
    }
}

}  // namespace poinsot
