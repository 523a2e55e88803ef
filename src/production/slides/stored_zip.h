// ZIP files whose entries are stored without compression, for parts that are compressed already.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "system/files/atomic_file.h"

namespace poinsot {

// Writes the entries in the order in which they are added; the same entries give the same bytes.
// Source: PKWARE, APPNOTE.TXT 6.3.10, without ZIP64. add() and add_file() throw InputError for
// more than 4 GB or 65535 entries; all throw EnvironmentError.
class StoredZip {
 public:
    explicit StoredZip(AtomicFile& file) : file_(&file) {}

    void add(const std::string& name, std::string_view contents);
    void add_file(const std::string& name, const std::filesystem::path& file);

    // Writes the directory, with a checksum of it as the archive's comment; the caller commits the
    // file.
    void finish();

    // Whether a file is an archive as finish() left it: its directory, which has the checksum of
    // every entry, has not changed.
    static bool is_unchanged(const std::filesystem::path& file);

 private:
    void begin(const std::string& name, std::uint32_t crc, std::uint64_t n_bytes);
    void write(std::string_view bytes);
    void check_size(std::uint64_t n_bytes) const;

    AtomicFile* file_;
    std::string directory_;
    std::uint64_t n_written_ = 0;
    std::size_t n_entries_ = 0;
};

}  // namespace poinsot
