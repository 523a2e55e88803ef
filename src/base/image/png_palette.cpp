// Small PNG files: a byte a pixel (PNG specification §11.2.3, "Indexed-colour").
#include <libdeflate.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <unordered_map>

#include "error/error.h"
#include "image/png.h"
#include "image/png_chunks.h"
#include "image/zlib_stream.h"

namespace poinsot {

namespace {

std::uint8_t nearest(std::span<const Rgba8> palette, const std::uint8_t* rgb) {
    std::size_t best = 0;
    int least = std::numeric_limits<int>::max();
    for (std::size_t k = 0; k < palette.size(); ++k) {
        const int r = rgb[0] - palette[k].r, g = rgb[1] - palette[k].g, b = rgb[2] - palette[k].b;
        const int distance = r * r + g * g + b * b;
        if (distance < least) least = distance, best = k;
    }
    return static_cast<std::uint8_t>(best);
}

// The rows, each after its filter byte.
png::Bytes rows_of(const Image& image, std::span<const Rgba8> palette) {
    std::unordered_map<std::uint32_t, std::uint8_t> known;
    png::Bytes rows;
    const std::uint8_t* rgb = image.bytes().data();
    for (int y = 0; y < image.height(); ++y) {
        rows.push_back(static_cast<std::uint8_t>(png::Filter::none));
        for (int x = 0; x < image.width(); ++x, rgb += 4) {
            const std::uint32_t colour =
                std::uint32_t{rgb[0]} << 16 | std::uint32_t{rgb[1]} << 8 | rgb[2];
            const auto [entry, is_new] = known.try_emplace(colour);
            if (is_new) entry->second = nearest(palette, rgb);
            rows.push_back(entry->second);
        }
    }
    return rows;
}

}  // namespace

std::vector<std::uint8_t> encode_palette_png(const Image& image, std::span<const Rgba8> palette) {
    png::Bytes colours;
    for (const Rgba8& colour : palette)
        colours.insert(colours.end(), {colour.r, colour.g, colour.b});
    png::Bytes file = png::front({image.width(), image.height(), true, 8, true},
                                 largest_png_side_px, png::description({}));
    png::append_chunk(file, "PLTE", colours);
    png::append_chunk(file, "IDAT", zlib_stream(rows_of(image, palette)));
    const png::Bytes back = png::back();
    file.insert(file.end(), back.begin(), back.end());
    return file;
}

}  // namespace poinsot
