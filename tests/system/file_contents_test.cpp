// Whole files, and what is said where they cannot be read.
#include "system/file_contents.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "error/error.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

class FileContents : public testing::Test {
 protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "poinsot-test-XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path folder_;
};

// Sizes about those of a page, at which room is made.
TEST_F(FileContents, AreRead) {
    for (const std::size_t size : {0, 1, 4095, 4096, 4097, 100'000}) {
        std::string text(size, 'x');
        for (std::size_t i = 0; i < size; ++i) text[i] = static_cast<char>(i * 7);
        std::ofstream(folder_ / "file", std::ios::binary) << text;
        EXPECT_EQ(read_text(folder_ / "file"), text);
        EXPECT_EQ(read_bytes(folder_ / "file"),
                  std::vector<std::uint8_t>(text.begin(), text.end()));
    }
}

// Such a file says that its size is 0.
TEST_F(FileContents, AreReadOfAFileWithoutASize) {
    EXPECT_NE(read_text("/proc/self/status").find("Pid:"), std::string::npos);
}

TEST_F(FileContents, AreRefusedWithTheReason) {
    const auto said = [](const fs::path& path) -> std::string {
        try {
            read_text(path);
        } catch (const EnvironmentError& error) {
            return error.what();
        }
        return "read";
    };
    EXPECT_EQ(said(folder_ / "gone"),
              "cannot read " + (folder_ / "gone").string() + ": No such file or directory");
    EXPECT_EQ(said(folder_), "cannot read " + folder_.string() + ": Is a directory");
    EXPECT_EQ(read_text_if_there(folder_ / "gone"), "");
}

}  // namespace
}  // namespace poinsot
