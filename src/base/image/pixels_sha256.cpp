#include "image/pixels_sha256.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "system/sha256.h"

namespace poinsot {

std::string pixels_sha256(const Image& image) {
    Sha256 hash;
    hash.add(fmt::format("{}x{}\n", image.width(), image.height()));
    hash.add(image.bytes());
    return hash.finish();
}

std::string pixels_sha256(const DeepImage& image) {
    Sha256 hash;
    hash.add(fmt::format("{}x{} 16\n", image.width(), image.height()));
    std::array<std::uint8_t, 4096> bytes{};
    for (auto rest = image.samples(); !rest.empty();) {
        const std::size_t n = std::min(rest.size(), bytes.size() / 2);
        for (std::size_t i = 0; i < n; ++i) {
            bytes[2 * i] = static_cast<std::uint8_t>(rest[i] >> 8);
            bytes[2 * i + 1] = static_cast<std::uint8_t>(rest[i] & 0xff);
        }
        hash.add(std::span(bytes).first(2 * n));
        rest = rest.subspan(n);
    }
    return hash.finish();
}

std::string pixels_sha256(const StoredPicture& picture) {
    return picture.deep.empty() ? pixels_sha256(picture.image) : pixels_sha256(picture.deep);
}

}  // namespace poinsot
