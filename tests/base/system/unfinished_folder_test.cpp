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

    UnfinishedFolder open(const std::string& work = "ours, of a.mp4") const {
        return {AtomicFile::lock(place_.output, folder_ / ".a.mp4.held"), place_, work};
    }
    // As a killed run leaves it.
    void make() const {
        fs::create_directory(aside_);
        std::ofstream(aside_ / "marker") << "ours, of a.mp4";
    }

    void expect_refusal() const {
        for (const auto& attempt :
             {std::function<void()>([this] { open(); }),
              std::function<void()>([this] { UnfinishedFolder::left(place_); })}) {
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
    const UnfinishedPlace place_{folder_ / "a.mp4", aside_, "marker", "ours"};
};

TEST_F(Unfinished, FoldersAreMadeAndFoundAgain) {
    EXPECT_FALSE(UnfinishedFolder::left(place_).has_value());
    EXPECT_FALSE(fs::exists(aside_));
    {
        const UnfinishedFolder made = open();
        EXPECT_TRUE(made.names().empty());
        std::ofstream(made.file("b")) << "b";
        fs::create_directory(made.file("c"));
    }
    {
        const UnfinishedFolder again = open();
        EXPECT_EQ(again.names(), (std::vector<std::string>{"b", "c"}));
        again.remove("b");
        EXPECT_EQ(UnfinishedFolder::left(place_)->names(), std::vector<std::string>{"c"});
        again.keep_only([](const std::string& name) { return name != "c"; });
        EXPECT_TRUE(fs::exists(aside_ / "marker"));
    }
    // Nothing is left for another run.
    EXPECT_EQ(folder_.contents(), std::vector<std::string>{"victim"});
}

// A run that was killed before, while or after it wrote the marker.
TEST_F(Unfinished, FoldersOfKilledRunsAreTakenOver) {
    fs::create_directory(aside_);
    EXPECT_TRUE(open().names().empty());
    fs::create_directory(aside_);
    std::ofstream(aside_ / ".marker.part") << "ou";
    fs::permissions(aside_ / ".marker.part", fs::perms::sticky_bit, fs::perm_options::add);
    EXPECT_TRUE(open().names().empty());
    make();
    EXPECT_TRUE(open().names().empty());
    EXPECT_EQ(folder_.contents(), std::vector<std::string>{"victim"});
}

TEST_F(Unfinished, FoldersThatCannotBeOpenedAreNamed) {
    fs::permissions(folder_.path(), fs::perms(0777));
    fs::create_directory(aside_);
    fs::permissions(aside_, fs::perms(0));
    const std::string outcome = outcome_in_child([&] {
        drop_privileges();
        open();
    });
    EXPECT_EQ(outcome, "cannot write " + (folder_ / "a.mp4").string() + ": its temporary folder " +
                           aside_.string() +
                           " exists and cannot be opened (Permission denied); remove it, or name "
                           "another output");
}

// Files are continued only by the work that has left them.
TEST_F(Unfinished, FilesOfOtherWorkAreRemoved) {
    for (const std::string other : {"ours, of a.mp3", "ours, of a.mp", "ours, of a.mp4."}) {
        make();
        std::ofstream(aside_ / "b") << "b";
        EXPECT_EQ(open().names(), std::vector<std::string>{"b"});
        const UnfinishedFolder folder = open(other);
        EXPECT_TRUE(folder.names().empty()) << other;
        std::string marker;
        std::getline(std::ifstream(aside_ / "marker"), marker);
        EXPECT_EQ(marker, other);
    }
}

TEST_F(Unfinished, FoldersAreHeldByOneRun) {
    UnfinishedFolder first = open();
    std::ofstream(first.file("b")) << "b";
    EXPECT_THROW(open(), EnvironmentError);
    EXPECT_EQ(first.names(), std::vector<std::string>{"b"});
    first.remove_all();
    EXPECT_FALSE(fs::exists(aside_));
    EXPECT_TRUE(open().names().empty());
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
    UnfinishedFolder folder = open();
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
