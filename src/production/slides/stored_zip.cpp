#include "production/slides/stored_zip.h"

#include <fmt/format.h>

#include <fstream>
#include <limits>
#include <span>

#include "error/error.h"
#include "image/crc32.h"
#include "system/files/file_contents.h"
#include "text/printable.h"

namespace poinsot {

namespace {

constexpr std::uint32_t entry_mark = 0x04034b50, directory_mark = 0x02014b50, end_mark = 0x06054b50;
constexpr std::size_t end_bytes = 22;  // without the comment
constexpr std::uint16_t comment_bytes = 16;
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
    constexpr std::size_t entry_bytes = 30, row_bytes = 46;
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
    constexpr std::uint16_t first_disk = 0;
    const auto at = static_cast<std::uint32_t>(n_written_);
    const auto n_bytes = static_cast<std::uint32_t>(directory_.size());
    const auto n_entries = static_cast<std::uint16_t>(n_entries_);
    write(directory_);
    write(little_endian(end_mark) + little_endian(first_disk) + little_endian(first_disk) +
          little_endian(n_entries) + little_endian(n_entries) + little_endian(n_bytes) +
          little_endian(at) + little_endian(comment_bytes) + comment_of(directory_));
}

bool StoredZip::is_unchanged(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string end(end_bytes + comment_bytes, '\0');
    stream.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
    const std::uint64_t n_before_end = static_cast<std::uint64_t>(stream.tellg());
    stream.read(end.data(), static_cast<std::streamsize>(end.size()));
    if (!stream || !end.starts_with(little_endian(end_mark))) return false;
    constexpr std::size_t size_at = 12, place_at = 16;
    const std::uint64_t n_bytes = number_at(end, size_at), place = number_at(end, place_at);
    if (place + n_bytes != n_before_end) return false;
    std::string directory(n_bytes, '\0');
    stream.seekg(static_cast<std::streamoff>(place));
    stream.read(directory.data(), static_cast<std::streamsize>(directory.size()));
    return stream && end.substr(end_bytes) == comment_of(directory);
}

}  // namespace poinsot
