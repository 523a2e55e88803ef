// The writer. libpng's own deflate is zlib, which takes twice the time of libdeflate for the same
// size on flat pictures with thin lines; so the few chunks are written here, and libpng reads.
#include <fmt/format.h>
#include <libdeflate.h>

#include <cmath>
#include <memory>

#include "error/error.h"
#include "image/alpha.h"
#include "image/atomic_file.h"
#include "image/png.h"

namespace poinsot {

namespace {

using Bytes = std::vector<std::uint8_t>;

void append_u32(Bytes& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        out.push_back(static_cast<std::uint8_t>(value >> shift));
}

// A chunk: length, type, contents, checksum of type and contents (PNG specification §5.3).
void append_chunk(Bytes& out, const char (&type)[5], std::span<const std::uint8_t> contents) {
    append_u32(out, static_cast<std::uint32_t>(contents.size()));
    const std::size_t start = out.size();
    out.insert(out.end(), type, type + 4);
    out.insert(out.end(), contents.begin(), contents.end());
    append_u32(out, libdeflate_crc32(0, out.data() + start, out.size() - start));
}

// Rows of samples, each after the byte that says "no filter": on flat areas and thin lines the
// filters cost time and size both.
Bytes filtered_rows(const Image& image, bool opaque) {
    const auto width = static_cast<std::size_t>(image.width());
    const auto height = static_cast<std::size_t>(image.height());
    const std::size_t n_channels = opaque ? 3 : 4;
    Bytes rows(height * (1 + n_channels * width));
    const std::uint8_t* from = image.bytes().data();
    std::uint8_t* to = rows.data();
    for (std::size_t y = 0; y < height; ++y) {
        *to++ = 0;
        if (!opaque) {
            std::copy(from, from + 4 * width, to);
        } else {
            for (std::size_t x = 0; x < width; ++x) {
                to[3 * x] = from[4 * x];
                to[3 * x + 1] = from[4 * x + 1];
                to[3 * x + 2] = from[4 * x + 2];
            }
        }
        from += 4 * width;
        to += n_channels * width;
    }
    return rows;
}

Bytes deflated(const Bytes& raw, int level) {
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(level), libdeflate_free_compressor);
    if (!compressor) throw InputError(fmt::format("deflate level {} is not one of 1 to 12", level));
    Bytes out(libdeflate_zlib_compress_bound(compressor.get(), raw.size()));
    out.resize(
        libdeflate_zlib_compress(compressor.get(), raw.data(), raw.size(), out.data(), out.size()));
    return out;
}

// iTXt (§11.3.4.5): keyword, no compression, no language, UTF-8 text.
void append_text(Bytes& out, const std::string& keyword, const std::string& text) {
    if (keyword.empty() || keyword.size() > 79 || keyword.find('\0') != std::string::npos)
        throw InputError(fmt::format("a PNG keyword has 1 to 79 letters; \"{}\" has not", keyword));
    Bytes contents(keyword.begin(), keyword.end());
    contents.insert(contents.end(), 5, 0);
    contents.insert(contents.end(), text.begin(), text.end());
    append_chunk(out, "iTXt", contents);
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, const PngOptions& options) {
    if (image.empty()) throw InputError("an empty picture cannot be a PNG");
    const bool opaque = is_opaque(image);
    Bytes out = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    Bytes header;
    append_u32(header, static_cast<std::uint32_t>(image.width()));
    append_u32(header, static_cast<std::uint32_t>(image.height()));
    const std::uint8_t colour_type = opaque ? 2 : 6;
    for (const std::uint8_t value :
         {std::uint8_t{8}, colour_type, std::uint8_t{0}, std::uint8_t{0}, std::uint8_t{0}})
        header.push_back(value);
    append_chunk(out, "IHDR", header);
    append_chunk(out, "sRGB", Bytes{0});
    if (options.pixels_per_metre > 0) {
        Bytes density;
        const auto per_metre = static_cast<std::uint32_t>(std::lround(options.pixels_per_metre));
        append_u32(density, per_metre);
        append_u32(density, per_metre);
        density.push_back(1);
        append_chunk(out, "pHYs", density);
    }
    for (const auto& [keyword, text] : options.texts) append_text(out, keyword, text);
    append_chunk(out, "IDAT", deflated(filtered_rows(image, opaque), options.deflate_level));
    append_chunk(out, "IEND", {});
    return out;
}

void write_png(const std::filesystem::path& path, const Image& image, const PngOptions& options) {
    const Bytes contents = encode_png(image, options);
    AtomicFile file(path);
    file.write(contents);
    file.commit();
}

}  // namespace poinsot
