#include "production/slides/stored_zip.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <span>
#include <utility>

#include "error/error.h"
#include "image/crc32.h"
#include "system/files/file_contents.h"
#include "text/printable.h"

namespace poinsot {

namespace {

constexpr std::uint32_t entry_mark = 0x04034b50, directory_mark = 0x02014b50, end_mark = 0x06054b50;
constexpr std::size_t end_bytes = 22;  // without the comment
constexpr std::uint16_t comment_bytes = 16;
constexpr std::size_t entry_bytes = 30, row_bytes = 46;  // without names
// Fields of a row of the directory, and of the archive's end.
constexpr std::size_t row_fields_at = 6, row_crc_at = 16, row_size_at = 20, row_name_size_at = 28,
                      row_place_at = 42, end_size_at = 12, end_place_at = 16;
constexpr std::uint16_t version = 20;  // 2.0
// Midnight on 1980-01-01, the first date of the format.
constexpr std::uint16_t entry_time = 0, entry_date = 0x21;

template <class Integer>
std::string little_endian(Integer value) {
    std::string bytes;
    for (std::size_t i = 0; i < sizeof(Integer); ++i)
        bytes += static_cast<char>((value >> (8 * i)) & 0xff);
    return bytes;
}

std::uint32_t crc_after(std::uint32_t crc, std::string_view bytes) {
    return crc32_after(crc, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

// The archive's comment: a checksum of its directory.
std::string comment_of(std::string_view directory) {
    return fmt::format("poinsot {:08x}", crc_after(0, directory));
}

// A number of four bytes. Precondition: they exist.
std::uint32_t number_at(std::string_view bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i)
        number |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])} << (8 * i);
    return number;
}

// The archive's end, after its directory, which begins at `at`.
std::string end_of(std::string_view directory, std::uint64_t n_entries, std::uint64_t at) {
    constexpr std::uint16_t first_disk = 0;
    const auto count = static_cast<std::uint16_t>(n_entries);
    return little_endian(end_mark) + little_endian(first_disk) + little_endian(first_disk) +
           little_endian(count) + little_endian(count) +
           little_endian(static_cast<std::uint32_t>(directory.size())) +
           little_endian(static_cast<std::uint32_t>(at)) + little_endian(comment_bytes) +
           comment_of(directory);
}

// The fields which an entry and its row in the directory share.
std::string shared_fields(const std::string& name, std::uint32_t crc, std::uint32_t n_bytes) {
    constexpr std::uint16_t none = 0;
    return little_endian(version) + little_endian(none) + little_endian(none) +
           little_endian(entry_time) + little_endian(entry_date) + little_endian(crc) +
           little_endian(n_bytes) + little_endian(n_bytes) +
           little_endian(static_cast<std::uint16_t>(name.size())) + little_endian(none);
}

}  // namespace

void StoredZip::write(std::string_view bytes) {
    file_->write({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    n_written_ += bytes.size();
}

void StoredZip::check_size(std::uint64_t n_bytes) const {
    if (n_written_ + n_bytes > std::numeric_limits<std::uint32_t>::max() ||
        n_entries_ >= std::numeric_limits<std::uint16_t>::max())
        throw InputError(
            fmt::format("{}: its films are too large for a presentation, which holds at most 4 GB "
                        "and 65535 files; make them smaller with --size, or use --slides",
                        printable(file_->path().string())));
}

void StoredZip::begin(const std::string& name, std::uint32_t crc, std::uint64_t n_bytes) {
    check_size(n_bytes + directory_.size() + entry_bytes + row_bytes + 2 * name.size() + end_bytes +
               comment_bytes);
    const auto at = static_cast<std::uint32_t>(n_written_);
    const std::string fields = shared_fields(name, crc, static_cast<std::uint32_t>(n_bytes));
    // No comment, first disk, no attributes.
    directory_ += little_endian(directory_mark) + little_endian(version) + fields +
                  std::string(10, '\0') + little_endian(at) + name;
    ++n_entries_;
    write(little_endian(entry_mark) + fields + name);
}

void StoredZip::add(const std::string& name, std::string_view contents) {
    begin(name, crc_after(0, contents), contents.size());
    write(contents);
}

void StoredZip::add_file(const std::string& name, const std::filesystem::path& file) {
    // Twice, as the sum comes before the contents: a film need not fit into memory.
    std::uint32_t crc = 0;
    std::uint64_t n_bytes = 0;
    read_pieces(file, [&](std::string_view piece) {
        crc = crc_after(crc, piece);
        n_bytes += piece.size();
    });
    begin(name, crc, n_bytes);
    read_pieces(file, [&](std::string_view piece) { write(piece); });
}

void StoredZip::finish() {
    const std::uint64_t at = n_written_;
    write(directory_);
    write(end_of(directory_, n_entries_, at));
}

std::optional<std::string> StoredZip::unchanged_entry(const std::filesystem::path& file,
                                                      std::string_view name) {
    std::ifstream stream(file, std::ios::binary);
    const auto read = [&stream](std::uint64_t n_bytes) {
        std::string bytes(n_bytes, '\0');
        stream.read(bytes.data(), static_cast<std::streamsize>(n_bytes));
        return bytes;
    };
    stream.seekg(-static_cast<std::streamoff>(end_bytes + comment_bytes), std::ios::end);
    const auto n_before_end = static_cast<std::uint64_t>(stream.tellg());
    const std::string end = read(end_bytes + comment_bytes);
    if (!stream || !end.starts_with(little_endian(end_mark))) return std::nullopt;
    const std::uint64_t n_bytes = number_at(end, end_size_at), place = number_at(end, end_place_at);
    if (place + n_bytes != n_before_end) return std::nullopt;
    stream.seekg(static_cast<std::streamoff>(place));
    const std::string directory = read(n_bytes);
    if (!stream || end.substr(end_bytes) != comment_of(directory)) return std::nullopt;

    // The directory is right, so its rows are as begin() made them. The entries follow each other
    // from the first byte on.
    std::optional<std::string> found;
    std::uint64_t n_entries = 0;
    stream.seekg(0);
    for (std::string_view rest = directory; !rest.empty(); ++n_entries) {
        if (rest.size() < row_bytes) return std::nullopt;
        const std::size_t n_name = number_at(rest, row_name_size_at) & 0xffff;
        const std::string_view row = rest.substr(0, row_bytes + n_name);
        rest.remove_prefix(row.size());
        const std::string_view fields = row.substr(row_fields_at, entry_bytes - 4);
        const std::string front =
            little_endian(entry_mark) + std::string(fields) + std::string(row.substr(row_bytes));
        if (number_at(row, row_place_at) != static_cast<std::uint64_t>(stream.tellg()) ||
            read(front.size()) != front)
            return std::nullopt;
        const bool is_wanted = row.substr(row_bytes) == name;
        std::string contents;
        std::uint32_t crc = 0;
        for (std::uint64_t left = number_at(row, row_size_at); left > 0 && stream;) {
            const std::string piece = read(std::min<std::uint64_t>(left, 1 << 20));
            crc = crc_after(crc, piece);
            left -= piece.size();
            if (is_wanted) contents += piece;
        }
        if (!stream || crc != number_at(row, row_crc_at)) return std::nullopt;
        if (is_wanted) found = std::move(contents);
    }
    if (static_cast<std::uint64_t>(stream.tellg()) != place ||
        end != end_of(directory, n_entries, place))
        return std::nullopt;
    return found;
}

}  // namespace poinsot
