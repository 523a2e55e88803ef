// A deck of slides: its seams to the pixel, its files, and what happens to folders that hold
// others.
#include "production/slides/slide_deck.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "encoding/video_reader.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "image/pixels_sha256.h"
#include "production/films/film_job.h"
#include "production/films/redraw.h"
#include "production/records/record.h"
#include "production/records/verify.h"
#include "production/slides/slide_files.h"
#include "refusal.h"
#include "system/faults.h"
#include "system/files/file_contents.h"
#include "system/sha256.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

// Chunks of 120 frames: the second slide has several.
const std::string deck_scene = R"(title = "Deck"
[body]
moments_kg_m2 = [1.0, 2.0, 2.9]
[start]
omega_rad_s = [1.5, 0.3, 0.75]
[film]
size = [96, 54]
fps = 60
length_s = 4.0
[[stops]]
at_s = 0.5
title = "One"
note = "Ask \"why\"."
[[stops]]
at_s = 3.5
loop_s = 0.5
[[captions]]
at_s = 1.0
text = "It rolls."
)";

class SlideDeck : public ::testing::Test {
 protected:
    SlideDeck() { write_scene(deck_scene); }

    void write_scene(const std::string& text) const {
        std::ofstream(folder_ / "a.toml", std::ios::binary) << text;
    }
    SceneRequest scene(const std::string& name = "a.toml") const {
        SceneRequest request;
        request.file = (folder_ / name).string();
        return request;
    }

    void write(const std::string& name) const {
        const Session session = open_session(scene());
        write_deck(session, {scene(), folder_ / name, 1}, *renderer_, {});
    }

    // Turns a deck into the folder of a run that was interrupted when it had finished these films.
    void interrupt(const std::vector<std::string>& films) const {
        fs::rename(folder_ / "deck", folder_ / ".deck.part");
        // The hashes of the files are added when all are made.
        const fs::path plan = folder_ / ".deck.part/slides.json";
        const std::string whole = read_text(plan);
        std::ofstream(plan) << whole.substr(0, whole.rfind(",\n  \"sha256\": ")) << "\n}\n";
        std::ofstream list(folder_ / ".deck.part/finished");
        for (const std::string& film : films)
            list << sha256_of(read_text(folder_ / (".deck.part/" + film))) << " " << film << "\n";
    }

    std::string refusal(const std::string& name) const {
        return refusal_message([&] { write(name); });
    }

    // All files of a folder, hidden ones included.
    std::set<std::string> files_of(const fs::path& folder) const {
        std::set<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder))
            names.insert(entry.path().filename().string());
        return names;
    }

    TemporaryFolder folder_;
    std::unique_ptr<LazyRenderer> renderer_ = std::make_unique<LazyRenderer>();
};

std::string frame_hash(VideoReader& film, std::int64_t k) { return pixels_sha256(film.frame(k)); }

const std::set<std::string> deck_files{"01.mp4", "01.png", "01.pdf", "02.mp4",      "02-loop.mp4",
                                       "02.png", "02.pdf", "02.vtt", "02-loop.vtt", "03.mp4",
                                       "03.png", "03.pdf", "03.vtt", "slides.json", "index.html"};

TEST_F(SlideDeck, FilmsMeetToThePixel) {
    write("deck");
    EXPECT_EQ(files_of(folder_ / "deck"), deck_files);
    VideoReader one(folder_ / "deck/01.mp4"), two(folder_ / "deck/02.mp4"),
        loop(folder_ / "deck/02-loop.mp4"), three(folder_ / "deck/03.mp4");
    EXPECT_EQ(one.info().n_frames, 31);
    EXPECT_EQ(two.info().n_frames, 181);
    EXPECT_EQ(loop.info().n_frames, 30);
    EXPECT_EQ(three.info().n_frames, 30);
    EXPECT_NEAR(two.info().duration_s, 181.0 / 60.0, 1e-3);
    EXPECT_EQ(frame_hash(one, 30), frame_hash(two, 0));
    EXPECT_EQ(frame_hash(two, 180), frame_hash(loop, 29));
    EXPECT_EQ(frame_hash(two, 180), frame_hash(three, 0));
    EXPECT_NE(frame_hash(two, 179), frame_hash(two, 180));
    EXPECT_EQ(two.info().codec, "h264");
    EXPECT_EQ(two.info().pixel_format, "yuv420p");
}

// The stills are the frames at which the films stop.
TEST_F(SlideDeck, StillsAreFramesOfTheWholeFilm) {
    write("deck");
    const Session session = open_session(scene());
    FilmJob(session, {(folder_ / "f_####.png").string(), {}}).make(*renderer_, {});
    EXPECT_EQ(pixels_sha256(read_png(folder_ / "deck/01.png")),
              pixels_sha256(read_png(folder_ / "f_0030.png")));
    EXPECT_EQ(pixels_sha256(read_png(folder_ / "deck/02.png")),
              pixels_sha256(read_png(folder_ / "f_0210.png")));
    EXPECT_EQ(pixels_sha256(read_png(folder_ / "deck/03.png")),
              pixels_sha256(read_png(folder_ / "f_0239.png")));
}

TEST_F(SlideDeck, FilesAreDrawnAgainFromTheirRecords) {
    write("deck");
    for (const std::string name : {"02.mp4", "02-loop.mp4", "01.png", "01.pdf"}) {
        const fs::path file = folder_ / "deck" / name, again = folder_ / ("again-" + name);
        EXPECT_EQ(verify(file, read_record(file)).verified, Verified::yes) << name;
        RedrawRequest request;
        request.file = file;
        request.output = again;
        redraw(request, {});
        EXPECT_EQ(read_bytes(again), read_bytes(file)) << name;
    }
}

// A slide for paper has the type of a hand-out, so that it has room for the same names.
TEST_F(SlideDeck, PagesHaveTheTypeOfAFigure) {
    write("deck");
    EXPECT_EQ(read_record(folder_ / "deck/01.pdf").type_pt, default_type_pt);
}

TEST_F(SlideDeck, ThePlanNamesTimesTitlesNotesAndFiles) {
    write("deck");
    const std::string plan = read_text(folder_ / "deck/slides.json");
    for (
        const std::string part :
        {R"("slides_of": "a")", R"("title": "Deck")", R"("frames_per_second": "60/1")",
         R"("size": [96, 54])",
         R"({"number": 1, "is_stop": true, "title": "One", "note": "Ask \"why\".", "film": "01.mp4", "loop": null, "captions": null, "loop_captions": null, "png": "01.png", "pdf": "01.pdf", "begin_s": 0, "end_s": 0.5, "loop_s": 0, "motion_time_s": 0.5, "first_frame": 0, "last_frame": 30})",
         R"("loop": "02-loop.mp4", "captions": "02.vtt", "loop_captions": "02-loop.vtt")",
         R"("number": 3, "is_stop": false)"})
        EXPECT_NE(plan.find(part), std::string::npos) << part << "\n" << plan;
}

// The index leads to every film and PDF, once each, and to nothing else.
TEST_F(SlideDeck, TheIndexListsTheSlides) {
    std::string marked = deck_scene;
    marked.replace(marked.find("\"One\""), 5, "\"One <b> & two\"");
    write_scene(marked);
    write("deck");
    const std::string page = read_text(folder_ / "deck/index.html");
    std::multiset<std::string> targets;
    for (const std::string mark : {"href=\"", "src=\""})
        for (std::size_t at = page.find(mark); at != std::string::npos;
             at = page.find(mark, at + 1))
            targets.insert(
                page.substr(at + mark.size(), page.find('"', at + mark.size()) - at - mark.size()));
    EXPECT_EQ(targets, (std::multiset<std::string>{
                           "01.mp4", "01.mp4", "01.pdf", "01.png", "02-loop.mp4", "02.mp4",
                           "02.mp4", "02.pdf", "02.png", "03.mp4", "03.mp4", "03.pdf", "03.png"}));
    EXPECT_NE(page.find("<h1>Deck</h1>"), std::string::npos);
    EXPECT_NE(page.find("1. One &lt;b&gt; &amp; two<"), std::string::npos) << page;
    EXPECT_EQ(page.find("<b>"), std::string::npos);
}

TEST_F(SlideDeck, ReplacesItsOwnDeckAndLeavesNoOldFile) {
    write("deck");
    std::string shorter = deck_scene;
    shorter.erase(shorter.find("[[stops]]\nat_s = 3.5"),
                  std::string("[[stops]]\nat_s = 3.5\nloop_s = 0.5\n").size());
    write_scene(shorter);
    // A folder that only looks like ours stays.
    fs::create_directory(folder_ / ".deck.old");
    write("deck/.");
    EXPECT_TRUE(fs::remove(folder_ / ".deck.old"));
    EXPECT_EQ(files_of(folder_ / "deck"),
              (std::set<std::string>{"01.mp4", "01.png", "01.pdf", "02.mp4", "02.png", "02.pdf",
                                     "02.vtt", "slides.json", "index.html"}));
    EXPECT_EQ(files_of(folder_.path()), (std::set<std::string>{"a.toml", "deck"}));
}

TEST_F(SlideDeck, RefusesAFolderThatHoldsOtherThings) {
    fs::create_directory(folder_ / "mine");
    std::ofstream(folder_ / "mine/01.png") << "mine";
    EXPECT_NE(refusal("mine").find("mine: holds other files, such as 01.png; name a new or an "
                                   "empty folder"),
              std::string::npos);
    EXPECT_EQ(read_text(folder_ / "mine/01.png"), "mine");
    EXPECT_NE(refusal("a.toml").find("exists and is not a folder"), std::string::npos);
    EXPECT_EQ(files_of(folder_.path()), (std::set<std::string>{"a.toml", "mine"}));

    fs::create_directory(folder_ / "empty");
    write("empty");
    EXPECT_EQ(files_of(folder_ / "empty"), deck_files);
    std::ofstream(folder_ / "empty/notes.txt") << "mine";
    EXPECT_NE(refusal("empty").find("such as notes.txt"), std::string::npos);
    fs::remove(folder_ / "empty/notes.txt");
    // Names that stand in slides.json, and folders with names of files.
    std::ofstream(folder_ / "empty/note") << "mine";
    EXPECT_NE(refusal("empty").find("such as note;"), std::string::npos);
    fs::remove(folder_ / "empty/note");
    for (const std::string name : {"pdf", "04.pdf"}) {
        fs::create_directory(folder_ / "empty" / name);
        EXPECT_NE(refusal("empty").find("such as " + name), std::string::npos);
        fs::remove(folder_ / "empty" / name);
    }
    fs::rename(folder_ / "a.toml", folder_ / "b.toml");
    const SceneRequest other = scene("b.toml");
    EXPECT_THROW(write_deck(open_session(other), {other, folder_ / "empty", 1}, *renderer_, {}),
                 InputError);
    EXPECT_EQ(files_of(folder_ / "empty"), deck_files);
}

// An interrupted run leaves the films that are complete in the hidden folder.
TEST_F(SlideDeck, ContinuesAnInterruptedRun) {
    write("deck");
    interrupt({"01.mp4", "02.mp4", "02-loop.mp4"});
    fs::remove(folder_ / ".deck.part/03.mp4");
    fs::remove(folder_ / ".deck.part/03.png");
    fs::remove(folder_ / ".deck.part/02.vtt");
    std::ofstream(folder_ / ".deck.part/.01.mp4.part.frames") << "rest";
    const auto written = fs::last_write_time(folder_ / ".deck.part/01.mp4");
    write("deck");
    EXPECT_EQ(files_of(folder_ / "deck"), deck_files);
    EXPECT_EQ(fs::last_write_time(folder_ / "deck/01.mp4"), written);

    // The films of another plan are drawn anew.
    interrupt({"01.mp4"});
    std::ofstream(folder_ / ".deck.part/slides.json") << any_slide_plan_head << "\"other\"";
    write("deck");
    EXPECT_EQ(files_of(folder_ / "deck"), deck_files);
    EXPECT_NE(fs::last_write_time(folder_ / "deck/01.mp4"), written);
    EXPECT_EQ(files_of(folder_.path()), (std::set<std::string>{"a.toml", "deck"}));
}

// What an interrupted run has left is used only as far as it has not changed since.
TEST_F(SlideDeck, DrawsDamagedFilmsOfAnInterruptedRunAgain) {
    write("deck");
    std::map<std::string, std::string> whole;
    for (const std::string& name : deck_files) whole[name] = read_text(folder_ / ("deck/" + name));
    std::string flipped = whole["02-loop.mp4"];
    flipped[flipped.size() / 2] = static_cast<char>(flipped[flipped.size() / 2] ^ 1);
    interrupt({"01.mp4", "02.mp4", "02-loop.mp4", "03.mp4"});
    for (const auto& [name, bytes] : std::map<std::string, std::string>{
             {"01.mp4", ""},
             {"02.mp4", whole["02.mp4"].substr(0, whole["02.mp4"].size() / 2)},
             {"02-loop.mp4", flipped},
             {"02.vtt", ""},
             {"01.png", "x"},
             {"01.pdf", ""}})
        std::ofstream(folder_ / (".deck.part/" + name), std::ios::binary) << bytes;
    const auto written = fs::last_write_time(folder_ / ".deck.part/03.mp4");
    // Links in the folder are not followed, either.
    std::ofstream(folder_ / "mine") << "mine";
    fs::remove(folder_ / ".deck.part/02.png");
    fs::create_symlink(folder_ / "mine", folder_ / ".deck.part/02.png");
    write("deck");
    EXPECT_EQ(files_of(folder_ / "deck"), deck_files);
    for (const std::string& name : deck_files)
        EXPECT_TRUE(read_text(folder_ / ("deck/" + name)) == whole[name]) << name;
    EXPECT_EQ(fs::last_write_time(folder_ / "deck/03.mp4"), written);
    EXPECT_EQ(read_text(folder_ / "mine"), "mine");

    // A list that is cut off, and films that are listed and missing.
    interrupt({"01.mp4", "02.mp4"});
    fs::resize_file(folder_ / ".deck.part/finished", 100);
    fs::remove(folder_ / ".deck.part/01.mp4");
    write("deck");
    EXPECT_TRUE(read_text(folder_ / "deck/01.mp4") == whole["01.mp4"]);
}

TEST_F(SlideDeck, RefusesALinkToNothingBeforeItDraws) {
    fs::create_symlink("nowhere", folder_ / "link");
    EXPECT_NE(refusal("link").find("link: is a link to a folder that does not exist; make this "
                                   "folder, or remove the link"),
              std::string::npos);
    EXPECT_EQ(files_of(folder_.path()), (std::set<std::string>{"a.toml", "link"}));
    EXPECT_NE(refusal(std::string(256, 'a')).find("the name is too long"), std::string::npos);

    fs::create_directory(folder_ / "nowhere");
    write("link");
    EXPECT_EQ(files_of(folder_ / "nowhere"), deck_files);
    EXPECT_EQ(files_of(folder_.path()), (std::set<std::string>{"a.toml", "link", "nowhere"}));
}

TEST_F(SlideDeck, ReportsALoopThatJumps) {
    std::vector<std::string> said;
    Task task;
    task.say = [&said](const std::string& line) { said.push_back(line); };
    const auto has_jump = [&](const std::string& loop) {
        said.clear();
        // It turns once in 2 s.
        write_scene(
            "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.5]\n[start]\nomega_rad_s = [0.0, 0.0, "
            "3.141592653589793]\n[film]\nsize = [192, 108]\nlength_s = "
            "4.0\n[[stops]]\nat_s = 3.5\nloop_s = " +
            loop + "\n");
        const Session session = open_session(scene());
        write_deck(session, {scene(), folder_ / "deck", 1}, *renderer_, task);
        return std::any_of(said.begin(), said.end(), [](const std::string& line) {
            return line.find("stops[0].loop_s: the tip of an arrow jumps") != std::string::npos;
        });
    };
    EXPECT_TRUE(has_jump("1.0"));
    EXPECT_FALSE(has_jump("2.0"));
}

}  // namespace
}  // namespace poinsot
