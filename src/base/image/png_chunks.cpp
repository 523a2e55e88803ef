#include "image/png_chunks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "error/error.h"
#include "image/crc32.h"
#include "text/printable.h"

namespace poinsot::png {

namespace {

void append_u32(Bytes& out, std::uint32_t value) {
    out.resize(out.size() + 4);
    put_u32(out.data() + out.size() - 4, value);
}

// iTXt (§11.3.4.5): keyword, no compression, no language, UTF-8 text.
void append_text(Bytes& out, const std::string& keyword, const std::string& text) {
    const bool plain =
        std::all_of(keyword.begin(), keyword.end(), [](char c) { return c >= ' ' && c <= '~'; });
    if (keyword.empty() || keyword.size() > 79 || !plain || keyword.front() == ' ' ||
        keyword.back() == ' ' || keyword.find("  ") != std::string::npos)
        throw InputError(fmt::format(
            "\"{}\" cannot name a text in a PNG: 1 to 79 letters are needed", printable(keyword)));
    Bytes contents(keyword.begin(), keyword.end());
    contents.insert(contents.end(), 5, 0);
    contents.insert(contents.end(), text.begin(), text.end());
    append_chunk(out, "iTXt", contents);
}

// Subtracts from each sample that of the previous pixel.
template <std::size_t n_channels>
void subtract_left(const std::uint8_t* rgba, std::size_t width, std::uint8_t* to) {
    for (std::size_t c = 0; c < n_channels; ++c) to[c] = rgba[c];
    for (std::size_t x = 1; x < width; ++x)
        for (std::size_t c = 0; c < n_channels; ++c)
            to[n_channels * x + c] =
                static_cast<std::uint8_t>(rgba[4 * x + c] - rgba[4 * x - 4 + c]);
}

template <std::size_t n_channels>
void copy_samples(const std::uint8_t* rgba, std::size_t width, std::uint8_t* to) {
    for (std::size_t x = 0; x < width; ++x)
        for (std::size_t c = 0; c < n_channels; ++c) to[n_channels * x + c] = rgba[4 * x + c];
}

}  // namespace

void put_u32(std::uint8_t* to, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) to[i] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
}

void append_chunk(Bytes& out, std::string_view type, std::span<const std::uint8_t> contents) {
    append_u32(out, static_cast<std::uint32_t>(contents.size()));
    const std::size_t start = out.size();
    out.insert(out.end(), type.begin(), type.end());
    out.insert(out.end(), contents.begin(), contents.end());
    append_u32(out, crc32_after(0, std::span(out).subspan(start)));
}

Bytes description(const PngOptions& options) {
    Bytes out;
    append_chunk(out, "sRGB", Bytes{0});
    if (options.pixels_per_metre != 0) {
        constexpr double largest = 2147483647;
        if (!(options.pixels_per_metre > 0 && options.pixels_per_metre < largest))
            throw InputError(
                fmt::format("a PNG cannot have {} pixels per metre", options.pixels_per_metre));
        const auto per_metre = static_cast<std::uint32_t>(std::lround(options.pixels_per_metre));
        Bytes density;
        append_u32(density, per_metre);
        append_u32(density, per_metre);
        density.push_back(1);
        append_chunk(out, "pHYs", density);
    }
    for (const auto& [keyword, text] : options.texts) append_text(out, keyword, text);
    return out;
}

Bytes front(const Format& format, int largest_side_px, std::span<const std::uint8_t> description) {
    const auto [width_px, height_px, opaque, bit_depth, has_palette] = format;
    if (width_px <= 0 || height_px <= 0) throw InputError("an empty picture cannot be a PNG");
    if (width_px > largest_side_px || height_px > largest_side_px)
        throw InputError(
            fmt::format("a picture of {}×{} pixels is too large; a side has at most {}", width_px,
                        height_px, largest_side_px));
    Bytes out = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    Bytes header;
    append_u32(header, static_cast<std::uint32_t>(width_px));
    append_u32(header, static_cast<std::uint32_t>(height_px));
    const std::uint8_t colour_type = has_palette ? 3 : opaque ? 2 : 6;
    header.insert(header.end(), {static_cast<std::uint8_t>(bit_depth), colour_type, 0, 0, 0});
    append_chunk(out, "IHDR", header);
    out.insert(out.end(), description.begin(), description.end());
    return out;
}

Bytes back(const std::map<std::string, std::string>& texts) {
    Bytes out;
    for (const auto& [keyword, text] : texts) append_text(out, keyword, text);
    append_chunk(out, "IEND", {});
    return out;
}

std::size_t Format::row_size() const {
    const std::size_t n_bytes = (opaque ? 3u : 4u) * (bit_depth == 16 ? 2u : 1u);
    return 1 + n_bytes * static_cast<std::size_t>(width_px);
}

void filter_rows(const Image& image, bool opaque, Filter filter, int y, int n_rows,
                 std::uint8_t* to) {
    const auto width = static_cast<std::size_t>(image.width());
    const std::size_t row_size = Format{image.width(), n_rows, opaque, 8}.row_size();
    const std::uint8_t* from = image.bytes().data() + 4 * width * static_cast<std::size_t>(y);
    const auto fill = filter == Filter::none ? (opaque ? copy_samples<3> : copy_samples<4>)
                                             : (opaque ? subtract_left<3> : subtract_left<4>);
    for (int row = 0; row < n_rows; ++row) {
        *to = static_cast<std::uint8_t>(filter);
        fill(from, width, to + 1);
        from += 4 * width;
        to += row_size;
    }
}

void filter_rows(const DeepImage& image, bool opaque, std::uint8_t* to) {
    const std::size_t n_channels = opaque ? 3 : 4;
    const auto width = static_cast<std::size_t>(image.width());
    const std::uint16_t* row = image.samples().data();
    for (int y = 0; y < image.height(); ++y, row += 4 * width) {
        *to++ = static_cast<std::uint8_t>(Filter::sub);
        for (std::size_t x = 0; x < width; ++x) {
            for (std::size_t c = 0; c < n_channels; ++c) {
                const std::uint16_t now = row[4 * x + c];
                const std::uint16_t left = x == 0 ? std::uint16_t{0} : row[4 * x - 4 + c];
                // Samples are stored big-endian and filtered byte by byte (§9.2).
                *to++ = static_cast<std::uint8_t>((now >> 8) - (left >> 8));
                *to++ = static_cast<std::uint8_t>((now & 0xff) - (left & 0xff));
            }
        }
    }
}

}  // namespace poinsot::png
