// compare.toml: strict keys with their places, globs, and which limits apply.
#include "compare/compare_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "error/error.h"
#include "refusal.h"
#include "system/faults.h"

namespace poinsot {
namespace {

std::string message_for(const std::string& text) {
    return refusal_message([&] { parse_compare_file(text, "compare.toml"); });
}

TEST(CompareFile, LaterEntriesOverrideEarlierOnes) {
    const CompareFile file = parse_compare_file(R"(
max_flip = 0.02
ignore = ["clock"]
[[pictures]]
name = "top_*"
max_flip = 0.05
max_differing = "0.1%"
antialiasing = true
[[pictures]]
name = "top_fast"
max_flip = 0.1
min_ssim = 0.9
over_levels = 3
max_over = 0.25
ignore = ["0%,0%,100%,40"]
)",
                                                "compare.toml");
    EXPECT_EQ(file.given_limits_of("racket").max_flip, 0.02);
    EXPECT_FALSE(file.given_limits_of("racket").max_differing);
    EXPECT_EQ(file.given_limits_of("top_slow").max_flip, 0.05);
    EXPECT_EQ(file.given_limits_of("top_slow").max_differing, 0.001);
    EXPECT_EQ(file.given_limits_of("top_slow").antialiasing, true);
    const GivenLimits fast = file.given_limits_of("top_fast");
    EXPECT_EQ(fast.max_flip, 0.1);
    EXPECT_EQ(fast.min_ssim, 0.9);
    EXPECT_EQ(fast.over_levels, 3);
    EXPECT_EQ(fast.max_over, 0.25);
    EXPECT_EQ(fast.max_differing, 0.001);
    ASSERT_EQ(fast.ignore.size(), 2u);
    EXPECT_EQ(fast.ignore[0].in(1280, 720), (PictureRegion{0, 0, 1280, 40}));
    EXPECT_EQ(fast.ignore[1].text, "clock");
    // The command line is above the file.
    EXPECT_EQ((GivenLimits{.max_flip = 0.5}.over(fast).max_flip), 0.5);
}

TEST(CompareFile, IsNotCalledASceneWhereItIsNoText) {
    EXPECT_EQ(message_for("# \xff\n"),
              "compare.toml:1:3: byte 0xff is not UTF-8; save this text as UTF-8");
}

TEST(CompareFile, RefusesWithThePlace) {
    for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
             {"max_flp = 1",
              "compare.toml:1:1: unknown key \"max_flp\"; did you mean \"max_flip\"?"},
             {"max_flip = 2", "compare.toml:1:12: max_flip: 2: not a FLIP value"},
             {"max_flip = nan", "compare.toml:1:12: max_flip: nan: not a FLIP value"},
             {"max_flip = \"0.1\"", "compare.toml:1:12: max_flip is a string; it must be"},
             {"min_ssim = 1.5", "compare.toml:1:12: min_ssim: 1.5: not an SSIM value"},
             {"over_levels = 2.5", "compare.toml:1:15: over_levels: 2.5: not a level"},
             {"max_differing = \"150%\"", "compare.toml:1:17: max_differing: 150%: not a share"},
             {"max_over = true", "compare.toml:1:12: max_over is a boolean; it must be"},
             {"antialiasing = 1", "compare.toml:1:16: antialiasing is an integer; it must be true"},
             {"ignore = \"clock\"", "compare.toml:1:10: ignore is a string; it must be a list"},
             {"ignore = [1]", "compare.toml:1:10: ignore is"},
             {"ignore = [\"clok\"]",
              "compare.toml:1:11: unknown region \"clok\"; did you mean \"clock\"?"},
             {"ignore = [\"1,2,3\"]", "compare.toml:1:11: 1,2,3: not a rectangle"},
             {"ignore = [\"1,2,3,0\"]", "compare.toml:1:11: 1,2,3,0: not a rectangle"},
             {"[pictures]\nname = \"a\"", "compare.toml:1:"},
             {"pictures = [1]", "compare.toml:1:13: an entry of pictures must be a table"},
             {"[[pictures]]\nmax_flip = 0.1", "compare.toml:1:1: this entry has no name"},
             {"[[pictures]]\nname = \"a\"", "compare.toml:2:8: this entry sets no limit"},
             {"[[pictures]]\nname = 3\nmax_flip = 1", "compare.toml:2:8: name must be"},
             {"[[pictures]]\nname = \"a\"\nmax_flop = 1",
              "compare.toml:3:1: unknown key \"max_flop\""},
             {"max_flip = ", "compare.toml:1:"}}) {
        EXPECT_EQ(message_for(text).find(message), 0u) << text << "\n" << message_for(text);
        EXPECT_EQ(message_for(text).find('\n'), std::string::npos);
    }
}

TEST(CompareFile, IsReadFromTheFolderOfBaselines) {
    const TemporaryFolder folder;
    EXPECT_FALSE(read_compare_file(folder.path()));
    std::ofstream(folder / compare_file_name) << "max_flip = 0.5\n";
    EXPECT_EQ(read_compare_file(folder.path())->all.max_flip, 0.5);
    std::filesystem::remove(folder / compare_file_name);
    std::filesystem::create_directory(folder / compare_file_name);
    EXPECT_THROW(read_compare_file(folder.path()), InputError);
}

// The definition, by recursion.
bool matches(std::string_view name, std::string_view glob) {
    if (glob.empty()) return name.empty();
    if (glob[0] == '*')
        return matches(name, glob.substr(1)) || (!name.empty() && matches(name.substr(1), glob));
    return !name.empty() && (glob[0] == '?' || glob[0] == name[0]) &&
           matches(name.substr(1), glob.substr(1));
}

TEST(Glob, AgreesWithItsDefinition) {
    std::mt19937 random(7);
    int n_matches = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto text = [&random](std::string_view letters, unsigned most) {
            std::string made;
            for (unsigned n = random() % (most + 1); n > 0; --n)
                made += letters[random() % letters.size()];
            return made;
        };
        const std::string name = text("ab", 8), glob = text("ab**?", 6);
        EXPECT_EQ(matches_glob(name, glob), matches(name, glob)) << name << " " << glob;
        n_matches += matches_glob(name, glob);
    }
    EXPECT_GT(n_matches, 1000);
    EXPECT_TRUE(matches_glob("sub/turn_0001", "sub/*"));
}

}  // namespace
}  // namespace poinsot
