// The parts of a PNG file, shared by the writer of whole pictures and that of bands. Included only
// inside image/.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "image/deep_image.h"
#include "image/png.h"

namespace poinsot::png {

using Bytes = std::vector<std::uint8_t>;

// How a row is told from what it holds (PNG specification §9.2): as it is, or each byte less that
// of the pixel to its left.
enum class Filter : std::uint8_t { none = 0, sub = 1 };

void put_u32(std::uint8_t* to, std::uint32_t value);

// A chunk: length, type, contents, checksum of type and contents (§5.3).
void append_chunk(Bytes& out, std::string_view type, std::span<const std::uint8_t> contents);

// What a picture's samples are, in the words of its header (§11.2.2).
struct Format {
    int width_px = 0, height_px = 0;
    bool opaque = false;
    int bit_depth = 8;  // or 16

    // Bytes of a row of samples with its filter's.
    std::size_t row_size() const;
};

// Signature, size and everything else before the pixels. Throws InputError for an empty picture, or
// one with a side larger than this.
Bytes front(const Format& format, int largest_side_px, std::span<const std::uint8_t> description);
Bytes description(const PngOptions& options);
// Texts that follow the pixels, and the end.
Bytes back(const std::map<std::string, std::string>& texts = {});

// n_rows rows from y on, each after its filter's byte, into row_size · n_rows bytes.
void filter_rows(const Image& image, bool opaque, Filter filter, int y, int n_rows,
                 std::uint8_t* to);
// All rows of a picture of 16 bits, each byte less that of the pixel to its left.
void filter_rows(const DeepImage& image, bool opaque, std::uint8_t* to);

}  // namespace poinsot::png
