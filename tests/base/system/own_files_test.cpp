// What may be written over: what the user named, and what is proven; never an input.
#include "system/files/own_files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "refusal.h"
#include "system/files/file_contents.h"
#include "system/files/seen_from.h"
#include "system/seal.h"
#include "system/sha256.h"
#include "temporary_folder.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

class OwnFiles : public ::testing::Test {
 protected:
    OwnFiles() {
        write("own", sealed("ours " + std::string(blank_seal)));
        write("mine", "mine");
        write("edited", text_of("own") + "x");
        write("another", sealed("theirs " + std::string(blank_seal)));
        fs::create_symlink("own", folder_ / "link");
        fs::create_symlink("nothing", folder_ / "dangling");
        fs::create_directory(folder_ / "folder");
        EXPECT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    std::string text_of(const std::string& name) const { return read_text(folder_ / name); }
    std::string refusal(const WritePlace& place) const {
        return refusal_message([&] { check_replaceable(place); });
    }

    TemporaryFolder folder_;
};

TEST_F(OwnFiles, AreReplacedAndNoOthers) {
    const auto of = [&](const std::string& name) {
        return refusal({.path = folder_ / name, .is_own = sealed_with("ours"), .what = "the test"});
    };
    for (const char* name : {"own", "missing"}) EXPECT_EQ(of(name), "") << name;
    for (const char* name : {"mine", "edited", "another", "link", "dangling", "folder", "pipe"})
        EXPECT_EQ(of(name),
                  (folder_ / name).string() +
                      ": exists and is not as poinsot wrote it, and the test would replace "
                      "it; remove it, or name another output");
}

TEST_F(OwnFiles, ThatTheUserNamedAreReplacedUnlessTheyAreRead) {
    for (const char* name : {"own", "mine", "missing", "link", "dangling"})
        EXPECT_EQ(refusal({.path = folder_ / name, .inputs = {folder_ / "another"}}), "") << name;
    for (const char* name : {"own", "link", "folder/../own"})
        EXPECT_EQ(refusal({.path = folder_ / name, .inputs = {folder_ / "mine", folder_ / "own"}}),
                  (folder_ / name).string() +
                      ": is read for this output, so it cannot be replaced by it; name another "
                      "output");
}

TEST_F(OwnFiles, AreProvenByTheListBesideThem) {
    write("01.mp4", "film");
    write("list",
          with_files("{\n  \"a\": 1\n}\n", std::vector{FileHash{"01.mp4", sha256_of("film")}}));
    const FileList list(folder_ / "list");
    EXPECT_TRUE(list.proves(folder_ / "01.mp4"));
    EXPECT_FALSE(list.proves(folder_ / "mine"));
    write("01.mp4", "films");
    EXPECT_FALSE(list.proves(folder_ / "01.mp4"));
    EXPECT_TRUE(list.lists("01.mp4"));
    write("list", text_of("list") + "\n");
    EXPECT_EQ(FileList(folder_ / "list").text(), "");
    EXPECT_EQ(FileList(folder_ / "pipe").text(), "");
}

// Each file is on the list before it is written, so that a killed run has listed its own.
TEST_F(OwnFiles, AreProvenByALogThatIsWrittenFirst) {
    const auto log_of = [&] { return FileLog(folder_ / "folder", "log", "poinsot: test"); };
    FileLog log = log_of();
    log.begin();
    log.add("a", "first");
    write("folder/a", "first");
    EXPECT_TRUE(log_of().proves(folder_ / "folder/a"));
    log.add("a", "second");
    EXPECT_TRUE(log_of().proves(folder_ / "folder/a"));
    write("folder/a", "second");
    EXPECT_TRUE(log_of().proves(folder_ / "folder/a"));
    write("folder/a", "mine");
    EXPECT_FALSE(log_of().proves(folder_ / "folder/a"));
    write("folder/b", "first");
    EXPECT_FALSE(log_of().proves(folder_ / "folder/b"));
    // A last line that was cut off lists nothing, and the next run begins anew.
    write("folder/log", text_of("folder/log") + sha256_of("mine").substr(0, 40));
    FileLog next = log_of();
    EXPECT_FALSE(next.proves(folder_ / "folder/a"));
    write("folder/a", "second");
    next.begin();
    EXPECT_TRUE(log_of().proves(folder_ / "folder/a"));

    EXPECT_NE(refusal_message([&] { FileLog(folder_ / "mine", "log", "b"); }), "");
    EXPECT_NE(refusal_message([&] { FileLog(folder_ / "link", "log", "b"); }), "");
    write("folder/log", "mine");
    EXPECT_NE(refusal_message([&] { log_of(); }), "");
}

TEST_F(OwnFiles, AreSeenFromAFolder) {
    fs::create_directory_symlink("folder", folder_ / "short");
    EXPECT_EQ(seen_from(folder_ / "folder", folder_ / "mine"), "../mine");
    EXPECT_EQ(seen_from(folder_ / "short/", folder_ / "folder/new/a.toml"), "new/a.toml");
    EXPECT_EQ(seen_from(folder_.path(), folder_ / "short/a.toml"), "folder/a.toml");
}

}  // namespace
}  // namespace poinsot
