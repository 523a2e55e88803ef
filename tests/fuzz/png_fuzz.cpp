// Any bytes as a PNG: the picture must read back equal after writing, or be refused with a message.
#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "error/error.h"
#include "image/png.h"

namespace {

std::uint32_t big_endian(const std::uint8_t* bytes) {
    return std::uint32_t{bytes[0]} << 24U | std::uint32_t{bytes[1]} << 16U |
           std::uint32_t{bytes[2]} << 8U | std::uint32_t{bytes[3]};
}

constexpr std::size_t signature_bytes = 8;

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

// A changed byte makes a chunk's checksum wrong, and the reader would stop there: in three of four
// cases, the checksums are corrected after a mutation (PNG, 3rd ed., §5.3).
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
    size = LLVMFuzzerMutate(data, size, most);
    if (seed % 4 == 0) return size;
    std::size_t at = signature_bytes;
    while (at + 12 <= size) {
        const std::size_t length = big_endian(data + at);
        if (length > size - at - 12) break;
        const uLong sum = crc32(0, data + at + 4, static_cast<uInt>(length + 4));
        for (std::size_t i = 0; i < 4; ++i)
            data[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
        at += 12 + length;
    }
    return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    poinsot::PngInfo info;
    poinsot::Image image;
    try {
        image = poinsot::decode_png({data, size}, "fuzz.png", &info);
    } catch (const poinsot::InputError& error) {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
        return 0;
    }
    // With all stored bits it is the same picture.
    if (!(poinsot::decode_stored_png({data, size}, "fuzz.png").image == image)) std::abort();
    poinsot::PngOptions options;
    options.deflate_level = 1;
    if (!(poinsot::decode_png(poinsot::encode_png(image, options), "again.png") == image))
        std::abort();
    return 0;
}
