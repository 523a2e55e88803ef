#include "image/pixel_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace poinsot {

namespace {

constexpr std::uint64_t prime_1 = 0x9e3779b185ebca87, prime_2 = 0xc2b2ae3d27d4eb4f,
                        prime_3 = 0x165667b19e3779f9, prime_4 = 0x85ebca77c2b2ae63,
                        prime_5 = 0x27d4eb2f165667c5;

// The message is read the low byte first, as this processor does.
static_assert(std::endian::native == std::endian::little);

template <typename Word>
Word word_at(const std::uint8_t* bytes) {
    Word word;
    std::memcpy(&word, bytes, sizeof word);
    return word;
}

std::uint64_t mixed(std::uint64_t lane, std::uint64_t word) {
    return std::rotl(lane + word * prime_2, 31) * prime_1;
}

}  // namespace

void Xxh64::take_stripe(const std::uint8_t* stripe) {
    for (std::size_t i = 0; i < lanes_.size(); ++i)
        lanes_[i] = mixed(lanes_[i], word_at<std::uint64_t>(stripe + 8 * i));
}

void Xxh64::add(std::span<const std::uint8_t> bytes) {
    const std::size_t filled = n_bytes_ % waiting_.size();
    n_bytes_ += bytes.size();
    if (filled > 0) {
        const std::size_t n = std::min(waiting_.size() - filled, bytes.size());
        std::copy_n(bytes.begin(), n, waiting_.begin() + static_cast<std::ptrdiff_t>(filled));
        bytes = bytes.subspan(n);
        if (filled + n < waiting_.size()) return;
        take_stripe(waiting_.data());
    }
    for (; bytes.size() >= waiting_.size(); bytes = bytes.subspan(waiting_.size()))
        take_stripe(bytes.data());
    std::copy(bytes.begin(), bytes.end(), waiting_.begin());
}

std::uint64_t Xxh64::value() const {
    std::uint64_t hash = prime_5;
    if (n_bytes_ >= waiting_.size()) {
        hash = std::rotl(lanes_[0], 1) + std::rotl(lanes_[1], 7) + std::rotl(lanes_[2], 12) +
               std::rotl(lanes_[3], 18);
        for (const std::uint64_t lane : lanes_) hash = (hash ^ mixed(0, lane)) * prime_1 + prime_4;
    }
    hash += n_bytes_;
    const std::uint8_t* at = waiting_.data();
    const std::uint8_t* const end = at + n_bytes_ % waiting_.size();
    for (; end - at >= 8; at += 8)
        hash = std::rotl(hash ^ mixed(0, word_at<std::uint64_t>(at)), 27) * prime_1 + prime_4;
    for (; end - at >= 4; at += 4)
        hash = std::rotl(hash ^ word_at<std::uint32_t>(at) * prime_1, 23) * prime_2 + prime_3;
    for (; at != end; ++at) hash = std::rotl(hash ^ *at * prime_5, 11) * prime_1;
    hash = (hash ^ hash >> 33) * prime_2;
    hash = (hash ^ hash >> 29) * prime_3;
    return hash ^ hash >> 32;
}

PixelCheck::PixelCheck(int width_px, int height_px, int bit_depth) {
    const std::string head =
        fmt::format("{}x{}{}\n", width_px, height_px, bit_depth == 16 ? " 16" : "");
    hash_.add({reinterpret_cast<const std::uint8_t*>(head.data()), head.size()});
}

void PixelCheck::add(std::span<const std::uint16_t> samples) {
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

std::string PixelCheck::digits() const { return fmt::format("{:016x}", hash_.value()); }

std::string pixel_check(const Image& image) {
    PixelCheck check(image.width(), image.height(), 8);
    check.add(image.bytes());
    return check.digits();
}

std::string pixel_check(const StoredPicture& picture) {
    if (picture.deep.empty()) return pixel_check(picture.image);
    PixelCheck check(picture.deep.width(), picture.deep.height(), 16);
    check.add(picture.deep.samples());
    return check.digits();
}

}  // namespace poinsot
