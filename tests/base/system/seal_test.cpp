// A sealed text is its own proof: no other text passes, and lists tell their files from others.
#include "system/seal.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "system/sha256.h"

namespace poinsot {
namespace {

TEST(Seal, IsTheHashOfTheTextWithoutIt) {
    const std::string text = "before " + std::string(64, '0') + " after\n";
    const std::string whole = sealed(text);
    EXPECT_EQ(whole, "before " + sha256_of(text) + " after\n");
    EXPECT_TRUE(is_sealed(whole));
    EXPECT_FALSE(is_sealed(text));
    EXPECT_FALSE(is_sealed(""));
}

TEST(Seal, IsBrokenByEveryChangedByte) {
    const std::string whole = sealed("name\n" + std::string(blank_seal) + "\nrows\n");
    for (std::size_t i = 0; i < whole.size(); ++i)
        for (int bit = 0; bit < 8; ++bit) {
            std::string changed = whole;
            changed[i] = static_cast<char>(changed[i] ^ (1 << bit));
            EXPECT_FALSE(is_sealed(changed)) << i << " " << bit;
        }
    EXPECT_FALSE(is_sealed(whole + "x"));
    EXPECT_FALSE(is_sealed("x" + whole));
    EXPECT_FALSE(is_sealed(whole.substr(0, whole.size() - 1)));
}

// A name or another hash may look like the seal.
TEST(Seal, IsFoundBehindOtherHashes) {
    const std::string other = sha256_of("x");
    EXPECT_TRUE(is_sealed(sealed(other + " " + other + " " + std::string(blank_seal))));
    EXPECT_FALSE(is_sealed(other + " " + other));
}

TEST(Seal, ListsTellTheirFilesFromOthers) {
    const FileHash a{"a.mp4", sha256_of("a")}, odd{"b \"\n.mp4", sha256_of("b")};
    const std::string object = "{\n  \"title\": \"T\"\n}\n";
    const std::string list = with_files(object, std::vector{a, odd});
    EXPECT_TRUE(is_sealed(list));
    EXPECT_TRUE(list.starts_with("{\n  \"title\": \"T\",\n  \"sha256\": \"")) << list;
    EXPECT_TRUE(lists_file(list, a));
    EXPECT_TRUE(lists_file(list, odd));
    EXPECT_FALSE(lists_file(list, {"a.mp4", odd.sha256}));
    EXPECT_FALSE(lists_file(list, {"a", a.sha256}));
    EXPECT_TRUE(lists_name(list, "a.mp4"));
    EXPECT_FALSE(lists_name(list, "a"));
    EXPECT_TRUE(is_sealed(with_files(object, {})));

    const FileHash newer{"a.mp4", sha256_of("newer")};
    const std::string both = with_more_files(list, std::vector{newer});
    EXPECT_TRUE(lists_file(both, a));
    EXPECT_TRUE(lists_file(both, newer));
    EXPECT_FALSE(lists_file(list, newer));
    // A list that somebody wrote proves nothing.
    std::string edited = list;
    edited.replace(edited.find(a.sha256), a.sha256.size(), newer.sha256);
    EXPECT_FALSE(lists_file(edited, newer));
}

}  // namespace
}  // namespace poinsot
