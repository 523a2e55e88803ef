// The chunks of a PNG file, shared by the writers of whole pictures and of bands. Included only
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

// PNG's row filters (PNG specification §9.2): none, or subtract the pixel to the left, byte by
// byte.
enum class Filter : std::uint8_t { none = 0, sub = 1 };

void put_u32(std::uint8_t* to, std::uint32_t value);

// Appends a chunk: length, type, contents, and checksum of type and contents (§5.3).
void append_chunk(Bytes& out, std::string_view type, std::span<const std::uint8_t> contents);

// The format of the samples, as in the PNG header (§11.2.2).
struct Format {
    int width_px = 0, height_px = 0;
    bool opaque = false;
    int bit_depth = 8;  // or 16
    bool has_palette = false;

    // Bytes of a row of samples, including the filter byte.
    std::size_t row_size() const;
};

// The signature, header and everything else before the pixels. Throws InputError for an empty
// picture, or one with a side larger than largest_side_px.
Bytes front(const Format& format, int largest_side_px, std::span<const std::uint8_t> description);
Bytes description(const PngOptions& options);
// Texts that follow the pixels, and the end chunk.
Bytes back(const std::map<std::string, std::string>& texts = {});

// Writes n_rows rows from y on, each preceded by its filter byte: row_size · n_rows bytes.
void filter_rows(const Image& image, bool opaque, Filter filter, int y, int n_rows,
                 std::uint8_t* to);
// Writes all rows of a 16-bit picture with the filter `sub`.
void filter_rows(const DeepImage& image, bool opaque, std::uint8_t* to);

}  // namespace poinsot::png
