// Folders of pictures compared in one pass, and reports of the outcomes.
#include "compare/compared_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "compare/github_report.h"
#include "compare/html_report.h"
#include "compare/json_report.h"
#include "compare/junit.h"
#include "compare/report_pictures.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "image/synthetic.h"
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
        names.reserve(pictures.size());
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

// Counts what is decoded and measured: measures only on request and for pictures that differ; of
// two byte-identical files only one is decoded.
TEST_F(Folders, MeasureNoMoreThanIsAskedFor) {
    const auto names_read = [this](const std::string& name, bool measures) {
        std::vector<std::string> read;
        CompareRequest request{
            .limits = CompareLimits::exact(), .ssim = measures, .flip = measures};
        request.read = [&read](const fs::path& path) {
            read.push_back(path.filename().string());
            return read_stored_png(path);
        };
        const ComparedPicture picture = compare_files(name, folder_ / ("ref/" + name + ".png"),
                                                      folder_ / ("new/" + name + ".png"), request);
        EXPECT_EQ(picture.measured.flip.has_value(), measures && name != "same");
        EXPECT_EQ(picture.measured.ssim.has_value(), measures && name != "same");
        return read.size();
    };
    EXPECT_EQ(names_read("same", true), 1u);
    EXPECT_EQ(names_read("a_lot", false), 2u);
    EXPECT_EQ(names_read("a_lot", true), 2u);
    // The headers say that sizes differ.
    EXPECT_EQ(names_read("sub/wide", false), 0u);
    // The same pixels in files of other bytes are decoded, and not measured either.
    write_png(folder_ / "new/same.png", synthetic_frame(64, 36, 0), {.texts = {{"a", "b"}}});
    EXPECT_EQ(names_read("same", true), 2u);
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
            {.limits = CompareLimits::exact(), .ssim = true, .flip = true, .n_threads = n_threads});
        std::string text = json_report(pictures, CompareLimits::exact());
        sort_by_severity(pictures);
        return text + json_report(pictures, CompareLimits::exact());
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
    ReportPictures shown(folder_ / "report.html", true);
    picture.changes = {hostile_name};
    const ComparedFolders folders{hostile_name, hostile_name};
    const std::string page = html_report(hostile_name, {&picture, 1}, shown, folders);
    const std::string bare = html_report("title", {&picture, 0}, shown);
    const std::string github = github_summary(hostile_name, {&picture, 1});
    const std::string annotation = github_annotations({&picture, 1});
    EXPECT_EQ(std::count(annotation.begin(), annotation.end(), '\n'), 1);
    for (const std::string* text : {&xml, &page, &github}) {
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

// The page loads nothing from a network. By default its pictures are files in a folder beside it;
// with a single file it embeds small ones.
TEST_F(Folders, GiveAPageThatLoadsNothingFromANetwork) {
    for (const bool single_file : {false, true}) {
        ReportPictures shown(folder_ / "report.html", single_file);
        CompareRequest request{.limits = CompareLimits::exact()};
        request.seen = [&shown](ComparedPicture& picture, const PicturePair& pair) {
            shown.add(picture, pair);
        };
        auto pictures = compare_folders(folder_ / "ref", folder_ / "new", request);
        const std::string page = html_report("title", pictures, shown);
        const auto count = [&page](const std::string& part) {
            int n = 0;
            for (std::size_t at = 0; (at = page.find(part, at)) != std::string::npos; ++at) ++n;
            return n;
        };
        // Expected and actual of a_little, a_lot and wide, and their differences; gone, extra, and
        // the expected one of broken. A picture that cannot be read is not embedded.
        const int n_pictures = 3 * 3 + 1 + 1 + 1;
        if (single_file) {
            EXPECT_EQ(count("\":\"data:image/png;base64,"), n_pictures);
            EXPECT_EQ(count("report_pictures"), 0);
        } else {
            EXPECT_EQ(count("\":\"report_pictures/"), n_pictures + 1);
            EXPECT_EQ(count("data:image/png"), 0);
            // With the list by which the next report knows them again.
            EXPECT_EQ(TemporaryFolder::contents_of(folder_ / "report_pictures").size(), 14u);
        }
        for (const char* fetches : {"http://", "https://", "src=\"/", "url(", "@import", "fetch("})
            EXPECT_EQ(page.find(fetches), std::string::npos) << fetches;
    }
}

// Addresses in a page: # would begin a fragment, % an escape.
TEST_F(Folders, HaveReportsOfAnyName) {
    ReportPictures shown(folder_ / "wall #3 50%.html", false);
    CompareRequest request{.limits = CompareLimits::exact()};
    request.seen = [&shown](ComparedPicture& picture, const PicturePair& pair) {
        shown.add(picture, pair);
    };
    const ComparedPicture picture =
        compare_files("a_lot", folder_ / "ref/a_lot.png", folder_ / "new/a_lot.png", request);
    EXPECT_EQ(picture.shown.expected, "wall%20%233%2050%25_pictures/a_lot-expected.png");
    EXPECT_EQ(picture.shown.difference, "wall%20%233%2050%25_pictures/a_lot-difference.png");
    EXPECT_TRUE(fs::exists(folder_ / "wall #3 50%_pictures/a_lot-difference.png"));
}

// What changed is a list; a separator within a change does not split it, nor is it cut.
TEST_F(Folders, HaveReportsWithAllChanges) {
    ComparedPicture picture =
        compare_files("a_lot", folder_ / "ref/a_lot.png", folder_ / "new/a_lot.png", {});
    ReportPictures shown(folder_ / "report.html", true);
    const std::string change = "caption: one; two → " + std::string(500, 'x');
    picture.changes = {change, "theme: light → dark"};
    EXPECT_NE(html_report("title", {&picture, 1}, shown)
                  .find("\"changes\":[\"" + change + "\",\"theme: light → dark\"]"),
              std::string::npos);
    picture.changes = {};
    EXPECT_NE(html_report("title", {&picture, 1}, shown).find("\"changes\":null"),
              std::string::npos);
    picture.changes.emplace();
    EXPECT_NE(html_report("title", {&picture, 1}, shown).find("\"changes\":[]"), std::string::npos);
}

// A file that approve does not take is not to be approved.
TEST_F(Folders, SayWhatToDoWithoutABaseline) {
    std::ofstream(folder_ / "new/extra.mp4") << "a film";
    std::map<std::string, std::string> reasons;
    for (const ComparedPicture& picture : compared()) reasons[picture.name] = picture.reason;
    EXPECT_EQ(reasons["extra"], "this picture has no baseline; approve it if it is right");
    EXPECT_EQ(reasons["extra.mp4"], "this file has no baseline; approve it if it is right");
}

// Without the program that renders pages, a folder's other files are compared; a report that cannot
// be written is no fault of the page.
TEST_F(Folders, OfPagesFailWhereAReportCannotBeWritten) {
    for (const char* side : {"ref", "new"})
        std::ofstream(folder_ / side / "page.svg")
            << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\"><rect width=\""
            << (side == std::string("ref") ? 3 : 5) << "\" height=\"5\"/></svg>";
    bool seen = false;
    CompareRequest request;
    request.seen = [&seen](ComparedPicture& picture, const PicturePair&) {
        if (picture.name != "page.svg") return;
        seen = true;
        throw EnvironmentError("disk full");
    };
    std::optional<std::string> thrown;
    std::vector<ComparedPicture> pictures;
    try {
        pictures = compare_folders(folder_ / "ref", folder_ / "new", request);
    } catch (const EnvironmentError& error) {
        thrown = error.what();
    }
    EXPECT_EQ(thrown.value_or("none"), seen ? "disk full" : "none");
    for (const ComparedPicture& picture : pictures)
        EXPECT_TRUE(picture.name != "page.svg" || picture.outcome == Outcome::unreadable);
}

// In pieces of a mebibyte.
TEST_F(Folders, HoldFilesOfAnySize) {
    const std::string bytes(3 << 20, 'x');
    std::ofstream(folder_ / "ref/page.pdf") << bytes;
    std::ofstream(folder_ / "new/page.pdf") << bytes;
    EXPECT_EQ(compare_files("page", folder_ / "ref/page.pdf", folder_ / "new/page.pdf", {}).outcome,
              Outcome::same);
    std::ofstream(folder_ / "new/page.pdf") << bytes.substr(1) << 'y';
    EXPECT_NE(compare_files("page", folder_ / "ref/page.pdf", folder_ / "new/page.pdf", {}).outcome,
              Outcome::same);
}

// A report leaves no picture of an earlier one in its folder, and nobody else's file is touched.
TEST_F(Folders, GiveAReportWithoutOldPictures) {
    const auto made = [this] {
        ReportPictures shown(folder_ / "report.html", false);
        CompareRequest request{.limits = CompareLimits::exact()};
        request.seen = [&shown](ComparedPicture& picture, const PicturePair& pair) {
            shown.add(picture, pair);
        };
        ComparedPicture picture =
            compare_files("a_lot", folder_ / "ref/a_lot.png", folder_ / "new/a_lot.png", request);
        return html_report("title", {&picture, 1}, shown);
    };
    made();
    EXPECT_GE(TemporaryFolder::contents_of(folder_ / "report_pictures").size(), 3u);
    for (const char* name : {"mine.png", "notes.txt"})
        std::ofstream(folder_ / "report_pictures" / name) << "text";
    const ReportPictures shown(folder_ / "report.html", false);
    EXPECT_EQ(TemporaryFolder::contents_of(folder_ / "report_pictures"),
              (std::vector<std::string>{"mine.png", "notes.txt", "poinsot-files"}));
    // A picture that no report lists is somebody's.
    std::ofstream(folder_ / "report_pictures" / "old-expected.png") << "text";
    EXPECT_THROW(ReportPictures(folder_ / "report.html", false), InputError);
}

// Regions that are rectangles need no record; a name needs one.
TEST_F(Folders, IgnoreRegions) {
    const auto outcome = [this](const char* region) {
        const ComparedPicture picture =
            compare_files("a_lot", folder_ / "ref/a_lot.png", folder_ / "new/a_lot.png",
                          {.given = {.ignore = {parse_region(region)}}});
        return std::pair(picture.outcome, picture.reason);
    };
    EXPECT_EQ(outcome("0,0,5,5").first, Outcome::pixels);
    EXPECT_NE(outcome("0,0,5,5").second.find("; 25 pixels ignored (0,0,5,5)"), std::string::npos)
        << outcome("0,0,5,5").second;
    EXPECT_EQ(outcome("0%,0%,100%,100%").first, Outcome::region);
    EXPECT_NE(outcome("0%,0%,100%,100%").second.find("nothing is compared"), std::string::npos);
    EXPECT_EQ(outcome("clock").first, Outcome::region);
    EXPECT_NE(outcome("clock").second.find("neither picture has a record"), std::string::npos);
    EXPECT_NE(outcome("clock").second.find("with [[pictures]] in compare.toml"), std::string::npos);
}

// A measure decides alone unless pixels are limited, too.
TEST_F(Folders, PassByTheirOwnLimits) {
    const auto outcome = [this](const GivenLimits& given) {
        return compare_files("a_lot", folder_ / "ref/a_lot.png", folder_ / "new/a_lot.png",
                             {.given = given})
            .outcome;
    };
    EXPECT_EQ(outcome({}), Outcome::pixels);
    EXPECT_EQ(outcome({.max_flip = 0.9}), Outcome::within_limits);
    EXPECT_EQ(outcome({.max_flip = 1e-6}), Outcome::pixels);
    EXPECT_EQ(outcome({.max_flip = 0.9, .min_ssim = 0.99999}), Outcome::pixels);
    EXPECT_EQ(outcome({.max_differing = 0.0, .max_flip = 0.9}), Outcome::pixels);
    const CompareFile file =
        parse_compare_file("[[pictures]]\nname = \"a_*\"\nmax_flip = 0.9\n", "f");
    EXPECT_EQ(
        compare_files("a_lot", folder_ / "ref/a_lot.png", folder_ / "new/a_lot.png", {.file = file})
            .outcome,
        Outcome::within_limits);
}

// An entry for which there is no picture is a typing error.
TEST_F(Folders, RefuseACompareFileForOtherPictures) {
    const CompareFile file =
        parse_compare_file("[[pictures]]\nname = \"a_litle\"\nmax_flip = 0.9\n", "compare.toml");
    try {
        compare_folders(folder_ / "ref", folder_ / "new", {.file = file});
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "compare.toml:2:8: \"a_litle\" matches none of the 7 pictures; did you mean "
                  "\"a_little\"?");
    }
}

TEST_F(Folders, GiveGitHubAnnotations) {
    auto pictures = compared();
    sort_by_severity(pictures);
    const std::string lines = github_annotations(pictures);
    EXPECT_EQ(lines.find("::error file="), 0u) << lines;
    EXPECT_NE(lines.find("title=pixels%3A a_lot::"), std::string::npos) << lines;
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 6);
    const std::string summary = github_summary("title", pictures);
    EXPECT_NE(summary.find("7 compared, 6 failed, 1 the same"), std::string::npos) << summary;
    EXPECT_EQ(summary.find("| same |"), std::string::npos);
    // GitHub shows ten annotations of a step: the last counts the others.
    std::vector<ComparedPicture> many(40, pictures.front());
    const std::string of_many = github_annotations(many);
    EXPECT_EQ(std::count(of_many.begin(), of_many.end(), '\n'), 10);
    EXPECT_NE(of_many.find("31 more pictures failed"), std::string::npos);
    many.resize(10);
    EXPECT_EQ(github_annotations(many).find("more picture"), std::string::npos);
    many.resize(11, many.front());
    EXPECT_NE(github_annotations(many).find("2 more pictures failed"), std::string::npos);
}

}  // namespace
}  // namespace poinsot
