#include "image/pixels_xxh64.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <new>

namespace poinsot {

Xxh64::Xxh64() : state_(XXH64_createState()) {
    if (!state_) throw std::bad_alloc();
    XXH64_reset(state_.get(), 0);
}

void Xxh64::Free::operator()(XXH64_state_s* state) const { XXH64_freeState(state); }

void Xxh64::add(std::span<const std::uint8_t> bytes) {
    XXH64_update(state_.get(), bytes.data(), bytes.size());
}

std::uint64_t Xxh64::value() const { return XXH64_digest(state_.get()); }

PixelsXxh64::PixelsXxh64(int width_px, int height_px, int bit_depth) {
    const std::string head =
        fmt::format("{}x{}{}\n", width_px, height_px, bit_depth == 16 ? " 16" : "");
    hash_.add({reinterpret_cast<const std::uint8_t*>(head.data()), head.size()});
}

void PixelsXxh64::add(std::span<const std::uint16_t> samples) {
    std::array<std::uint8_t, 4096> bytes{};
    while (!samples.empty()) {
        const std::size_t n = std::min(samples.size(), bytes.size() / 2);
        for (std::size_t i = 0; i < n; ++i) {
            bytes[2 * i] = static_cast<std::uint8_t>(samples[i] >> 8);
            bytes[2 * i + 1] = static_cast<std::uint8_t>(samples[i] & 0xff);
        }
        hash_.add(std::span(bytes).first(2 * n));
        samples = samples.subspan(n);
    }
}

std::string PixelsXxh64::digits() const { return fmt::format("{:016x}", hash_.value()); }

std::string pixels_xxh64(const Image& image) {
    PixelsXxh64 check(image.width(), image.height(), 8);
    check.add(image.bytes());
    return check.digits();
}

std::string pixels_xxh64(const StoredPicture& picture) {
    if (picture.deep.empty()) return pixels_xxh64(picture.image);
    PixelsXxh64 check(picture.deep.width(), picture.deep.height(), 16);
    check.add(picture.deep.samples());
    return check.digits();
}

}  // namespace poinsot
