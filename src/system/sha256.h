// SHA-256, by which pictures, scenes and baselines are named in records.
// Source: NIST FIPS 180-4, Secure Hash Standard, §4.1.2, §5 and §6.2.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace poinsot {

// A message given in parts.
class Sha256 {
 public:
    void add(std::span<const std::uint8_t> bytes);
    void add(std::string_view text);

    // 64 hexadecimal digits, of all that was added; afterwards the object is used up.
    std::string finish();

 private:
    void take_block(const std::uint8_t* block);

    std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    std::array<std::uint8_t, 64> waiting_{};
    std::uint64_t n_bytes_ = 0;
};

// Of a text's bytes.
std::string sha256_of(std::string_view text);

}  // namespace poinsot
