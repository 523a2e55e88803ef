// Texts that hold a SHA-256 of themselves, and lists of files with theirs: the proofs that a file
// is as poinsot wrote it. No file: a page has them, too.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// Stands where the hash of a text belongs.
inline constexpr std::string_view blank_seal =
    "0000000000000000000000000000000000000000000000000000000000000000";

// The text with the SHA-256 of all of it in place of its first blank_seal. Precondition: it has
// one.
std::string sealed(std::string text);

// Whether one of the first runs of 64 hexadecimal digits is the hash that sealed() writes there.
bool is_sealed(std::string_view text);

// A file and its SHA-256.
struct FileHash {
    std::string name, sha256;
    auto operator<=>(const FileHash&) const = default;
};

// A JSON object with more members, at its end: "files", which lists these, and "sha256", the seal.
// `object` has one member a line, as JsonObject::lines() writes it.
std::string with_files(std::string_view object, std::span<const FileHash> files);

// Such a text that lists these files, too: while files replace each other, both are listed.
// Precondition: it lists a file.
std::string with_more_files(std::string text, std::span<const FileHash> files);

// Whether such a text lists this file with this hash, and is sealed.
bool lists_file(std::string_view text, const FileHash& file);
// Whether it lists a file of this name.
bool lists_name(std::string_view text, std::string_view name);

}  // namespace poinsot
