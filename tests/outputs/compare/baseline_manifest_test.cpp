// The manifest of baselines reads back as written; other text is refused.
#include "compare/baseline_manifest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "error/error.h"
#include "refusal.h"
#include "system/faults.h"

namespace poinsot {
namespace {

const BaselineManifest two_baselines = {
    {"turn", {"12ab", "34cd", "llvmpipe (LLVM 15.0.6, 128 bits)", "22.3.6", "0.1.0", "first"}},
    {"folder/a \"name\" = { }, # \\", {"", "", "a\nb", "\x1b[31m\x7f", "ω", "why = \"x\""}}};

std::string message_of(const std::string& text) {
    return refusal_message([&] { parse_manifest(text, "list.toml"); });
}

TEST(BaselineManifest, IsReadBackWithAnyNames) {
    EXPECT_EQ(parse_manifest(to_text(two_baselines), "list.toml"), two_baselines);
    EXPECT_TRUE(parse_manifest("", "list.toml").empty());
    EXPECT_TRUE(parse_manifest("# a comment\n\n", "list.toml").empty());
}

// One line per picture, sorted: a changed picture changes one line.
TEST(BaselineManifest, HasOneSortedLinePerPicture) {
    const std::string before = to_text(two_baselines);
    BaselineManifest changed = two_baselines;
    changed["turn"].why = "later";
    const std::string after = to_text(changed);
    EXPECT_EQ(std::count(before.begin(), before.end(), '\n'), 3);
    EXPECT_LT(before.find("\"folder/"), before.find("\"turn\""));
    EXPECT_EQ(before.substr(0, before.find("\"turn\"")), after.substr(0, after.find("\"turn\"")));
}

TEST(BaselineManifest, RefusesOtherLinesByNumber) {
    const std::string line = to_text({{"turn", two_baselines.at("turn")}});
    const std::string good = line.substr(line.find('\n') + 1);
    EXPECT_EQ(message_of(good + good).rfind("list.toml:2: an earlier line has this picture", 0),
              0u);
    // A truncated or extended line is invalid.
    for (std::size_t n = 1; n + 1 < good.size(); ++n)
        EXPECT_EQ(message_of("\n" + good.substr(0, n)).rfind("list.toml:2: not a line", 0), 0u)
            << good.substr(0, n);
    EXPECT_NE(message_of(good.substr(0, good.size() - 1) + " x\n"), "");
    EXPECT_NE(message_of("\"a\" = { pixels = \"\\u0100\" }\n"), "");
}

TEST(BaselineManifest, IsAFileNextToThePictures) {
    const TemporaryFolder folder;
    EXPECT_TRUE(read_manifest(folder.path()).empty());
    write_manifest(folder.path(), two_baselines);
    EXPECT_EQ(folder.contents(), std::vector<std::string>{manifest_name});
    EXPECT_EQ(read_manifest(folder.path()), two_baselines);
    std::ofstream(folder / manifest_name) << "nonsense\n";
    EXPECT_THROW(read_manifest(folder.path()), InputError);
}

}  // namespace
}  // namespace poinsot
