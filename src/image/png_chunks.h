// The parts of a PNG file, shared by the writer of whole pictures and that of bands. Included only
// inside image/.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "image/png.h"

namespace poinsot::png {

using Bytes = std::vector<std::uint8_t>;

// How a row is told from what it holds (PNG specification §9.2): as it is, or each byte less that
// of the pixel to its left.
enum class Filter : std::uint8_t { none = 0, sub = 1 };

void put_u32(std::uint8_t* to, std::uint32_t value);

// A chunk: length, type, contents, checksum of type and contents (§5.3).
void append_chunk(Bytes& out, std::string_view type, std::span<const std::uint8_t> contents);

// Signature, size and everything else before the pixels. Throws InputError as PngEncoder does.
Bytes front(int width_px, int height_px, bool opaque, std::span<const std::uint8_t> description);
Bytes description(const PngOptions& options);
Bytes back();

// Bytes of a row of samples with its filter's.
std::size_t row_size(int width_px, bool opaque);

// n_rows rows from y on, each after its filter's byte, into row_size · n_rows bytes.
void filter_rows(const Image& image, bool opaque, Filter filter, int y, int n_rows,
                 std::uint8_t* to);

}  // namespace poinsot::png
