// The PNG reader, based on libpng. libpng reports errors by longjmp, so every stage that may fail
// is a function without local objects; its data belongs to the caller.
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <map>

#include "error/error.h"
#include "image/pixels_xxh64.h"
#include "image/png.h"
#include "system/sha256.h"
#include "text/utf8.h"

namespace poinsot {

namespace {

// Larger text chunks and colour profiles are rejected.
constexpr png_alloc_size_t largest_chunk_bytes = 4u << 20;
// Deflate encodes at most 258 bytes in 2 bits.
constexpr std::size_t largest_deflate_ratio = 1032;

struct Source {
    std::span<const std::uint8_t> file;
    std::size_t position = 0;
    std::size_t n_bytes_behind = 0;  // of the file, after the picture's end
    std::array<char, 160> message{};
    png_structp png = nullptr;
    png_infop info = nullptr;

    Source() = default;
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;
    ~Source() { png_destroy_read_struct(&png, &info, nullptr); }
};

void on_error(png_structp png, png_const_charp message) {
    auto& source = *static_cast<Source*>(png_get_error_ptr(png));
    std::strncpy(source.message.data(), message, source.message.size() - 1);
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_read(png_structp png, png_bytep to, std::size_t size) {
    auto& source = *static_cast<Source*>(png_get_io_ptr(png));
    if (size > source.file.size() - source.position) png_error(png, "the file is cut short");
    std::memcpy(to, source.file.data() + source.position, size);
    source.position += size;
}

bool read_header(Source& source) {
    if (setjmp(png_jmpbuf(source.png))) return false;
    png_set_read_fn(source.png, &source, on_read);
    png_set_user_limits(source.png, largest_banded_png_side_px, largest_banded_png_side_px);
    png_set_chunk_malloc_max(source.png, largest_chunk_bytes);
    png_set_crc_action(source.png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_read_info(source.png, source.info);
    return true;
}

// Requests 16-bit samples in little-endian order, as this processor stores them.
bool choose_rgba(Source& source, bool deep) {
    if (setjmp(png_jmpbuf(source.png))) return false;
    png_set_expand(source.png);
    if (deep)
        png_set_swap(source.png);
    else
        png_set_scale_16(source.png);
    png_set_gray_to_rgb(source.png);
    png_set_add_alpha(source.png, deep ? 0xffff : 0xff, PNG_FILLER_AFTER);
    png_set_interlace_handling(source.png);
    png_read_update_info(source.png, source.info);
    return true;
}

bool read_pixels(Source& source, png_bytepp rows) {
    if (setjmp(png_jmpbuf(source.png))) return false;
    png_read_image(source.png, rows);
    png_read_end(source.png, source.info);
    return true;
}

std::string utf8_of_latin1(std::string_view latin1) {
    std::string utf8;
    for (const char c : latin1) utf8 += utf8_of(static_cast<unsigned char>(c));
    return utf8;
}

std::string colours_of(std::span<const std::uint8_t> file);

PngInfo info_of(const Source& source) {
    PngInfo info;
    info.width_px = static_cast<int>(png_get_image_width(source.png, source.info));
    info.height_px = static_cast<int>(png_get_image_height(source.png, source.info));
    info.bit_depth = png_get_bit_depth(source.png, source.info) == 16 ? 16 : 8;
    info.colours = colours_of(source.file);
    info.n_bytes_behind = source.n_bytes_behind;
    png_textp texts = nullptr;
    int n_texts = 0;
    png_get_text(source.png, source.info, &texts, &n_texts);
    for (int i = 0; i < n_texts; ++i) {
        const bool international = texts[i].compression > 0;
        const std::string_view text(texts[i].text,
                                    international ? texts[i].itxt_length : texts[i].text_length);
        info.texts[texts[i].key] = international ? std::string(text) : utf8_of_latin1(text);
    }
    info.pixels_per_metre = png_get_pixels_per_meter(source.png, source.info);
    return info;
}

std::uint32_t u32_at(std::span<const std::uint8_t> bytes, std::size_t offset) {
    return std::uint32_t{bytes[offset]} << 24 | std::uint32_t{bytes[offset + 1]} << 16 |
           std::uint32_t{bytes[offset + 2]} << 8 | std::uint32_t{bytes[offset + 3]};
}

// Checks the signature and the size before any call of libpng.
void check_start(std::span<const std::uint8_t> file, const std::string& name, bool with_pixels) {
    constexpr std::size_t header_end = 33;
    if (file.size() < 8 || png_sig_cmp(file.data(), 0, 8) != 0)
        throw InputError(fmt::format("{} is not a PNG picture", name));
    if (file.size() < header_end) throw InputError(fmt::format("{} is cut short", name));
    const std::uint32_t width = u32_at(file, 16), height = u32_at(file, 20);
    if (width > largest_banded_png_side_px || height > largest_banded_png_side_px)
        throw InputError(fmt::format("{} is {}×{} pixels; poinsot reads at most {} per side", name,
                                     width, height, largest_banded_png_side_px));
    if (with_pixels && std::int64_t{width} * height > most_png_pixels)
        throw InputError(fmt::format("{} is {}×{} pixels; poinsot reads at most {} million pixels",
                                     name, width, height, most_png_pixels / 1'000'000));
}

// The chunks before the pixels by type; of several, the first.
using Chunks = std::map<std::string, std::span<const std::uint8_t>, std::less<>>;

// Precondition: check_chunks has passed.
Chunks chunks_before_pixels(std::span<const std::uint8_t> file) {
    Chunks chunks;
    for (std::size_t at = 8; at < file.size();) {
        const std::size_t length = u32_at(file, at);
        const std::string type(reinterpret_cast<const char*>(file.data()) + at + 4, 4);
        if (type == "IDAT" || type == "IEND") break;
        chunks.emplace(type, file.subspan(at + 8, length));
        at += 12 + length;
    }
    return chunks;
}

std::string hexadecimal(std::span<const std::uint8_t> bytes) {
    std::string digits;
    for (const std::uint8_t byte : bytes) digits += fmt::format("{:02x}", byte);
    return digits;
}

// If several colour chunks are present, the first in this order has precedence. Source: PNG
// specification (third edition), §4.3.
std::string colours_of(std::span<const std::uint8_t> file) {
    const Chunks chunks = chunks_before_pixels(file);
    if (const auto cicp = chunks.find("cICP"); cicp != chunks.end())
        return fmt::format("code points {}", hexadecimal(cicp->second));
    if (const auto profile = chunks.find("iCCP"); profile != chunks.end()) {
        Sha256 hash;
        hash.add(profile->second);
        return fmt::format("an ICC profile (SHA-256 {}…)", hash.finish().substr(0, 16));
    }
    if (chunks.contains("sRGB")) return "sRGB";
    // In units of 1/100,000: the values equivalent to sRGB (§11.3.2.5).
    constexpr std::uint32_t unit = 100'000, srgb_gamma = 45'455;
    constexpr std::array<std::uint32_t, 8> srgb_points{31270, 32900, 64000, 33000,
                                                       30000, 60000, 15000, 6000};
    std::string words;
    const auto gamma = chunks.find("gAMA");
    if (gamma != chunks.end() && gamma->second.size() == 4 &&
        u32_at(gamma->second, 0) != srgb_gamma)
        words = fmt::format("gamma {:g}", static_cast<double>(u32_at(gamma->second, 0)) / unit);
    const auto points = chunks.find("cHRM");
    if (points != chunks.end() && points->second.size() == 4 * srgb_points.size()) {
        bool of_srgb = true;
        for (std::size_t i = 0; i < srgb_points.size(); ++i)
            of_srgb = of_srgb && u32_at(points->second, 4 * i) == srgb_points[i];
        if (!of_srgb)
            words += fmt::format("{}primaries {}", words.empty() ? "" : ", ",
                                 hexadecimal(points->second));
    }
    return words.empty() ? "sRGB" : words;
}

// libpng takes memory for a chunk by the length that it claims, before reading it. Returns how many
// bytes follow the last chunk.
std::size_t check_chunks(std::span<const std::uint8_t> file, const std::string& name) {
    std::size_t at = 8;
    while (at < file.size()) {
        if (file.size() - at < 12) throw InputError(fmt::format("{} is cut short", name));
        const std::size_t length = u32_at(file, at);
        const std::string_view type(reinterpret_cast<const char*>(file.data()) + at + 4, 4);
        if (length > file.size() - at - 12) throw InputError(fmt::format("{} is cut short", name));
        if (length > largest_chunk_bytes && type != "IDAT")
            throw InputError(
                fmt::format("{} is a broken PNG picture: a chunk without pixels has {} bytes; "
                            "poinsot reads at most {}",
                            name, length, largest_chunk_bytes));
        if (type == "acTL")
            throw InputError(fmt::format("{} is an animated PNG; give a single picture", name));
        at += 12 + length;
        if (type == "IEND") break;
    }
    return file.size() - at;
}

[[noreturn]] void refuse(const Source& source, const std::string& name) {
    throw InputError(fmt::format("{} is a broken PNG picture: {}", name, source.message.data()));
}

// Reads everything before the pixels. Precondition: the file has been checked.
void begin_checked(std::span<const std::uint8_t> file, const std::string& name, Source& source) {
    source.file = file;
    source.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, on_error, on_warning);
    if (source.png) source.info = png_create_info_struct(source.png);
    if (!source.info) throw EnvironmentError("no memory to read a PNG picture");
    if (!read_header(source)) refuse(source, name);
}

void begin(std::span<const std::uint8_t> file, const std::string& name, bool with_pixels,
           Source& source) {
    check_start(file, name, with_pixels);
    source.n_bytes_behind = check_chunks(file, name);
    begin_checked(file, name, source);
}

bool read_indices(Source& source, png_bytepp rows) {
    if (setjmp(png_jmpbuf(source.png))) return false;
    png_set_packing(source.png);  // a byte each
    png_set_interlace_handling(source.png);
    png_read_update_info(source.png, source.info);
    png_read_image(source.png, rows);
    return true;
}

// Refuses a picture in which a pixel's index is beyond the palette: libpng would show black.
void check_indices(const Source& source, const std::string& name) {
    png_colorp colours = nullptr;
    int n_colours = 0;
    if (png_get_color_type(source.png, source.info) != PNG_COLOR_TYPE_PALETTE) return;
    png_get_PLTE(source.png, source.info, &colours, &n_colours);
    if (n_colours == 1 << png_get_bit_depth(source.png, source.info)) return;
    Source again;
    begin_checked(source.file, name, again);
    const std::size_t width = png_get_image_width(again.png, again.info);
    std::vector<png_byte> indices(width * png_get_image_height(again.png, again.info));
    std::vector<png_bytep> rows;
    for (std::size_t at = 0; at < indices.size(); at += width) rows.push_back(&indices[at]);
    if (!read_indices(again, rows.data())) refuse(again, name);
    if (const int largest = *std::max_element(indices.begin(), indices.end()); largest >= n_colours)
        throw InputError(fmt::format(
            "{} is a broken PNG picture: a pixel has the colour {}, and the palette has {} colours",
            name, largest + 1, n_colours));
}

// Reads the pixels into rows of 8-bit or 16-bit samples.
template <typename Picture, typename Sample>
Picture read_samples(Source& source, const std::string& name,
                     std::span<Sample> (Picture::*samples)()) {
    constexpr bool deep = sizeof(Sample) == 2;
    // A short file cannot hold a large picture; allocate nothing before this check.
    const std::size_t height = png_get_image_height(source.png, source.info);
    if (png_get_rowbytes(source.png, source.info) * height / largest_deflate_ratio >
        source.file.size())
        throw InputError(fmt::format("{} is cut short", name));
    check_indices(source, name);
    if (!choose_rgba(source, deep)) refuse(source, name);
    Picture picture(static_cast<int>(png_get_image_width(source.png, source.info)),
                    static_cast<int>(height));
    std::vector<png_bytep> rows(height);
    for (std::size_t y = 0; y < height; ++y)
        rows[y] = reinterpret_cast<png_bytep>((picture.*samples)().data() +
                                              4 * y * static_cast<std::size_t>(picture.width()));
    if (!read_pixels(source, rows.data())) refuse(source, name);
    return picture;
}

Image read_image(Source& source, const std::string& name) {
    return read_samples<Image, std::uint8_t>(source, name, &Image::bytes);
}

// Rounds to the nearest level, as libpng does.
Image rounded(const DeepImage& deep) {
    Image image(deep.width(), deep.height());
    std::transform(
        deep.samples().begin(), deep.samples().end(), image.bytes().begin(),
        [](std::uint16_t v) { return static_cast<std::uint8_t>((v * 255u + 32895) >> 16); });
    return image;
}

}  // namespace

Image decode_png(std::span<const std::uint8_t> file, const std::string& name, PngInfo* info) {
    Source source;
    begin(file, name, true, source);
    Image image = read_image(source, name);
    if (info) *info = info_of(source);
    return image;
}

StoredPicture decode_stored_png(std::span<const std::uint8_t> file, const std::string& name) {
    Source source;
    begin(file, name, true, source);
    StoredPicture picture;
    if (png_get_bit_depth(source.png, source.info) == 16) {
        picture.deep = read_samples<DeepImage, std::uint16_t>(source, name, &DeepImage::samples);
        picture.image = rounded(picture.deep);
    } else {
        picture.image = read_image(source, name);
    }
    picture.info = info_of(source);
    return picture;
}

namespace {

// The file with all metadata moved before the pixels, and only the beginning of the pixels.
// Precondition: check_chunks has passed.
std::vector<std::uint8_t> without_pixels(std::span<const std::uint8_t> file) {
    const std::span<const std::uint8_t> signature = file.first(8);
    std::vector<std::uint8_t> result(signature.begin(), signature.end());
    std::span<const std::uint8_t> first_pixels;
    for (std::size_t at = 8; at < file.size();) {
        const std::size_t size = 12 + u32_at(file, at);
        const auto chunk = file.subspan(at, size);
        const std::string_view type(reinterpret_cast<const char*>(chunk.data()) + 4, 4);
        if (type == "IEND") break;
        if (type != "IDAT")
            result.insert(result.end(), chunk.begin(), chunk.end());
        else if (first_pixels.empty())
            first_pixels = chunk.first(8);
        at += size;
    }
    result.insert(result.end(), first_pixels.begin(), first_pixels.end());
    return result;
}

bool read_row(Source& source, png_bytep row) {
    if (setjmp(png_jmpbuf(source.png))) return false;
    png_read_row(source.png, row, nullptr);
    return true;
}

template <typename Sample>
std::string check_of_rows(Source& source, const std::string& name) {
    constexpr bool deep = sizeof(Sample) == 2;
    const auto width = static_cast<int>(png_get_image_width(source.png, source.info));
    const auto height = static_cast<int>(png_get_image_height(source.png, source.info));
    if (!choose_rgba(source, deep)) refuse(source, name);
    std::vector<Sample> row(4u * static_cast<std::size_t>(width));
    PixelsXxh64 check(width, height, deep ? 16 : 8);
    for (int y = 0; y < height; ++y) {
        if (!read_row(source, reinterpret_cast<png_bytep>(row.data()))) refuse(source, name);
        check.add(std::span<const Sample>(row));
    }
    return check.digits();
}

}  // namespace

std::string pixels_xxh64_of(std::span<const std::uint8_t> file, const std::string& name) {
    Source source;
    begin(file, name, false, source);
    // An interlaced picture has its rows in seven passes: read it whole.
    if (png_get_interlace_type(source.png, source.info) != PNG_INTERLACE_NONE)
        return pixels_xxh64(decode_stored_png(file, name));
    return png_get_bit_depth(source.png, source.info) == 16
               ? check_of_rows<std::uint16_t>(source, name)
               : check_of_rows<std::uint8_t>(source, name);
}

PngInfo decode_png_info(std::span<const std::uint8_t> file, const std::string& name) {
    check_start(file, name, false);
    Source source;
    source.n_bytes_behind = check_chunks(file, name);
    const std::vector<std::uint8_t> said = without_pixels(file);
    begin_checked(said, name, source);
    return info_of(source);
}

}  // namespace poinsot
