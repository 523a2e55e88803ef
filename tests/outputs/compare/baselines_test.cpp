// A folder of baselines: after any change, each picture is the approved one or is reported.
#include "compare/baselines.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>

#include "compare/compared_picture.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "image/synthetic.h"
#include "system/faults.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

class BaselineFolder : public ::testing::Test {
 protected:
    BaselineFolder() {
        for (const char* name : {"ref", "new"}) fs::create_directories(folder_ / name);
        approve("a", 1);
        approve("b", 2);
    }
    void draw(const std::string& place, int k) const {
        write_png(folder_ / (place + ".png"), synthetic_frame(32, 24, k));
    }
    BaselineWriter::Change change(const std::string& name) const {
        const fs::path from = folder_ / ("new/" + name + ".png");
        return {name, from, {pixel_hash_of_file(from), "", "", "", "", "because"}};
    }
    void approve(const std::string& name, int k) const {
        draw("new/" + name, k);
        BaselineWriter(folder_ / "ref").take({change(name)});
    }
    std::map<std::string, Outcome> compared() const {
        std::map<std::string, Outcome> outcomes;
        for (const ComparedPicture& picture :
             compare_folders(folder_ / "ref", folder_ / "new", {.limits = CompareLimits::exact()}))
            outcomes[picture.name] = picture.outcome;
        return outcomes;
    }
    std::string reason(const std::string& name) const {
        for (const ComparedPicture& picture :
             compare_folders(folder_ / "ref", folder_ / "new", {.limits = CompareLimits::exact()}))
            if (picture.name == name) return picture.reason;
        return "";
    }
    bool says(const std::string& name, const std::string& words) const {
        return reason(name).find(words) != std::string::npos;
    }

    TemporaryFolder folder_;
};

TEST_F(BaselineFolder, ApprovedPictureIsTheSame) {
    EXPECT_EQ(compared(),
              (std::map<std::string, Outcome>{{"a", Outcome::same}, {"b", Outcome::same}}));
    EXPECT_EQ(TemporaryFolder::contents_of(folder_ / "ref"),
              (std::vector<std::string>{"a.png", "b.png", manifest_name}));
}

// Both pictures were replaced by the same other picture, so that a comparison of pixels would pass.
TEST_F(BaselineFolder, ReplacedPictureIsReported) {
    draw("ref/a", 7), draw("new/a", 7);
    EXPECT_EQ(compared().at("a"), Outcome::baseline);
    EXPECT_TRUE(says("a", "the baseline does not match its hash")) << reason("a");
    EXPECT_EQ(compared().at("b"), Outcome::same);
}

TEST_F(BaselineFolder, PictureWithoutALineIsReported) {
    draw("ref/c", 3), draw("new/c", 3);
    EXPECT_EQ(compared().at("c"), Outcome::baseline);
    EXPECT_TRUE(says("c", "has no line")) << reason("c");
}

TEST_F(BaselineFolder, MissingPictureIsReportedWithOrWithoutAResult) {
    fs::remove(folder_ / "ref/a.png");
    EXPECT_EQ(compared().at("a"), Outcome::baseline);
    EXPECT_TRUE(says("a", "the picture is missing")) << reason("a");
    fs::remove(folder_ / "new/a.png");
    EXPECT_EQ(compared().at("a"), Outcome::baseline);
}

// The state that take() leaves when it is killed after any number of pictures.
TEST_F(BaselineFolder, InterruptedApprovalIsReportedAndFinished) {
    draw("new/a", 11), draw("new/b", 12);
    BaselineManifest next = read_manifest(folder_ / "ref");
    const Baseline before_b = next.at("b");
    for (const char* name : {"a", "b"}) next[name] = change(name).line;
    write_next_manifest(folder_ / "ref", next);
    fs::copy_file(folder_ / "new/a.png", folder_ / "ref/a.png",
                  fs::copy_options::overwrite_existing);
    EXPECT_TRUE(says("a", "was interrupted")) << reason("a");

    const BaselineWriter writer(folder_ / "ref");
    EXPECT_EQ(writer.finished(), std::vector<std::string>{"a"});
    EXPECT_EQ(read_manifest(folder_ / "ref").at("a"), next.at("a"));
    EXPECT_EQ(read_manifest(folder_ / "ref").at("b"), before_b);
    EXPECT_EQ(compared(),
              (std::map<std::string, Outcome>{{"a", Outcome::same}, {"b", Outcome::pixels}}));
}

// After a kill at any moment, the next run leaves every picture with a matching line, and no other
// file.
TEST_F(BaselineFolder, ApprovalKilledAtAnyMomentIsFinished) {
    for (int round = 0; round < 30; ++round) {
        draw("new/a", 20 + 2 * round), draw("new/b", 21 + 2 * round);
        const pid_t child = fork();
        if (child == 0) {
            BaselineWriter(folder_ / "ref").take({change("a"), change("b")});
            _exit(0);
        }
        usleep(static_cast<useconds_t>(100 * round));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        BaselineWriter(folder_ / "ref").take({});
        for (const char* name : {"a", "b"})
            EXPECT_EQ(Baselines(folder_ / "ref")
                          .fault(name, pixel_hash_of_file(folder_ / "ref" /
                                                          (std::string(name) + ".png"))),
                      "")
                << round;
    }
}

TEST_F(BaselineFolder, WritesTheLinesOfCopiedPicturesAfterAnError) {
    draw("new/a", 31);
    BaselineWriter::Change lost = change("b");
    lost.from = folder_ / "new/none.png";
    EXPECT_THROW(BaselineWriter(folder_ / "ref").take({change("a"), lost}), EnvironmentError);
    EXPECT_EQ(compared(),
              (std::map<std::string, Outcome>{{"a", Outcome::same}, {"b", Outcome::same}}));
    EXPECT_EQ(TemporaryFolder::contents_of(folder_ / "ref").size(), 3u);
}

// The state that take() leaves when it is killed before or after it removed a picture.
TEST_F(BaselineFolder, InterruptedRemovalIsFinished) {
    BaselineManifest next = read_manifest(folder_ / "ref");
    next.erase("a"), next.erase("b");
    write_next_manifest(folder_ / "ref", next);
    fs::remove(folder_ / "ref/a.png");
    { const BaselineWriter writer(folder_ / "ref"); }
    EXPECT_FALSE(read_manifest(folder_ / "ref").contains("a"));
    EXPECT_EQ(compared(),
              (std::map<std::string, Outcome>{{"a", Outcome::unexpected}, {"b", Outcome::same}}));
    BaselineWriter(folder_ / "ref").take({}, {"b"});
    EXPECT_EQ(TemporaryFolder::contents_of(folder_ / "ref"),
              (std::vector<std::string>{manifest_name}));
}

// Eight processes at once, one picture each: none of their lines is lost.
TEST_F(BaselineFolder, AcceptsConcurrentWriters) {
    std::vector<pid_t> children;
    for (int k = 0; k < 8; ++k) {
        draw("new/c" + std::to_string(k), 40 + k);
        children.push_back(fork());
        if (children.back() == 0) {
            BaselineWriter(folder_ / "ref").take({change("c" + std::to_string(k))});
            _exit(0);
        }
    }
    for (const pid_t child : children) {
        int status = 0;
        waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
    }
    for (const auto& [name, outcome] : compared()) EXPECT_EQ(outcome, Outcome::same) << name;
    EXPECT_EQ(compared().size(), 10u);
}

// A waiting writer reports it first, and then gets the lock.
TEST_F(BaselineFolder, WaitingIsReported) {
    std::optional<BaselineWriter> first(std::in_place, folder_ / "ref");
    int n_words = 0;
    // The first writer ends as soon as the second begins to wait.
    const BaselineWriter second(folder_ / "ref", [&] {
        ++n_words;
        first.reset();
    });
    EXPECT_EQ(n_words, 1);
}

TEST(Baselines, LeaveNoEmptyFolder) {
    const TemporaryFolder folder;
    { const BaselineWriter writer(folder / "ref"); }
    EXPECT_FALSE(fs::exists(folder / "ref"));
}

}  // namespace
}  // namespace poinsot
