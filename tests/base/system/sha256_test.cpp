// SHA-256 against the standard's examples and the known answers of NIST's validation programme.
#include "system/sha256.h"

#include <gtest/gtest.h>

#include <string>

namespace poinsot {
namespace {

// FIPS 180-4's example messages (NIST, Examples with Intermediate Values) and the empty message of
// the CAVP short-message set.
TEST(Sha256, AgreesWithTheStandardsExamples) {
    EXPECT_EQ(sha256_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256_of(std::string(1000000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// Lengths near the block size of 64 bytes, and near 56, from which padding needs a second block.
TEST(Sha256, PartsHashLikeTheWhole) {
    for (std::size_t length = 0; length <= 130; ++length) {
        const std::string text(length, 'x');
        const std::string whole = sha256_of(text);
        for (const std::size_t part : {1u, 7u, 63u, 64u, 65u}) {
            Sha256 hash;
            for (std::size_t at = 0; at < length; at += part)
                hash.add(std::string_view(text).substr(at, part));
            EXPECT_EQ(hash.finish(), whole) << length << " in parts of " << part;
        }
    }
}

}  // namespace
}  // namespace poinsot
