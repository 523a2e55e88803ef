// Kinds of files.
#include "system/files/file_kind.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace poinsot {
namespace {

namespace fs = std::filesystem;

TEST(FileKind, DistinguishesRegularFiles) {
    std::string name = (fs::temp_directory_path() / "poinsot-test-XXXXXX").string();
    const fs::path folder = mkdtemp(name.data());
    std::ofstream(folder / "file") << "x";
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    fs::create_symlink("file", folder / "link");
    fs::create_symlink("circle", folder / "circle");
    fs::create_symlink("gone", folder / "dangling");

    EXPECT_EQ(kind_of_file(folder / "file"), FileKind::regular);
    EXPECT_EQ(kind_of_file(folder / "link"), FileKind::regular);
    EXPECT_EQ(kind_of_file(folder), FileKind::folder);
    EXPECT_EQ(kind_of_file(folder / "nothing"), FileKind::missing);
    EXPECT_EQ(kind_of_file(folder / "dangling"), FileKind::missing);
    EXPECT_EQ(kind_of_file(folder / "file" / "below"), FileKind::missing);
    EXPECT_EQ(kind_of_file(folder / "circle"), FileKind::link_circle);
    EXPECT_EQ(kind_of_file(folder / "pipe"), FileKind::special);
    EXPECT_EQ(kind_of_file("/dev/null"), FileKind::special);
    EXPECT_EQ(kind_of_file(""), FileKind::missing);
    fs::remove_all(folder);
}

}  // namespace
}  // namespace poinsot
