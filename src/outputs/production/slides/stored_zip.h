// ZIP files whose entries are stored without compression, for parts that are compressed already.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
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

    // The contents of an entry of an archive in which every byte is as finish() left it; nothing
    // for any other file. Reads the whole file.
    static std::optional<std::string> unchanged_entry(const std::filesystem::path& file,
                                                      std::string_view name);

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
