// Any bytes as a film: its record must be read and compared with its packets, or be refused with a
// message. Defects of FFmpeg's demuxers are outside its scope.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "encoding/film_packets.h"
#include "error/error.h"
#include "fuzz/scratch_file.h"
#include "production/records/record.h"
#include "production/records/verify.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // The first byte selects the file name of the rest.
    if (size == 0) return 0;
    const char* const name = data[0] % 3 == 0 ? "a.mp4" : data[0] % 3 == 1 ? "a.webm" : "a.gif";
    const auto film = poinsot::fuzz::scratch_file(name, data + 1, size - 1);
    try {
        poinsot::packet_hash_of(film);
    } catch (const poinsot::InputError& error) {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
    }
    try {
        poinsot::verify(film, poinsot::read_record(film));
    } catch (const poinsot::InputError& error) {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
    }
    return 0;
}
