// SHA-256 (by libmd), which identifies pictures, scenes and baselines in records.
#pragma once

#include <sha2.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// The hash of a message given in parts.
class Sha256 {
 public:
    Sha256();
    void add(std::span<const std::uint8_t> bytes);
    void add(std::string_view text);

    // Returns 64 hexadecimal digits. The object must not be used afterwards.
    std::string finish();

 private:
    SHA2_CTX state_;
};

// The hash of a text's bytes.
std::string sha256_of(std::string_view text);

}  // namespace poinsot
