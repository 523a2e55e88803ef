// Folders of pictures compared in one pass, and reports of the outcomes.
#include "report/compared_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "error/error.h"
#include "image/files/png_files.h"
#include "image/synthetic.h"
#include "report/html_report.h"
#include "report/json_report.h"
#include "report/junit.h"
#include "system/faults.h"
#include "system/in_parallel.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

// A name that would be markup and the end of a script if it were not escaped.
const std::string hostile_name = "a<b> & \"c\" 'd' </script>\x1b[31m";
const std::string hostile_file = "a<b> & \"c\" 'd' <script>\x1b[31m";

class Folders : public ::testing::Test {
 protected:
    Folders() {
        for (const char* name : {"ref", "new"}) fs::create_directories(folder_ / name / "sub");
        put("ref/same", 0), put("new/same", 0);
        put("ref/gone", 0);
        put("ref/a_little", 0), put("new/a_little", 1);
        put("ref/a_lot", 0), put("new/a_lot", 9);
        put("ref/sub/wide", 0);
        write_png(folder_ / "new/sub/wide.png", synthetic_frame(40, 36, 0));
        put("new/extra", 0);
        put("ref/broken", 0);
        std::ofstream(folder_ / "new/broken.png") << "no PNG";
        // Hidden files and other file types are ignored.
        put("ref/.hidden", 0);
        std::ofstream(folder_ / "ref/notes.txt") << "text";
    }
    void put(const std::string& name, int k) const {
        write_png(folder_ / (name + ".png"), synthetic_frame(64, 36, k));
    }
    std::vector<ComparedPicture> compared(CompareLimits limits = CompareLimits::exact()) const {
        return compare_folders(folder_ / "ref", folder_ / "new", {.limits = limits});
    }
    static std::vector<std::string> names_of(const std::vector<ComparedPicture>& pictures) {
        std::vector<std::string> names;
        for (const ComparedPicture& picture : pictures) names.push_back(picture.name);
        return names;
    }

    TemporaryFolder folder_;
};

// Limits from the renderers of both: none may differ, a level between two versions of llvmpipe, no
// known limits.
TEST(LimitsBetween, FollowTheRenderers) {
    Baseline approved;
    approved.renderer = "llvmpipe (LLVM 15.0.6, 128 bits)";
    approved.mesa = "22.3.6";
    const auto same = limits_between(approved, approved.renderer, approved.mesa);
    ASSERT_TRUE(same);
    EXPECT_EQ(same->differing_share, 0.0);
    const auto newer = limits_between(approved, "llvmpipe (LLVM 22.1.8, 128 bits)", "26.2.6");
    ASSERT_TRUE(newer);
    EXPECT_EQ(newer->differing_share, 1e-3);
    EXPECT_EQ(newer->level, 1);
    EXPECT_EQ(newer->over_level_share, 0.0);
    EXPECT_FALSE(limits_between(approved, "NVIDIA H200", "26.2.6"));
}

TEST_F(Folders, GiveEachPictureItsOutcome) {
    const std::map<std::string, Outcome> expected = {
        {"same", Outcome::same},        {"gone", Outcome::missing},  {"a_little", Outcome::pixels},
        {"a_lot", Outcome::pixels},     {"sub/wide", Outcome::size}, {"extra", Outcome::unexpected},
        {"broken", Outcome::unreadable}};
    const auto pictures = compared();
    EXPECT_EQ(pictures.size(), expected.size());
    for (const ComparedPicture& picture : pictures) {
        EXPECT_EQ(picture.outcome, expected.at(picture.name)) << picture.name;
        EXPECT_EQ(picture.passes(), picture.name == "same") << picture.name;
        EXPECT_EQ(picture.reason.empty(), picture.name == "same") << picture.name;
        EXPECT_EQ(picture.reason.find('\n'), std::string::npos);
    }
    EXPECT_FALSE(all_pass(pictures));
}

TEST_F(Folders, AreSortedBySeverity) {
    auto pictures = compared();
    sort_by_severity(pictures);
    EXPECT_EQ(names_of(pictures), (std::vector<std::string>{"broken", "gone", "sub/wide", "a_lot",
                                                            "a_little", "extra", "same"}));
    // The order does not depend on the order of comparison.
    std::reverse(pictures.begin(), pictures.end());
    sort_by_severity(pictures);
    EXPECT_EQ(names_of(pictures).front(), "broken");
    EXPECT_EQ(names_of(pictures).at(3), "a_lot");
}

TEST_F(Folders, PassWithinLimits) {
    const CompareLimits anything{1, 255, 1};
    for (const ComparedPicture& picture : compared(anything))
        if (picture.name == "a_lot") {
            EXPECT_EQ(picture.outcome, Outcome::within_limits);
            EXPECT_TRUE(picture.passes());
        }
}

// Counts what is decoded and measured: likeness only on request and for pictures that differ; of
// two byte-identical files only one.
TEST_F(Folders, MeasureNoMoreThanIsAskedFor) {
    const auto names_read = [this](const std::string& name, bool measures, int* n_measured) {
        std::vector<std::string> read;
        CompareRequest request{.limits = CompareLimits::exact()};
        if (measures)
            request.likeness = [n_measured](const Image& a, const Image& b) {
                ++*n_measured;
                return likeness_of(a, b);
            };
        request.read = [&read](const fs::path& path) {
            read.push_back(path.filename().string());
            return read_stored_png(path);
        };
        const ComparedPicture picture = compare_files(name, folder_ / ("ref/" + name + ".png"),
                                                      folder_ / ("new/" + name + ".png"), request);
        EXPECT_EQ(picture.measured.likeness.has_value(), measures && name != "same");
        return read.size();
    };
    int n_measured = 0;
    EXPECT_EQ(names_read("same", true, &n_measured), 1u);
    EXPECT_EQ(n_measured, 0);
    EXPECT_EQ(names_read("a_lot", false, &n_measured), 2u);
    EXPECT_EQ(n_measured, 0);
    EXPECT_EQ(names_read("a_lot", true, &n_measured), 2u);
    EXPECT_EQ(n_measured, 1);
    // The same pixels in files of other bytes are decoded, and not measured either.
    write_png(folder_ / "new/same.png", synthetic_frame(64, 36, 0), {.texts = {{"a", "b"}}});
    EXPECT_EQ(names_read("same", true, &n_measured), 2u);
    EXPECT_EQ(n_measured, 1);
    const ComparedPicture broken =
        compare_files("broken", folder_ / "new/broken.png", folder_ / "new/broken.png", {});
    EXPECT_EQ(broken.outcome, Outcome::unreadable);
}

TEST_F(Folders, AreComparedAlikeByAnyNumberOfThreads) {
    for (int k = 0; k < 40; ++k) {
        const std::string name = "many" + std::to_string(k);
        put("ref/" + name, 0), put("new/" + name, k % 3);
    }
    const auto json = [this](int n_threads) {
        auto pictures = compare_folders(
            folder_ / "ref", folder_ / "new",
            {.limits = CompareLimits::exact(), .likeness = likeness_of, .n_threads = n_threads});
        std::string text = json_report(pictures, CompareLimits::exact(), true);
        sort_by_severity(pictures);
        return text + json_report(pictures, CompareLimits::exact(), true);
    };
    const std::string alone = json(1);
    EXPECT_EQ(json(2), alone);
    EXPECT_EQ(json(7), alone);
    EXPECT_NE(alone.find("\"flip\""), std::string::npos);
}

TEST(InParallel, ThrowsOnWhatTheFirstOfAllThrew) {
    for (const int n_threads : {1, 2, 5}) {
        std::vector<int> done(100, 0);
        try {
            in_parallel(done.size(), n_threads, [&](std::size_t i) {
                if (i % 30 == 17) throw InputError(std::to_string(i));
                ++done[i];
            });
            ADD_FAILURE();
        } catch (const InputError& error) {
            EXPECT_EQ(std::string(error.what()), "17");
        }
        for (std::size_t i = 0; i < 17; ++i) EXPECT_EQ(done[i], 1);
    }
}

TEST_F(Folders, WithoutPicturesAreRefused) {
    const TemporaryFolder empty;
    EXPECT_THROW(compare_folders(empty.path(), empty.path(), {}), InputError);
    EXPECT_THROW(compare_folders(empty / "none", folder_ / "new", {}), InputError);
}

TEST_F(Folders, GiveJUnitTestResults) {
    auto pictures = compared();
    sort_by_severity(pictures);
    const std::string xml = junit_xml("new <compared>", pictures);
    EXPECT_NE(xml.find(R"(name="new &lt;compared&gt;" tests="7" failures="5" errors="1")"),
              std::string::npos)
        << xml;
    EXPECT_NE(xml.find(R"(name="broken"><error type="unreadable")"), std::string::npos);
    EXPECT_NE(xml.find(R"(name="gone"><failure type="missing")"), std::string::npos);
    EXPECT_NE(xml.find(R"(name="same"/>)"), std::string::npos);
}

TEST_F(Folders, NamesOfAnyKindAreEscaped) {
    put("ref/" + hostile_file, 0), put("new/" + hostile_file, 3);
    ComparedPicture picture = compare_files(
        hostile_name, folder_ / ("ref/" + hostile_file + ".png"),
        folder_ / ("new/" + hostile_file + ".png"), {.limits = CompareLimits::exact()});
    ASSERT_EQ(picture.outcome, Outcome::pixels);
    picture.reason += hostile_name;
    const std::string xml = junit_xml(hostile_name, {&picture, 1});
    const std::string page = html_report(hostile_name, {&picture, 1});
    const std::string bare = html_report("title", {&picture, 0});
    for (const std::string* text : {&xml, &page}) {
        EXPECT_EQ(text->find("<b>"), std::string::npos);
        EXPECT_EQ(text->find('\x1b'), std::string::npos);
    }
    // The page has as many elements of each kind as a page without pictures.
    const auto count = [](const std::string& text, const std::string& part) {
        int n = 0;
        for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++n;
        return n;
    };
    for (const char* tag : {"<script", "</script", "<title", "<body"})
        EXPECT_EQ(count(page, tag), count(bare, tag)) << tag;
}

// The page loads nothing from a network: it embeds the displayed pictures, and no others.
TEST_F(Folders, GiveASelfContainedPage) {
    auto pictures = compared();
    const std::string page = html_report("title", pictures);
    // Expected and actual of a_little, a_lot and wide, and their differences; gone, extra, and
    // broken's two.
    int n_embedded = 0;
    for (std::size_t at = 0; (at = page.find("data:image/png;base64,", at)) != std::string::npos;
         ++at)
        ++n_embedded;
    EXPECT_EQ(n_embedded, 3 * 3 + 1 + 1 + 2);
    for (const char* fetches : {"http://", "https://", "src=\"/", "url(", "@import", "fetch("})
        EXPECT_EQ(page.find(fetches), std::string::npos) << fetches;
    fs::remove(folder_ / "ref/a_lot.png");
    EXPECT_THROW(html_report("title", pictures), Error);
}

}  // namespace
}  // namespace poinsot
