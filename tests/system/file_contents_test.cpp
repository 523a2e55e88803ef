// Whole files, and what is said where they cannot be read.
#include "system/file_contents.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "error/error.h"
#include "system/faults.h"

namespace poinsot {
namespace {

// Sizes about those of a page, at which room is made.
TEST(FileContents, AreRead) {
    const TemporaryFolder folder;
    for (const std::size_t size : {0, 1, 4095, 4096, 4097, 100'000}) {
        std::string text(size, 'x');
        for (std::size_t i = 0; i < size; ++i) text[i] = static_cast<char>(i * 7);
        std::ofstream(folder / "file", std::ios::binary) << text;
        EXPECT_EQ(read_text(folder / "file"), text);
        EXPECT_EQ(read_bytes(folder / "file"), std::vector<std::uint8_t>(text.begin(), text.end()));
    }
}

// Such a file says that its size is 0.
TEST(FileContents, AreReadOfAFileWithoutASize) {
    EXPECT_NE(read_text("/proc/self/status").find("Pid:"), std::string::npos);
}

TEST(FileContents, AreRefusedWithTheReason) {
    const TemporaryFolder folder;
    const auto said = [](const std::filesystem::path& path) -> std::string {
        try {
            read_text(path);
        } catch (const EnvironmentError& error) {
            return error.what();
        }
        return "read";
    };
    EXPECT_EQ(said(folder / "gone"),
              "cannot read " + (folder / "gone").string() + ": No such file or directory");
    EXPECT_EQ(said(folder.path()), "cannot read " + folder.path().string() + ": Is a directory");
    EXPECT_EQ(read_text_if_there(folder / "gone"), "");
}

}  // namespace
}  // namespace poinsot
