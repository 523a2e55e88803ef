// SHA-256 in a page, which has no libmd. Source: FIPS 180-4, §5.1.1, §5.3.3 and §6.2.2.
#include <sha2.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace poinsot {
namespace {

// The first 32 bits of the fractional parts of the cube roots of the first 64 primes.
constexpr std::array<std::uint32_t, 64> round_constants{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

void add_block(std::uint32_t* state, const std::uint8_t* block) {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < 16; ++i)
        for (std::size_t k = 0; k < 4; ++k) w[i] = w[i] << 8 | block[4 * i + k];
    for (std::size_t i = 16; i < 64; ++i) {
        const std::uint32_t a = w[i - 15], b = w[i - 2];
        w[i] = w[i - 16] + w[i - 7] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ a >> 3) +
               (std::rotr(b, 17) ^ std::rotr(b, 19) ^ b >> 10);
    }
    std::array<std::uint32_t, 8> s{};
    for (std::size_t i = 0; i < 8; ++i) s[i] = state[i];
    for (std::size_t i = 0; i < 64; ++i) {
        const std::uint32_t e = s[4], a = s[0];
        const std::uint32_t one = s[7] + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) +
                                  ((e & s[5]) ^ (~e & s[6])) + round_constants[i] + w[i];
        const std::uint32_t two = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) +
                                  ((a & s[1]) ^ (a & s[2]) ^ (s[1] & s[2]));
        for (std::size_t k = 7; k > 0; --k) s[k] = s[k - 1];
        s[4] += one;
        s[0] = one + two;
    }
    for (std::size_t i = 0; i < 8; ++i) state[i] += s[i];
}

}  // namespace
}  // namespace poinsot

extern "C" {

void SHA256Init(SHA2_CTX* context) {
    // Of the square roots of the first eight primes.
    constexpr std::array<std::uint32_t, 8> start{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                                 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    for (std::size_t i = 0; i < 8; ++i) context->state.st32[i] = start[i];
    context->bitcount[0] = 0;
}

void SHA256Update(SHA2_CTX* context, const std::uint8_t* bytes, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t at = context->bitcount[0] / 8 % 64;
        context->buffer[at] = bytes[i];
        context->bitcount[0] += 8;
        if (at == 63) poinsot::add_block(context->state.st32, context->buffer);
    }
}

char* SHA256End(SHA2_CTX* context, char* digits) {
    const std::uint64_t n_bits = context->bitcount[0];
    const std::uint8_t one = 0x80, zero = 0;
    SHA256Update(context, &one, 1);
    while (context->bitcount[0] / 8 % 64 != 56) SHA256Update(context, &zero, 1);
    for (int shift = 56; shift >= 0; shift -= 8) {
        const auto byte = static_cast<std::uint8_t>(n_bits >> shift);
        SHA256Update(context, &byte, 1);
    }
    for (std::size_t i = 0; i < 64; ++i)
        digits[i] = "0123456789abcdef"[context->state.st32[i / 8] >> (28 - 4 * (i % 8)) & 15];
    digits[64] = '\0';
    return digits;
}
}
