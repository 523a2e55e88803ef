// The bytes of PNG files with 8 bits per channel in sRGB: the format of stills and of golden
// pictures.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "image/deep_image.h"
#include "image/image.h"

namespace poinsot {

struct PngOptions {
    std::map<std::string, std::string> texts;  // keyword (1–79 characters of Latin-1) → UTF-8 text
    double pixels_per_metre = 0;               // 0: not stored
    int deflate_level = 4;                     // of libdeflate, 1–12
};

// The metadata of a PNG file.
struct PngInfo {
    std::map<std::string, std::string> texts;
    double pixels_per_metre = 0;  // 0: not stored, or not square
    int width_px = 0, height_px = 0;
    int bit_depth = 8;               // of a component: 16, or 8, also for files with fewer bits
    std::size_t n_bytes_behind = 0;  // after its end
    // The colour space of the samples: "sRGB", also if the file names none; "gamma 1", "an ICC
    // profile (SHA-256 …)".
    std::string colours = "sRGB";
};

// A picture with all stored bits.
struct StoredPicture {
    Image image;     // 8 bits per component, rounded if the file has 16
    DeepImage deep;  // if the file has 16 bits; else empty
    PngInfo info;
};

// The largest side of a picture that is drawn and written at once.
inline constexpr int largest_png_side_px = 16384;
// The largest side of a picture that is written band by band, and of any picture that is read.
inline constexpr int largest_banded_png_side_px = 65536;
// The largest number of pixels that are read into memory: 1 GiB. Larger pictures are rejected
// before memory is allocated.
inline constexpr std::int64_t most_png_pixels = std::int64_t{1} << 28;

// Encodes PNG files in memory and reuses its buffers: for sequences. Move-only.
class PngEncoder {
 public:
    // Throws: InputError for a keyword, a density or a level that PNG cannot hold.
    explicit PngEncoder(const PngOptions& options = {});
    ~PngEncoder();
    PngEncoder(PngEncoder&&) noexcept;
    PngEncoder& operator=(PngEncoder&&) noexcept;

    // Returns the file's bytes, valid until the next call: RGB if every pixel is opaque, else RGBA
    // (not premultiplied). The bytes are identical on every machine with the same libdeflate
    // version. Throws: InputError for an empty picture, or one larger than the reader accepts.
    std::span<const std::uint8_t> encode(const Image& image);

    // Sets the texts of the following pictures. Throws: InputError for a keyword that PNG cannot
    // hold.
    void set_texts(const std::map<std::string, std::string>& texts);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Encodes one picture with a temporary PngEncoder.
std::vector<std::uint8_t> encode_png(const Image& image, const PngOptions& options = {});

// Encodes the picture by the nearest of 1 to 256 colours, as small as it can be; ignores alpha.
// throws: InputError for an empty picture, or one that is too large.
std::vector<std::uint8_t> encode_palette_png(const Image& image, std::span<const Rgba8> palette);

// Decodes any PNG to 8-bit RGBA: palettes and greys are expanded, 16 bits rounded to 8, other
// samples unchanged. `name` is used in messages. Throws: InputError for an incomplete or invalid
// PNG, an animation, or more than most_png_pixels.
Image decode_png(std::span<const std::uint8_t> file, const std::string& name,
                 PngInfo* info = nullptr);

// The same with every stored bit. Throws: as decode_png.
StoredPicture decode_stored_png(std::span<const std::uint8_t> file, const std::string& name);

// Reads the metadata before and after the pixels without decoding the pixels; the picture may have
// any size. Throws: as decode_png.
PngInfo decode_png_info(std::span<const std::uint8_t> file, const std::string& name);

}  // namespace poinsot
