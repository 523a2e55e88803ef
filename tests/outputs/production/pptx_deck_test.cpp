// What happens to files next to a presentation and to one that exists; its contents are read by
// tests/trust/pptx.py.
#include "production/slides/pptx_deck.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "error/error.h"
#include "production/session/files/open_session.h"
#include "production/slides/pptx_parts.h"
#include "production/slides/slide_files.h"
#include "production/slides/stored_zip.h"
#include "system/faults.h"
#include "system/files/file_contents.h"
#include "system/sha256.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

// Limits the size of files while it lives. A child process could not draw: the renderer's threads
// are not forked.
class SmallFiles {
 public:
    explicit SmallFiles(rlim_t n_bytes) {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = n_bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~SmallFiles() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, SIG_DFL);
    }
    SmallFiles(const SmallFiles&) = delete;
    SmallFiles& operator=(const SmallFiles&) = delete;

 private:
    rlimit before_{};
};

class PptxDeck : public ::testing::Test {
 protected:
    PptxDeck() {
        std::ofstream(folder_ / "a.toml") << R"([body]
moments_kg_m2 = [1.0, 2.0, 2.9]
[start]
omega_rad_s = [1.5, 0.3, 0.75]
[film]
size = [96, 54]
fps = 10
length_s = 1.0
[[stops]]
at_s = 0.5
)";
        SceneRequest request;
        request.file = (folder_ / "a.toml").string();
        session_ = std::make_unique<Session>(open_session(request));
    }

    void write() const {
        LazyRenderer renderer;
        write_pptx(*session_, {folder_ / "a.pptx", 1}, renderer, {});
    }

    // Leaves the hidden folder of an interrupted run that has finished a film with these bytes.
    void interrupt(const std::string& film) const {
        const FilmPlan plan = film_plan(*session_);
        fs::create_directory(aside_);
        std::ofstream(aside_ / slide_plan_name) << slide_plan_text(
            *session_, plan, slides_of(session_->scene, plan, "-o"),
            {.is_portable = LazyRenderer().is_portable(), .scene_file = "a.toml"});
        std::ofstream(aside_ / "01.mp4") << film;
        std::ofstream(aside_ / "finished") << sha256_of(film) << " 01.mp4\n";
    }

    TemporaryFolder folder_;
    const fs::path aside_ = folder_ / ".a.pptx.slides";
    std::unique_ptr<Session> session_;
};

TEST_F(PptxDeck, ReplacesItsOwnAndNoOther) {
    write();
    const std::string first = read_text(folder_ / "a.pptx");
    EXPECT_TRUE(first.starts_with("PK\3\4"));
    write();
    EXPECT_EQ(read_text(folder_ / "a.pptx"), first);
    EXPECT_EQ(folder_.contents(), (std::vector<std::string>{"a.pptx", "a.toml"}));

    // Programs that save a presentation compress its parts.
    for (const std::string other : {"", "PK\3\4 of another program"}) {
        std::ofstream(folder_ / "a.pptx") << other;
        try {
            write();
            ADD_FAILURE() << other;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("a.pptx: exists, and was not written by"),
                      std::string::npos)
                << error.what();
        }
        EXPECT_EQ(read_text(folder_ / "a.pptx"), other);
        EXPECT_EQ(folder_.contents(), (std::vector<std::string>{"a.pptx", "a.toml"}));
    }
}

TEST_F(PptxDeck, ContinuesWithTheFilmsOfAnInterruptedRun) {
    interrupt("a finished film");
    write();
    EXPECT_NE(read_text(folder_ / "a.pptx").find("a finished film"), std::string::npos);
    EXPECT_EQ(folder_.contents(), (std::vector<std::string>{"a.pptx", "a.toml"}));

    // The films of another plan are drawn anew.
    interrupt("a finished film");
    std::ofstream(aside_ / slide_plan_name) << any_slide_plan_head << "\"other\"";
    write();
    EXPECT_EQ(read_text(folder_ / "a.pptx").find("a finished film"), std::string::npos);
    EXPECT_EQ(folder_.contents(), (std::vector<std::string>{"a.pptx", "a.toml"}));
}

// The film fits on the disk, and the presentation with it does not.
TEST_F(PptxDeck, KeepsTheOldOneAndTheFilmsOnAFullDisk) {
    write();
    const std::string old = read_text(folder_ / "a.pptx");
    constexpr std::size_t n_bytes = 1 << 20;
    interrupt(std::string(n_bytes, '.'));
    std::string outcome;
    {
        const SmallFiles limit(n_bytes);
        try {
            write();
        } catch (const EnvironmentError& error) {
            outcome = error.what();
        }
    }
    EXPECT_TRUE(outcome.starts_with("cannot write " + (folder_ / "a.pptx").string() + ": "))
        << outcome;
    EXPECT_EQ(read_text(folder_ / "a.pptx"), old);
    EXPECT_EQ(folder_.contents(), (std::vector<std::string>{".a.pptx.slides", "a.pptx", "a.toml"}));
}

TEST_F(PptxDeck, IsRefusedWhereTheDirectoryHasChanged) {
    write();
    std::string bytes = read_text(folder_ / "a.pptx");
    write();  // as it was written, it is replaced
    // The checksum of the last entry, which an editor changes with its contents.
    const std::size_t row = bytes.rfind("PK\1\2");
    ASSERT_NE(row, std::string::npos);
    constexpr std::size_t checksum_at = 16;
    bytes[row + checksum_at] = static_cast<char>(bytes[row + checksum_at] ^ 1);
    std::ofstream(folder_ / "a.pptx", std::ios::binary) << bytes;
    EXPECT_THROW(write(), InputError);
    EXPECT_EQ(read_text(folder_ / "a.pptx"), bytes);
}

// Every byte of an entry counts, and every byte that says where it is.
TEST_F(PptxDeck, IsRefusedWhereAnyBitHasChanged) {
    write();
    const std::string bytes = read_text(folder_ / "a.pptx");
    EXPECT_TRUE(StoredZip::unchanged_entry(folder_ / "a.pptx", pptx_origin_name));
    std::mt19937 random(3);
    std::vector<std::size_t> places{0, 14, 18, 26, 30, bytes.size() - 1, bytes.size() - 30};
    for (int i = 0; i < 200; ++i)
        places.push_back(std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(random));
    for (const std::size_t place : places) {
        std::string changed = bytes;
        changed[place] = static_cast<char>(changed[place] ^ (1 << place % 8));
        std::ofstream(folder_ / "b.pptx", std::ios::binary) << changed;
        EXPECT_FALSE(StoredZip::unchanged_entry(folder_ / "b.pptx", pptx_origin_name)) << place;
    }
    for (const std::string& other : {bytes + "x", "x" + bytes, bytes.substr(0, bytes.size() / 2)}) {
        std::ofstream(folder_ / "b.pptx", std::ios::binary) << other;
        EXPECT_FALSE(StoredZip::unchanged_entry(folder_ / "b.pptx", pptx_origin_name));
    }
    std::string changed = bytes;
    changed[bytes.size() / 2] = static_cast<char>(changed[bytes.size() / 2] ^ 1);
    std::ofstream(folder_ / "a.pptx", std::ios::binary) << changed;
    EXPECT_THROW(write(), InputError);
    EXPECT_EQ(read_text(folder_ / "a.pptx"), changed);
}

TEST_F(PptxDeck, OfAnotherSceneIsRefused) {
    write();
    const std::string bytes = read_text(folder_ / "a.pptx");
    for (const std::string name : {"b.toml", "a & b.toml", "aa.toml"}) {
        fs::copy_file(folder_ / "a.toml", folder_ / name);
        SceneRequest request;
        request.file = (folder_ / name).string();
        LazyRenderer renderer;
        const Session other = open_session(request);
        try {
            write_pptx(other, {folder_ / "a.pptx", 1}, renderer, {});
            ADD_FAILURE() << name;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what())
                          .find("a.pptx: holds the slides of another scene; "
                                "name another file, or remove this one"),
                      std::string::npos)
                << error.what();
        }
        EXPECT_EQ(read_text(folder_ / "a.pptx"), bytes);
        fs::remove(folder_ / name);
    }
    const auto described = [](const SlideOrigin& own, const std::string& name,
                              const std::string& identifier) {
        return describes_slides_of(
            own, "<dc:title>T</dc:title><dc:description>poinsot 1.2: " + name +
                     "</dc:description><dc:identifier>" + identifier + "</dc:identifier>");
    };
    const std::string one(64, '1'), two(64, '2');
    const SlideOrigin in_file{"a & b", "T", "../a & b.toml", one}, in_text{"b", "T", "", one};
    // The same file with other contents; the same contents elsewhere; neither.
    EXPECT_TRUE(described(in_file, "a &amp; b", "../a &amp; b.toml " + two));
    EXPECT_TRUE(described(in_file, "a &amp; b", "x/a &amp; b.toml " + one));
    EXPECT_FALSE(described(in_file, "a &amp; b", "x/a &amp; b.toml " + two));
    EXPECT_FALSE(described(in_file, "a &amp; b", "../a &amp; b.toml x " + two));
    EXPECT_FALSE(described(in_file, "b", "../a &amp; b.toml " + two));
    EXPECT_FALSE(described(in_file, "x: a &amp; b", "../a &amp; b.toml " + two));
    // Without a file the title tells scenes of one name apart.
    EXPECT_TRUE(described(in_text, "b", " " + two));
    EXPECT_FALSE(described({"b", "U", "", one}, "b", " " + two));
    EXPECT_FALSE(described(in_text, "b", "b.toml " + two));
    EXPECT_FALSE(describes_slides_of(in_text, ""));
}

TEST_F(PptxDeck, IsRefusedWhereAnotherRunWritesIt) {
    const AtomicFile held(folder_ / "a.pptx");
    EXPECT_THROW(write(), EnvironmentError);
    EXPECT_EQ(folder_.contents(), (std::vector<std::string>{".a.pptx.part", "a.toml"}));
}

}  // namespace
}  // namespace poinsot
