// A fast hash of pixels (XXH64) that links a picture's record to its pixels. It is fast enough for
// every frame of a sequence. pixels_sha256.h has the cryptographic hash.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "image/png.h"

struct XXH64_state_s;  // of libxxhash

namespace poinsot {

// XXH64 with seed 0 of a message given in parts (by libxxhash).
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

// Hash of a picture's size and depth ("WIDTHxHEIGHT\n", or "WIDTHxHEIGHT 16\n"), then its RGBA
// samples row by row; 16-bit samples are big-endian. Rows are added from the top, in parts of any
// height.
class PixelsXxh64 {
 public:
    PixelsXxh64(int width_px, int height_px, int bit_depth);

    void add(std::span<const std::uint8_t> samples) { hash_.add(samples); }
    void add(std::span<const std::uint16_t> samples);

    std::string digits() const;  // 16 hexadecimal digits

 private:
    Xxh64 hash_;
};

std::string pixels_xxh64(const Image& image);
std::string pixels_xxh64(const StoredPicture& picture);

// The hash of the pixels of a PNG file's bytes, of any size; decodes it row by row. Throws: as
// decode_png.
std::string pixels_xxh64_of(std::span<const std::uint8_t> file, const std::string& name);

}  // namespace poinsot
