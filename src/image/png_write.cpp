// The writer. libpng's own deflate is zlib, which takes twice the time of libdeflate for the same
// size on flat pictures with thin lines; so the few chunks are written here, and libpng reads.
#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>

#include "error/error.h"
#include "image/alpha.h"
#include "image/atomic_file.h"
#include "image/png.h"

namespace poinsot {

namespace {

using Bytes = std::vector<std::uint8_t>;

void put_u32(std::uint8_t* to, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) to[i] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
}

void append_u32(Bytes& out, std::uint32_t value) {
    out.resize(out.size() + 4);
    put_u32(out.data() + out.size() - 4, value);
}

// A chunk: length, type, contents, checksum of type and contents (PNG specification §5.3).
void append_chunk(Bytes& out, std::string_view type, std::span<const std::uint8_t> contents) {
    append_u32(out, static_cast<std::uint32_t>(contents.size()));
    const std::size_t start = out.size();
    out.insert(out.end(), type.begin(), type.end());
    out.insert(out.end(), contents.begin(), contents.end());
    append_u32(out, libdeflate_crc32(0, out.data() + start, out.size() - start));
}

// iTXt (§11.3.4.5): keyword, no compression, no language, UTF-8 text.
void append_text(Bytes& out, const std::string& keyword, const std::string& text) {
    const bool printable =
        std::all_of(keyword.begin(), keyword.end(), [](char c) { return c >= ' ' && c <= '~'; });
    if (keyword.empty() || keyword.size() > 79 || !printable || keyword.front() == ' ' ||
        keyword.back() == ' ' || keyword.find("  ") != std::string::npos)
        throw InputError(
            fmt::format("\"{}\" cannot name a text in a PNG: 1 to 79 letters are needed", keyword));
    Bytes contents(keyword.begin(), keyword.end());
    contents.insert(contents.end(), 5, 0);
    contents.insert(contents.end(), text.begin(), text.end());
    append_chunk(out, "iTXt", contents);
}

// The chunks that say what the samples mean, the same for every picture.
Bytes description(const PngOptions& options) {
    Bytes out;
    append_chunk(out, "sRGB", Bytes{0});
    if (options.pixels_per_metre != 0) {
        if (!(options.pixels_per_metre > 0 && options.pixels_per_metre < 2147483647))
            throw InputError(
                fmt::format("a PNG cannot have {} pixels per metre", options.pixels_per_metre));
        Bytes density;
        append_u32(density, static_cast<std::uint32_t>(std::lround(options.pixels_per_metre)));
        append_u32(density, static_cast<std::uint32_t>(std::lround(options.pixels_per_metre)));
        density.push_back(1);
        append_chunk(out, "pHYs", density);
    }
    for (const auto& [keyword, text] : options.texts) append_text(out, keyword, text);
    return out;
}

Bytes header(const Image& image, bool opaque) {
    Bytes contents;
    append_u32(contents, static_cast<std::uint32_t>(image.width()));
    append_u32(contents, static_cast<std::uint32_t>(image.height()));
    const std::uint8_t colour_type = opaque ? 2 : 6;
    contents.insert(contents.end(), {8, colour_type, 0, 0, 0});
    return contents;
}

// Memory that grows and is never cleared: clearing two buffers of a picture's size costs as much
// as a quarter of the compression.
class Scratch {
 public:
    std::span<std::uint8_t> of_size(std::size_t size) {
        if (size > capacity_) {
            bytes_ = std::make_unique_for_overwrite<std::uint8_t[]>(size);
            capacity_ = size;
        }
        return {bytes_.get(), size};
    }

 private:
    std::unique_ptr<std::uint8_t[]> bytes_;
    std::size_t capacity_ = 0;
};

// Rows of samples, each after the byte that says "no filter": on flat areas and thin lines the
// filters cost time and size both.
std::size_t row_size(const Image& image, bool opaque) {
    return 1 + (opaque ? 3u : 4u) * static_cast<std::size_t>(image.width());
}

void unfiltered_rows(const Image& image, bool opaque, std::span<std::uint8_t> rows) {
    const auto width = static_cast<std::size_t>(image.width());
    const std::uint8_t* from = image.bytes().data();
    std::uint8_t* to = rows.data();
    for (int y = 0; y < image.height(); ++y, from += 4 * width) {
        *to++ = 0;
        if (!opaque) {
            to = std::copy(from, from + 4 * width, to);
            continue;
        }
        for (std::size_t x = 0; x < width; ++x, to += 3) {
            to[0] = from[4 * x];
            to[1] = from[4 * x + 1];
            to[2] = from[4 * x + 2];
        }
    }
}

}  // namespace

struct PngEncoder::Impl {
    using Compressor = std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)>;
    Bytes description;
    Compressor compressor;
    Scratch rows, file;
};

PngEncoder::PngEncoder(const PngOptions& options)
    : impl_(
          new Impl{description(options),
                   {libdeflate_alloc_compressor(options.deflate_level), libdeflate_free_compressor},
                   {},
                   {}}) {
    if (!impl_->compressor)
        throw InputError(
            fmt::format("deflate level {} is not one of 1 to 12", options.deflate_level));
}

PngEncoder::~PngEncoder() = default;
PngEncoder::PngEncoder(PngEncoder&&) noexcept = default;
PngEncoder& PngEncoder::operator=(PngEncoder&&) noexcept = default;

std::span<const std::uint8_t> PngEncoder::encode(const Image& image) {
    if (image.empty()) throw InputError("an empty picture cannot be a PNG");
    if (image.width() > kLargestPngSide_px || image.height() > kLargestPngSide_px)
        throw InputError(
            fmt::format("a picture of {}×{} pixels is too large; a side has at most {}",
                        image.width(), image.height(), kLargestPngSide_px));
    const bool opaque = is_opaque(image);
    const std::size_t n_raw = row_size(image, opaque) * static_cast<std::size_t>(image.height());
    const std::span<std::uint8_t> raw = impl_->rows.of_size(n_raw);
    unfiltered_rows(image, opaque, raw);

    Bytes front = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    append_chunk(front, "IHDR", header(image, opaque));
    front.insert(front.end(), impl_->description.begin(), impl_->description.end());
    Bytes back;
    append_chunk(back, "IEND", {});

    // IDAT is compressed in place, between its length and type and its checksum.
    const std::size_t bound = libdeflate_zlib_compress_bound(impl_->compressor.get(), n_raw);
    std::uint8_t* const start = impl_->file.of_size(front.size() + bound + 12 + back.size()).data();
    std::uint8_t* const idat = std::copy(front.begin(), front.end(), start);
    std::copy_n("IDAT", 4, idat + 4);
    const std::size_t n_deflated =
        libdeflate_zlib_compress(impl_->compressor.get(), raw.data(), raw.size(), idat + 8, bound);
    put_u32(idat, static_cast<std::uint32_t>(n_deflated));
    put_u32(idat + 8 + n_deflated, libdeflate_crc32(0, idat + 4, n_deflated + 4));
    std::uint8_t* const end = std::copy(back.begin(), back.end(), idat + 12 + n_deflated);
    return {start, end};
}

std::vector<std::uint8_t> encode_png(const Image& image, const PngOptions& options) {
    PngEncoder encoder(options);
    const std::span<const std::uint8_t> file = encoder.encode(image);
    return {file.begin(), file.end()};
}

void write_png(const std::filesystem::path& path, const Image& image, const PngOptions& options) {
    PngEncoder encoder(options);
    const std::span<const std::uint8_t> contents = encoder.encode(image);
    AtomicFile file(path);
    file.write(contents);
    file.commit();
}

}  // namespace poinsot
