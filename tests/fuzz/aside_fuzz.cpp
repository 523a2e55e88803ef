// Any bytes as the log of a killed run: the film must be recovered up to the first defect, or
// refused with a message.
#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "encoding/frame_log.h"
#include "encoding/frame_sink.h"
#include "error/error.h"
#include "fuzz/scratch_file.h"

namespace {

constexpr std::size_t block_head = 8;

std::uint32_t get_u32(const std::uint8_t* at) {
    return std::uint32_t{at[0]} | std::uint32_t{at[1]} << 8U | std::uint32_t{at[2]} << 16U |
           std::uint32_t{at[3]} << 24U;
}

void require_a_sentence(const poinsot::Error& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

// A changed byte makes a block's checksum wrong, and the reader would stop there: in three of four
// cases, sizes and checksums are corrected after a mutation.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
    size = LLVMFuzzerMutate(data, size, most);
    if (seed % 4 == 0) return size;
    for (std::size_t at = 1; at + block_head <= size;) {
        std::size_t length = get_u32(data + at);
        if (length > size - at - block_head) {
            length = size - at - block_head;
            for (std::size_t i = 0; i < 4; ++i)
                data[at + i] = static_cast<std::uint8_t>(length >> 8 * i);
        }
        // FFmpeg's CRC-32 is zlib's before the final inversion of bits.
        const uLong sum = ~crc32(0, data + at + block_head, static_cast<uInt>(length));
        for (std::size_t i = 0; i < 4; ++i)
            data[at + 4 + i] = static_cast<std::uint8_t>(sum >> 8 * i);
        at += block_head + length;
    }
    return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // The first byte selects the suffix of the film's name.
    if (size == 0) return 0;
    const char* const name = data[0] % 3 == 0 ? "a.mp4" : data[0] % 3 == 1 ? "a.webm" : "a.gif";
    const std::filesystem::path film = poinsot::fuzz::scratch_folder() / name;
    const std::filesystem::path aside = poinsot::frame_log_path(film);
    poinsot::fuzz::scratch_file(aside.filename().string(), data + 1, size - 1);
    // As poinsot's own, so that bytes which are no log are read, too.
    std::error_code ignored;
    std::filesystem::permissions(aside, std::filesystem::perms::sticky_bit,
                                 std::filesystem::perm_options::add, ignored);
    try {
        poinsot::recover_film(film);
    } catch (const poinsot::Error& error) {
        require_a_sentence(error);
    }
    std::filesystem::remove(film, ignored);
    std::filesystem::remove(aside, ignored);
    return 0;
}
