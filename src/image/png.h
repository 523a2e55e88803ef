// PNG files: the still's own format, and that of golden pictures. 8 bits a channel, sRGB.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "image/deep_image.h"
#include "image/image.h"

namespace poinsot {

struct PngOptions {
    std::map<std::string, std::string> texts;  // keyword (1–79 of Latin-1) → UTF-8 text
    double pixels_per_metre = 0;               // 0: not said
    int deflate_level = 4;                     // of libdeflate, 1–12
};

// What a PNG file says besides its pixels.
struct PngInfo {
    std::map<std::string, std::string> texts;
    double pixels_per_metre = 0;  // 0: not said, or not square
    int width_px = 0, height_px = 0;
    int bit_depth = 8;               // of a component: 16, or 8, which stands for less, too
    std::size_t n_bytes_behind = 0;  // that follow its end
    // By what its samples become colours, in words: "sRGB", which is also what a file means that
    // says nothing; "gamma 1", "an ICC profile (SHA-256 …)".
    std::string colours = "sRGB";
};

// A picture with all that its file holds of it.
struct StoredPicture {
    Image image;     // with 8 bits a component, rounded where there are 16
    DeepImage deep;  // where there are 16; else empty
    PngInfo info;
};

// The largest side of a picture that is drawn and written at once.
inline constexpr int largest_png_side_px = 16384;
// The largest of one written band by band, and of any that is read.
inline constexpr int largest_banded_png_side_px = 65536;
// The most pixels that are read into memory: 1 GiB. More are refused before any is taken.
inline constexpr std::int64_t most_png_pixels = std::int64_t{1} << 28;

// Makes PNG files in memory, keeping its buffers between pictures: for sequences. Move-only.
class PngEncoder {
 public:
    // Throws: InputError for a keyword, a density or a level that PNG cannot hold.
    explicit PngEncoder(const PngOptions& options = {});
    ~PngEncoder();
    PngEncoder(PngEncoder&&) noexcept;
    PngEncoder& operator=(PngEncoder&&) noexcept;

    // The file's bytes, valid until the next call: RGB when every pixel is opaque, else RGBA (not
    // premultiplied). The same bytes on every machine at one libdeflate version.
    // Throws: InputError for an empty picture, or one larger than what is read again.
    std::span<const std::uint8_t> encode(const Image& image);

    // The texts of pictures from now on. Throws: InputError for a keyword that PNG cannot hold.
    void set_texts(const std::map<std::string, std::string>& texts);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// One picture by a PngEncoder of its own.
std::vector<std::uint8_t> encode_png(const Image& image, const PngOptions& options = {});

// Made aside, synced and renamed. Throws EnvironmentError naming the path and the reason, and then
// leaves nothing.
void write_png(const std::filesystem::path& path, const Image& image,
               const PngOptions& options = {});

// Any PNG as 8-bit RGBA: palettes and greys expanded, 16 bits rounded to 8, samples otherwise as
// stored. `name` stands in messages.
// Throws: InputError for what is not a whole PNG, is an animation, of which the first picture alone
// would be read, or has more than most_png_pixels.
Image decode_png(std::span<const std::uint8_t> file, const std::string& name,
                 PngInfo* info = nullptr);

// Throws: InputError as decode_png, and for a missing file; EnvironmentError if it cannot be read.
Image read_png(const std::filesystem::path& path, PngInfo* info = nullptr);

// The same with every bit that is stored. Throws: as read_png.
StoredPicture decode_stored_png(std::span<const std::uint8_t> file, const std::string& name);
StoredPicture read_stored_png(const std::filesystem::path& path);

// What a PNG file says before and after its pixels, which are not decoded: of any size.
// Throws: as read_png.
PngInfo read_png_info(const std::filesystem::path& path);

}  // namespace poinsot
