// A still is written on another thread, or without one.
#include "production/stills/still_writer.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "image/files/png_files.h"

namespace poinsot {
namespace {

// In a process of its own: 7 if a picture is written although no thread's stack can be mapped.
int without_threads(const std::filesystem::path& path) {
    Image picture(64, 36);
    std::fill(picture.bytes().begin(), picture.bytes().end(), 0x80);
    const Image expected = picture;
    std::ifstream file("/proc/self/statm");
    rlim_t n_pages = 0;
    file >> n_pages;
    const rlim_t bytes = n_pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (4 << 20);
    const rlimit limit{bytes, RLIM_INFINITY};
    if (setrlimit(RLIMIT_AS, &limit) != 0) return 1;
    StillWriter writer;
    bool written = false;
    writer.write(OutputPlace(path.string(), Scene{}, ".png"), std::move(picture), PngOptions{},
                 [&written] { written = true; });
    writer.finish();
    const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
    setrlimit(RLIMIT_AS, &none);
    const Image found = read_png(path);
    return written && std::ranges::equal(found.bytes(), expected.bytes()) ? 7 : 2;
}

TEST(StillWriter, WritesTheSameWithoutAThread) {
    const std::filesystem::path path = std::filesystem::temp_directory_path() /
                                       ("poinsot_still_" + std::to_string(getpid()) + ".png");
    EXPECT_EXIT(std::_Exit(without_threads(path)), ::testing::ExitedWithCode(7), "");
    std::filesystem::remove(path);
}

}  // namespace
}  // namespace poinsot
