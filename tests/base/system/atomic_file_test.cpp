// Files are written atomically: complete under their name, or absent.
#include "system/files/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "refusal.h"
#include "system/faults.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;
using ::testing::Test;

std::vector<std::uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

std::string text_of(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// Leaves the temporary file of a run that was killed.
void leave_aside(const fs::path& path, const std::string& contents) {
    const std::string outcome = outcome_in_child([&] {
        AtomicFile file(path);
        file.write(bytes_of(contents));
        ::_exit(0);
    });
    ASSERT_EQ(outcome, "");
}

TEST(AtomicFile, AppearsOnlyWhenCommitted) {
    const TemporaryFolder folder;
    AtomicFile file(folder / "a.png");
    file.write(bytes_of("half"));
    EXPECT_FALSE(fs::exists(folder / "a.png"));
    file.write(bytes_of(" and half"));
    file.commit();
    EXPECT_EQ(text_of(folder / "a.png"), "half and half");
    EXPECT_EQ(folder.contents(), std::vector<std::string>{"a.png"});
}

TEST(AtomicFile, UncommittedKeepsOnlyTheOldFile) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.png") << "old";
    {
        AtomicFile file(folder / "a.png");
        file.write(bytes_of("new"));
    }
    EXPECT_EQ(text_of(folder / "a.png"), "old");
    EXPECT_EQ(folder.contents(), std::vector<std::string>{"a.png"});
}

TEST(AtomicFile, RejectsASecondRunOnTheSameOutput) {
    const TemporaryFolder folder;
    AtomicFile first(folder / "a.png");
    EXPECT_NE(refusal_message<EnvironmentError>([&] {
                  AtomicFile second(folder / "a.png");
              }).find("another run"),
              std::string::npos);
    first.write(bytes_of("first"));
    first.commit();
    AtomicFile(folder / "a.png").commit();
    EXPECT_EQ(text_of(folder / "a.png"), "");
}

TEST(AtomicFile, TakesOverTheTemporaryFileOfAKilledRun) {
    const TemporaryFolder folder;
    leave_aside(folder / "a.png", "remains of another run");
    EXPECT_EQ(text_of(folder / ".a.png.part"), "remains of another run");
    check_aside(folder / "a.png");
    AtomicFile file(folder / "a.png");
    file.write(bytes_of("new"));
    file.commit();
    EXPECT_EQ(text_of(folder / "a.png"), "new");
    EXPECT_EQ(folder.contents(), std::vector<std::string>{"a.png"});
    // The mark of unfinished work is gone.
    EXPECT_EQ(fs::status(folder / "a.png").permissions() & fs::perms::sticky_bit, fs::perms::none);
    leave_aside(folder / "a.png", "remains of another run");
    remove_left_aside(folder / "a.png");
    EXPECT_EQ(folder.contents(), std::vector<std::string>{"a.png"});
}

// A file of somebody else stays, also an empty one and one that a run would lock or remove.
TEST(AtomicFile, LeavesAFileThatItHasNotMade) {
    const TemporaryFolder folder;
    for (const std::string contents : {"", "mine"}) {
        std::ofstream(folder / ".a.png.part") << contents;
        const std::string refusal =
            "cannot write " + (folder / "a.png").string() + ": its temporary file " +
            (folder / ".a.png.part").string() +
            " exists and is not unfinished work of poinsot; remove it, or name another output";
        EXPECT_EQ(refusal_message<EnvironmentError>([&] { AtomicFile file(folder / "a.png"); }),
                  refusal);
        EXPECT_EQ(refusal_message<EnvironmentError>([&] { check_aside(folder / "a.png"); }),
                  refusal);
        EXPECT_EQ(refusal_message<EnvironmentError>(
                      [&] { AtomicFile::lock(folder / "a.png", folder / ".a.png.part"); }),
                  refusal);
        remove_left_aside(folder / "a.png");
        EXPECT_EQ(folder.contents(), std::vector<std::string>{".a.png.part"});
        EXPECT_EQ(text_of(folder / ".a.png.part"), contents);
    }
    // A copy of one that the caller knows by its contents.
    const auto is_mine = [](int descriptor) {
        std::string text(4, ' ');
        return pread(descriptor, text.data(), text.size(), 0) == 4 && text == "mine";
    };
    AtomicFile file(folder / "a.png", folder / ".a.png.part", true, {}, is_mine);
    file.release();
    check_aside(folder / "a.png");
}

TEST(AtomicFile, ReleasedContentsAreKeptForTheNextRun) {
    const TemporaryFolder folder;
    {
        AtomicFile file(folder / "a.mp4", folder / ".a.part");
        file.write(bytes_of("kept"));
        file.release();
    }
    EXPECT_EQ(text_of(folder / ".a.part"), "kept");
    {
        AtomicFile file(folder / "a.mp4", folder / ".a.part", true);
        EXPECT_EQ(text_of(folder / ".a.part"), "kept");
    }
    // Kept again unless discarded, so that an error while continuing loses nothing.
    {
        AtomicFile file(folder / "a.mp4", folder / ".a.part", true);
        EXPECT_EQ(text_of(folder / ".a.part"), "kept");
        file.discard();
    }
    EXPECT_TRUE(folder.contents().empty());
    { const AtomicFile without_contents(folder / "a.mp4", folder / ".a.part", true); }
    EXPECT_TRUE(folder.contents().empty());
}

TEST(AtomicFile, FollowsASymbolicLink) {
    const TemporaryFolder folder;
    std::ofstream(folder / "target.png") << "old";
    fs::create_symlink("target.png", folder / "link.png");
    AtomicFile file(folder / "link.png");
    file.write(bytes_of("new"));
    file.commit();
    EXPECT_TRUE(fs::is_symlink(folder / "link.png"));
    EXPECT_EQ(text_of(folder / "target.png"), "new");
}

// Also where the file to which links lead is not there yet.
TEST(AtomicFile, FollowsALinkToAFileThatIsNotThereYet) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "sub");
    fs::create_symlink("sub/second", folder / "first");
    fs::create_symlink(folder / "sub/target.png", folder / "sub/second");
    write_whole(folder / "first", std::string_view("new"));
    EXPECT_TRUE(fs::is_symlink(folder / "first"));
    EXPECT_TRUE(fs::is_symlink(folder / "sub/second"));
    EXPECT_EQ(text_of(folder / "sub/target.png"), "new");
    EXPECT_EQ(folder.contents(), (std::vector<std::string>{"first", "sub"}));

    fs::create_symlink("missing/a.png", folder / "astray");
    EXPECT_EQ(refusal_message<EnvironmentError>([&] { AtomicFile file(folder / "astray"); }),
              "cannot write " + (folder / "astray").string() + ": the folder " +
                  (folder / "missing").string() + " does not exist; make it first");
    fs::create_symlink("circle", folder / "circle");
    EXPECT_EQ(
        refusal_message<EnvironmentError>([&] { AtomicFile file(folder / "circle"); }),
        "cannot write " + (folder / "circle").string() + ": Too many levels of symbolic links");
    EXPECT_TRUE(fs::is_symlink(folder / "circle"));
}

TEST(AtomicFile, KeepsThePermissionsOfTheFileThatItReplaces) {
    const TemporaryFolder folder;
    for (const unsigned mode : {0600u, 0444u, 0640u, 0755u}) {
        std::ofstream(folder / "a.csv") << "old";
        fs::permissions(folder / "a.csv", fs::perms(mode));
        {
            AtomicFile file(folder / "a.csv");
            // Nobody else reads a private file while it is written.
            const unsigned meanwhile =
                static_cast<unsigned>(fs::status(folder / ".a.csv.part").permissions());
            EXPECT_EQ(meanwhile & 0777u, mode | 0600u);
            file.write(bytes_of("new"));
            file.commit();
        }
        EXPECT_EQ(static_cast<unsigned>(fs::status(folder / "a.csv").permissions()), mode);
        EXPECT_EQ(text_of(folder / "a.csv"), "new");
        fs::remove(folder / "a.csv");
    }
}

TEST(AtomicFile, NamesATemporaryFileThatItCannotOpen) {
    const TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms(0777));
    std::ofstream(folder / ".a.png.part") << "x";
    fs::permissions(folder / ".a.png.part", fs::perms(0));
    const std::string outcome = outcome_in_child([&] {
        drop_privileges();
        AtomicFile file(folder / "a.png");
    });
    EXPECT_EQ(outcome, "cannot write " + (folder / "a.png").string() + ": its temporary file " +
                           (folder / ".a.png.part").string() +
                           " exists and cannot be opened (Permission denied); remove it, or name "
                           "another output");
}

TEST(AtomicFile, MissingFolderIsNamed) {
    const TemporaryFolder folder;
    const fs::path path = folder / "missing" / "a.png";
    const std::string message = refusal_message<EnvironmentError>([&] { AtomicFile file(path); });
    EXPECT_EQ(message, "cannot write " + path.string() + ": the folder " +
                           path.parent_path().string() + " does not exist; make it first");
}

TEST(AtomicFile, NamesTheOutputAndNotTheAimOfALink) {
    const TemporaryFolder folder;
    std::ofstream(folder / "target.png") << "old";
    fs::create_symlink("target.png", folder / "link.png");
    const AtomicFile first(folder / "link.png");
    EXPECT_TRUE(refusal_message<EnvironmentError>([&] {
                    AtomicFile second(folder / "link.png");
                }).starts_with("cannot write " + (folder / "link.png").string() + ": another"));
}

TEST(AtomicFile, TooLongANameIsSaidSo) {
    const TemporaryFolder folder;
    for (const std::size_t n : {252u, 300u}) {
        const fs::path path = folder / std::string(n, 'a');
        EXPECT_TRUE(refusal_message<EnvironmentError>([&] {
                        AtomicFile file(path);
                    }).starts_with("cannot write " + path.string() + ": the name is too long; "));
        EXPECT_TRUE(refusal_message<EnvironmentError>([&] {
                        AtomicFile file(path / "a.png");
                    }).starts_with("cannot write " + (path / "a.png").string()));
    }
    EXPECT_TRUE(folder.contents().empty());
}

TEST(AtomicFile, RejectsAFolder) {
    const TemporaryFolder folder;
    EXPECT_NE(refusal_message<EnvironmentError>([&] {
                  AtomicFile file(folder.path());
              }).find("it is a folder"),
              std::string::npos);
}

// A pipe there would take bytes until it is full, a link would take them elsewhere.
TEST(AtomicFile, IsNotMadeInWhatIsNoRegularFile) {
    const TemporaryFolder folder;
    std::ofstream(folder / "other") << "kept";
    ASSERT_EQ(mkfifo((folder / ".pipe.png.part").c_str(), 0600), 0);
    fs::create_directory(folder / ".folder.png.part");
    fs::create_symlink("other", folder / ".link.png.part");
    for (const char* name : {"pipe.png", "folder.png", "link.png"}) {
        const std::string aside = (folder / (std::string(".") + name + ".part")).string();
        const std::string refusal =
            "cannot write " + (folder / name).string() + ": its temporary file " + aside +
            " exists and is not unfinished work of poinsot; remove it, or name another output";
        EXPECT_EQ(refusal_message<EnvironmentError>([&] { AtomicFile file(folder / name); }),
                  refusal);
        EXPECT_EQ(refusal_message<EnvironmentError>([&] { check_aside(folder / name); }), refusal);
        remove_left_aside(folder / name);
    }
    EXPECT_EQ(folder.contents().size(), 4u);
    EXPECT_EQ(text_of(folder / "other"), "kept");
}

TEST(AtomicFile, FullDeviceIsReportedAtTheWrite) {
    AtomicFile file("/dev/full");
    EXPECT_EQ(refusal_message<EnvironmentError>([&] { file.write(bytes_of("x")); }),
              "cannot write /dev/full: No space left on device");
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(AtomicFile, DeviceIsWrittenAndNotReplaced) {
    AtomicFile file("/dev/null");
    file.write(bytes_of("x"));
    file.commit();
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(AtomicFile, VanishedFolderIsReportedAtTheCommit) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "sub");
    AtomicFile file(folder / "sub" / "a.png");
    file.write(bytes_of("x"));
    fs::remove_all(folder / "sub");
    EXPECT_NE(
        refusal_message<EnvironmentError>([&] { file.commit(); }).find("No such file or directory"),
        std::string::npos);
}

TEST(AtomicFile, FolderWithoutPermissionIsReported) {
    const TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms(0555));
    const std::string outcome = outcome_in_child([&] {
        drop_privileges();
        AtomicFile file(folder / "a.png");
    });
    EXPECT_EQ(outcome, "cannot write " + (folder / "a.png").string() + ": the folder " +
                           folder.path().string() +
                           " cannot be written (Permission denied); name another");
}

TEST(AtomicFile, LimitOnFileSizeIsReportedAndLeavesNothing) {
    const TemporaryFolder folder;
    const std::string outcome = outcome_in_child([&] {
        limit_file_size(1000);
        AtomicFile file(folder / "a.png");
        file.write(std::vector<std::uint8_t>(4000));
    });
    EXPECT_EQ(outcome, "cannot write " + (folder / "a.png").string() + ": File too large");
    EXPECT_TRUE(folder.contents().empty());
}

TEST(AtomicFile, FullDiskIsReportedAndLeavesNothing) {
    const TemporaryFolder folder;
    const std::string outcome = outcome_in_child([&] {
        if (!mount_small(folder.path(), "64k"))
            throw std::runtime_error("this machine does not let us mount");
        try {
            AtomicFile file(folder / "a.png");
            file.write(std::vector<std::uint8_t>(1 << 20));
        } catch (const EnvironmentError&) {
            if (!folder.contents().empty()) throw std::runtime_error("something was left");
            throw;
        }
    });
    if (outcome == no_mount) GTEST_SKIP() << outcome;
    EXPECT_EQ(outcome, "cannot write " + (folder / "a.png").string() + ": No space left on device");
}

}  // namespace
}  // namespace poinsot
