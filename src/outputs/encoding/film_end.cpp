#include "encoding/film_end.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <span>
#include <string_view>

#include "encoding/film_packets.h"
#include "system/files/file_contents.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;
using Size = std::uintmax_t;

// Reads bytes at any offset of a file.
class Reader {
 public:
    explicit Reader(const fs::path& file) : stream_(file, std::ios::binary) {}

    // False if the file ends before.
    bool read(Size at, std::span<std::uint8_t> bytes) {
        stream_.clear();
        stream_.seekg(static_cast<std::streamoff>(at));
        stream_.read(reinterpret_cast<char*>(bytes.data()),
                     static_cast<std::streamsize>(bytes.size()));
        return static_cast<std::size_t>(stream_.gcount()) == bytes.size();
    }

 private:
    std::ifstream stream_;
};

Size number_of(std::span<const std::uint8_t> bytes) {
    Size number = 0;
    for (const std::uint8_t byte : bytes) number = number << 8 | byte;
    return number;
}

// A film is one sequence of boxes with one index; its media data has its own boxes, and the last of
// these ends the film. Another file type box, a second index and bytes that are not a top-level box
// lie behind the end. Source: ISO/IEC 14496-12 §4.2, §6.2.3; QuickTime's "wide".
std::optional<Size> end_of_boxes(Reader& reader) {
    constexpr std::array<std::string_view, 3> at_most_once{"ftyp", "moov", "mfra"};
    constexpr std::array<std::string_view, 3> what_is_played{"mdat", "moof", "moov"};
    constexpr std::array<std::string_view, 11> besides{
        "free", "skip", "wide", "uuid", "meta", "styp", "sidx", "ssix", "prft", "emsg", "pdin"};
    const auto is_in = [](const auto& list, std::string_view type) {
        return std::find(list.begin(), list.end(), type) != list.end();
    };
    std::array<bool, at_most_once.size()> seen{};
    bool has_data = false, has_fragments = false;
    Size end = 0, at = 0;
    for (std::array<std::uint8_t, 16> head{}; reader.read(at, std::span(head).first(8));) {
        const std::string_view type(reinterpret_cast<const char*>(head.data()) + 4, 4);
        Size size = number_of(std::span(head).first(4));
        const auto once = std::find(at_most_once.begin(), at_most_once.end(), type);
        if (once != at_most_once.end()) {
            bool& was_seen = seen.at(static_cast<std::size_t>(once - at_most_once.begin()));
            if (was_seen) break;
            was_seen = true;
        }
        has_fragments = has_fragments || type == "moof";
        // Only a fragmented film has its data in several boxes.
        if (type == "mdat" && has_data && !has_fragments) break;
        has_data = has_data || type == "mdat";
        const bool ends_film = once != at_most_once.end() || is_in(what_is_played, type);
        if (!ends_film && !is_in(besides, type)) break;
        if (size == 0) return std::nullopt;  // up to the end of the file
        Size least = 8;
        if (size == 1) {
            least = 16;
            if (!reader.read(at, head)) break;
            size = number_of(std::span(head).subspan(8));
        }
        if (size < least) break;
        at += size;
        if (ends_film) end = at;
    }
    return end;
}

// A number of variable length: the zeros before its first set bit give the number of bytes that
// follow. All bits set mean an unknown size. Source: RFC 8794 §4.
std::optional<Size> variable_number(Reader& reader, Size& at) {
    std::array<std::uint8_t, 8> bytes{};
    if (!reader.read(at, std::span(bytes).first(1)) || bytes[0] == 0) return std::nullopt;
    std::size_t n_bytes = 1;
    while ((bytes[0] & 0x80U >> (n_bytes - 1)) == 0) ++n_bytes;
    if (!reader.read(at, std::span(bytes).first(n_bytes))) return std::nullopt;
    at += n_bytes;
    const Size marker = Size{1} << 7 * n_bytes;
    const Size number = number_of(std::span(bytes).first(n_bytes)) & (marker - 1);
    if (number == marker - 1) return std::nullopt;
    return number;
}

// Matroska and WebM: a header, and one segment with everything else. Source: RFC 9559 §4.5.
std::optional<Size> end_of_segment(Reader& reader) {
    constexpr std::array<std::uint8_t, 4> segment{0x18, 0x53, 0x80, 0x67};
    Size at = 4;
    const auto header = variable_number(reader, at);
    if (!header) return std::nullopt;
    at += *header;
    std::array<std::uint8_t, 4> id{};
    if (!reader.read(at, id) || id != segment) return std::nullopt;
    at += id.size();
    const auto size = variable_number(reader, at);
    if (!size) return std::nullopt;
    return at + *size;
}

}  // namespace

std::optional<std::uintmax_t> end_of_film(const fs::path& film) {
    constexpr std::array<std::uint8_t, 4> matroska{0x1a, 0x45, 0xdf, 0xa3};
    Reader reader(film);
    std::array<std::uint8_t, 8> head{};
    if (!reader.read(0, head)) return std::nullopt;
    const std::string_view start(reinterpret_cast<const char*>(head.data()), head.size());
    if (start.starts_with("GIF")) return end_of_gif(read_bytes(film), film.string());
    if (std::equal(matroska.begin(), matroska.end(), head.begin())) return end_of_segment(reader);
    if (start.substr(4) == "ftyp") return end_of_boxes(reader);
    return std::nullopt;
}

}  // namespace poinsot
