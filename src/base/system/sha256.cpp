#include "system/sha256.h"

#include <array>

namespace poinsot {

Sha256::Sha256() : state_{} { SHA256Init(&state_); }

void Sha256::add(std::span<const std::uint8_t> bytes) {
    SHA256Update(&state_, bytes.data(), bytes.size());
}

void Sha256::add(std::string_view text) {
    add({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

std::string Sha256::finish() {
    std::array<char, SHA256_DIGEST_STRING_LENGTH> digits{};
    SHA256End(&state_, digits.data());
    return digits.data();
}

std::string sha256_of(std::string_view text) {
    Sha256 hash;
    hash.add(text);
    return hash.finish();
}

}  // namespace poinsot
