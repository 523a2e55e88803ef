// A quick hash of pixels, by which a picture's record and its pixels know each other: so quick that
// every frame of a sequence has one. Where pictures are named by their pixels, sha256.h does it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "image/png.h"

struct XXH64_state_s;  // of libxxhash

namespace poinsot {

// XXH64 with seed 0, of a message given in parts (by libxxhash).
class Xxh64 {
 public:
    Xxh64();
    void add(std::span<const std::uint8_t> bytes);
    std::uint64_t value() const;

 private:
    struct Free {
        void operator()(XXH64_state_s* state) const;
    };
    std::unique_ptr<XXH64_state_s, Free> state_;
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
