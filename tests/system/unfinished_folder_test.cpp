// The hidden folders of unfinished work are poinsot's own, or they stay as they are.
#include "system/files/unfinished_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <functional>

#include "system/faults.h"
#include "system/files/atomic_file.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

class Unfinished : public ::testing::Test {
 protected:
    Unfinished() {
        fs::create_directories(folder_ / "victim/deep");
        std::ofstream(folder_ / "victim/precious") << "mine";
        std::ofstream(folder_ / "victim/deep/file") << "mine";
    }

    UnfinishedFolder open() const { return {folder_ / "a.mp4", aside_, marker_}; }
    void make() const { write_whole(open().marker_path(), "ours, of a.mp4"); }

    void expect_refusal() const {
        for (const auto& attempt :
             {std::function<void()>([this] { open(); }), std::function<void()>([this] {
                  UnfinishedFolder::left(folder_ / "a.mp4", aside_, marker_);
              })}) {
            std::string message;
            try {
                attempt();
            } catch (const EnvironmentError& error) {
                message = error.what();
            }
            EXPECT_EQ(message, "cannot write " + (folder_ / "a.mp4").string() +
                                   ": its temporary folder " + aside_.string() +
                                   " exists and is not unfinished work of poinsot; remove it, or "
                                   "name another output");
        }
        EXPECT_TRUE(fs::exists(folder_ / "victim/precious"));
        EXPECT_TRUE(fs::exists(folder_ / "victim/deep/file"));
    }

    TemporaryFolder folder_;
    const fs::path aside_ = folder_ / ".a.mp4.parts";
    const FolderMarker marker_{"marker", "ours"};
};

TEST_F(Unfinished, FoldersAreMadeAndFoundAgain) {
    EXPECT_FALSE(UnfinishedFolder::left(folder_ / "a.mp4", aside_, marker_).has_value());
    EXPECT_FALSE(fs::exists(aside_));
    EXPECT_FALSE(open().has_marker());
    // A run that was killed before or while it wrote the marker.
    EXPECT_FALSE(open().has_marker());
    std::ofstream(aside_ / ".marker.part") << "ou";
    EXPECT_FALSE(open().has_marker());
    fs::remove(aside_ / ".marker.part");

    make();
    std::ofstream(aside_ / "b") << "b";
    fs::create_directory(aside_ / "c");
    const UnfinishedFolder again = open();
    EXPECT_TRUE(again.has_marker());
    EXPECT_EQ(again.names(), (std::vector<std::string>{"b", "c"}));
    again.remove("b");
    again.remove_if_empty();
    EXPECT_EQ(again.names(), std::vector<std::string>{"c"});
    again.remove("c");
    again.remove_if_empty();
    EXPECT_FALSE(fs::exists(aside_));
}

TEST_F(Unfinished, FoldersOfOthersStay) {
    fs::create_symlink("victim", aside_);
    expect_refusal();
    fs::remove(aside_);
    fs::create_symlink("nowhere", aside_);
    expect_refusal();
    fs::remove(aside_);
    std::ofstream(aside_) << "mine";
    expect_refusal();
    fs::remove(aside_);
    ASSERT_EQ(mkfifo(aside_.c_str(), 0600), 0);
    expect_refusal();
    fs::remove(aside_);
    fs::copy(folder_ / "victim", aside_, fs::copy_options::recursive);
    expect_refusal();
    // What only resembles the marker.
    std::ofstream(aside_ / "marker") << "our";
    expect_refusal();
    fs::remove(aside_ / "marker");
    fs::create_directory(aside_ / "marker");
    expect_refusal();
    fs::remove(aside_ / "marker");
    std::ofstream(folder_ / "ours") << "ours";
    fs::create_symlink(folder_ / "ours", aside_ / "marker");
    expect_refusal();
    EXPECT_TRUE(fs::exists(aside_ / "precious"));
}

TEST_F(Unfinished, FoldersAreEmptiedWithoutFollowingLinks) {
    make();
    fs::create_symlink(folder_ / "victim", aside_ / "link");
    ASSERT_EQ(mkfifo((aside_ / "pipe").c_str(), 0600), 0);
    fs::create_directories(aside_ / "deep/deeper");
    fs::create_symlink(folder_ / "victim", aside_ / "deep/deeper/link");
    std::ofstream(aside_ / "deep/file") << "ours";
    const UnfinishedFolder folder = open();
    // What is no file and no folder goes first: a name in the folder must not lead elsewhere.
    EXPECT_EQ(folder.names(), std::vector<std::string>{"deep"});
    folder.remove_all();
    EXPECT_FALSE(fs::exists(aside_));
    EXPECT_EQ(TemporaryFolder::contents_of(folder_ / "victim"),
              (std::vector<std::string>{"deep", "precious"}));
    EXPECT_TRUE(fs::exists(folder_ / "victim/deep/file"));
}

}  // namespace
}  // namespace poinsot
