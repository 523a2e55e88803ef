// A quick hash of pixels, by which a picture's record and its pixels know each other: so quick that
// every frame of a sequence has one. Where pictures are named by their pixels, sha256.h does it.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "image/png.h"

namespace poinsot {

// XXH64 with seed 0, of a message given in parts.
// Source: Collet, xxHash fast digest algorithm, specification 0.1.1 (2018), "XXH64".
class Xxh64 {
 public:
    void add(std::span<const std::uint8_t> bytes);
    std::uint64_t value() const;

 private:
    void take_stripe(const std::uint8_t* stripe);

    std::array<std::uint64_t, 4> lanes_{0x60ea27eeadc0b5d6, 0xc2b2ae3d27d4eb4f, 0,
                                        0x61c8864e7a143579};
    std::array<std::uint8_t, 32> waiting_{};
    std::uint64_t n_bytes_ = 0;
};

// Of a picture's size and depth ("WIDTHxHEIGHT\n", or "WIDTHxHEIGHT 16\n"), then its RGBA samples
// row by row, the high byte of 16 bits first. Rows are given from the top, in parts of any height.
class PixelCheck {
 public:
    PixelCheck(int width_px, int height_px, int bit_depth);

    void add(std::span<const std::uint8_t> samples) { hash_.add(samples); }
    void add(std::span<const std::uint16_t> samples);

    std::string digits() const;  // 16 hexadecimal digits

 private:
    Xxh64 hash_;
};

std::string pixel_check(const Image& image);
std::string pixel_check(const StoredPicture& picture);

// Of the pixels that a PNG file holds, of any size: read row by row. Throws: as read_png.
std::string pixel_check_of(const std::filesystem::path& png);

}  // namespace poinsot
