// Any bytes as the record of a picture or a film: it must read back equal after writing, also from
// a PNG, or be refused with a message.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "encoding/film_metadata.h"
#include "error/error.h"
#include "image/png.h"
#include "production/records/record.h"
#include "system/sha256.h"

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

constexpr std::string_view scene_line = "\nscene-sha256: ";
constexpr std::string_view mesh_line = "\nmesh-sha256: ";

// Returns the value in the line that begins with a key, or an empty view.
std::string_view value_of(std::string_view text, std::string_view key) {
    const std::size_t at = text.find(key);
    if (at == std::string_view::npos) return {};
    const std::size_t from = at + key.size();
    return text.substr(from, text.find('\n', from) - from);
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

// A changed byte makes a hash wrong, and the reader would stop there: in three of four cases, the
// scene's hash is corrected and the seal removed after a mutation.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
    size = LLVMFuzzerMutate(data, size, most);
    if (seed % 4 == 0) return size;
    std::string text(reinterpret_cast<const char*>(data), size);
    if (const std::size_t seal = text.find("\nrecord-sha256: "); seal != std::string::npos)
        text.erase(seal, text.find('\n', seal + 1) - seal);
    const std::size_t blank = text.find("\n\n"), at = text.find(scene_line);
    if (blank != std::string::npos && at < blank) {
        const std::string hash =
            poinsot::sha256_of(text.substr(blank + 2) + std::string(value_of(text, mesh_line)));
        const std::size_t from = at + scene_line.size();
        text.replace(from, text.find('\n', from) - from, hash);
    }
    if (text.size() > most) return size;
    std::memcpy(data, text.data(), text.size());
    return text.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        poinsot::Record record = poinsot::parse_record(text, "fuzz.png");
        const std::string written = poinsot::sealed_text(record);
        poinsot::Record again = poinsot::parse_record(written, "fuzz.png");
        require(again.sealed);
        require(poinsot::sealed_text(again) == written);
        poinsot::PngOptions options;
        options.deflate_level = 0;
        options.texts[poinsot::metadata_name] = written;
        poinsot::PngInfo info;
        poinsot::decode_png(poinsot::encode_png(poinsot::Image(1, 1), options), "fuzz.png", &info);
        require(poinsot::parse_record(info.texts[poinsot::metadata_name], "fuzz.png") == again);
    } catch (const poinsot::InputError& error) {
        require(std::string_view(error.what()).find('\n') == std::string_view::npos);
    }
    return 0;
}
