// Reading whole files, and the errors of unreadable ones.
#include "system/files/file_contents.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "error/error.h"
#include "system/faults.h"

namespace poinsot {
namespace {

// Sizes near a page, at which the buffer grows.
TEST(FileContents, AreReadCompletely) {
    const TemporaryFolder folder;
    for (const std::size_t size : {0, 1, 4095, 4096, 4097, 100'000}) {
        std::string text(size, 'x');
        for (std::size_t i = 0; i < size; ++i) text[i] = static_cast<char>(i * 7);
        std::ofstream(folder / "file", std::ios::binary) << text;
        EXPECT_EQ(read_text(folder / "file"), text);
        EXPECT_EQ(read_bytes(folder / "file"), std::vector<std::uint8_t>(text.begin(), text.end()));
    }
}

// Such a file reports size 0.
TEST(FileContents, AreReadFromAFileThatReportsNoSize) {
    EXPECT_NE(read_text("/proc/self/status").find("Pid:"), std::string::npos);
}

// The message of the error that reading throws, with the error's type.
std::string refusal_of(const std::filesystem::path& path) {
    try {
        read_text(path);
    } catch (const EnvironmentError& error) {
        return std::string("environment: ") + error.what();
    } catch (const InputError& error) {
        return std::string("input: ") + error.what();
    }
    return "read";
}

TEST(FileContents, AreRefusedWithTheReason) {
    const TemporaryFolder folder;
    const std::string gone = (folder / "gone").string(), here = folder.path().string();
    EXPECT_EQ(refusal_of(gone), "environment: cannot read " + gone + ": No such file or directory");
    EXPECT_EQ(refusal_of(here), "input: " + here + ": this is a folder");
    EXPECT_EQ(read_text_if_there(folder / "gone"), "");
    EXPECT_FALSE(begins_with(folder / "gone", "x"));
}

// Reading a pipe without a writer would block forever; then the alarm ends the test.
TEST(FileContents, OfAPipeOrADeviceAreNotWaitedFor) {
    const TemporaryFolder folder;
    const std::string pipe = (folder / "pipe").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    constexpr unsigned patience_s = 60;
    alarm(patience_s);
    for (const std::string& path : {pipe, std::string("/dev/zero"), std::string("/dev/null")})
        EXPECT_EQ(
            refusal_of(path),
            "input: " + path + ": a pipe or a device, not a regular file; name a file on the disk");
    EXPECT_FALSE(begins_with(pipe, "x"));
    EXPECT_THROW(read_text_if_there(pipe), InputError);
    alarm(0);
}

TEST(FileContents, AreReadFromTheirBeginningOnly) {
    const TemporaryFolder folder;
    const std::string text(10'000, 'x');
    std::ofstream(folder / "file", std::ios::binary) << text;
    for (const std::size_t n : {0, 1, 4096, 9999, 10'000, 20'000})
        EXPECT_EQ(read_beginning(folder / "file", n), text.substr(0, n));
    EXPECT_TRUE(begins_with(folder / "file", "xxx"));
    EXPECT_FALSE(begins_with(folder / "file", "xxy"));
}

}  // namespace
}  // namespace poinsot
