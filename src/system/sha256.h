// SHA-256, by which pictures, scenes and baselines are named in records: libmd's.
#pragma once

#include <sha2.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// A message given in parts.
class Sha256 {
 public:
    Sha256();
    void add(std::span<const std::uint8_t> bytes);
    void add(std::string_view text);

    // 64 hexadecimal digits, of all that was added; afterwards the object is used up.
    std::string finish();

 private:
    SHA2_CTX state_;
};

// Of a text's bytes.
std::string sha256_of(std::string_view text);

}  // namespace poinsot
