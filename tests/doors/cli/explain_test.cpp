// explain: records of pictures and films, and whether they match the file.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <utility>

#include "cli/program_run.h"
#include "cli/recorded_pictures.h"
#include "image/files/png_files.h"
#include "system/sha256.h"

namespace poinsot::testing {
namespace {

namespace fs = std::filesystem;

using ExplainedPictures = Pictures;

// Replaces words in a file by words of the same length.
void replace_in(const fs::path& file, const std::string& words, const std::string& others) {
    std::string bytes = text_of(file);
    const std::size_t at = bytes.find(words);
    ASSERT_NE(at, std::string::npos) << words;
    ASSERT_EQ(words.size(), others.size());
    std::ofstream(file, std::ios::binary) << bytes.replace(at, words.size(), others);
}

// Replaces the text of a PNG with correct checksums.
void retell(const fs::path& file, const std::function<void(std::string& text)>& change) {
    const StoredPicture picture = read_stored_png(file);
    PngOptions options;
    options.texts = picture.info.texts;
    change(options.texts["poinsot"]);
    write_png(file, picture.image, options);
}

void replace(std::string& text, const std::string& words, const std::string& others) {
    const std::size_t at = text.find(words);
    ASSERT_NE(at, std::string::npos) << words;
    text.replace(at, words.size(), others);
}

// Any accidental change of a record is detected.
TEST_F(ExplainedPictures, RefuseAChangedRecord) {
    draw("a.png", "--time 0.3");
    for (const auto& [words, others] : {std::pair{"size: 128x72", "size: 128x73"},
                                        {"profile: native", "profile: portable"},
                                        {"within 0.", "within 9."},
                                        {"mesa: ", "mesa: 9"},
                                        {"time_s: 0.3", "time_s: 0.4"},
                                        {"\n\n", "\nnew: field\n\n"},
                                        {"omega_rad_s = [0.01", "omega_rad_s = [0.02"}}) {
        fs::copy_file(folder_.path() / "a.png", folder_.path() / "new/a.png",
                      fs::copy_options::overwrite_existing);
        retell(folder_.path() / "new/a.png",
               [&, from = words, to = others](std::string& text) { replace(text, from, to); });
        for (const char* command : {"explain new/a.png", "rerender new/a.png -o b.png",
                                    "approve --results new --baselines ref a"}) {
            const ProgramRun refused = run(command);
            EXPECT_EQ(refused.code, 2) << words << ": " << command;
            EXPECT_TRUE(is_one_line(refused.err)) << refused.err;
        }
    }
    for (const char* film : {"a.mp4", "a.webm", "a.mov", "a.gif"}) {
        ASSERT_EQ(run(std::string("render scene.toml -q -o ") + film).code, 0);
        EXPECT_EQ(run(std::string("explain --verify ") + film).code, 0);
        replace_in(folder_.path() / film, "profile: native", "profile: nativE");
        EXPECT_EQ(run(std::string("explain ") + film).code, 2) << film;
    }
}

TEST_F(ExplainedPictures, VerifyTheirPixels) {
    draw("new/a.png", "--portable --time 0.3");
    draw("deep.png", "--time 0.3 --depth 16");
    for (const char* file : {"new/a.png", "deep.png"}) {
        const ProgramRun verified = run(std::string("explain --verify ") + file);
        EXPECT_EQ(verified.code, 0) << verified.err;
        EXPECT_TRUE(is_one_line(verified.err) &&
                    contains(verified.err, "unchanged, record and pictures"));
        EXPECT_EQ(run(std::string("explain ") + file).err, "");
    }
    // One pixel is changed, the record is not.
    StoredPicture picture = read_stored_png(folder_.path() / "new/a.png");
    picture.image.set(5, 5, {1, 2, 3, 255});
    PngOptions options;
    options.texts = picture.info.texts;
    write_png(folder_.path() / "new/a.png", picture.image, options);
    for (const char* command : {"explain new/a.png", "explain --verify new/a.png"}) {
        const ProgramRun changed = run(command);
        EXPECT_EQ(changed.code, 1) << command;
        EXPECT_TRUE(is_one_line(changed.err) &&
                    contains(changed.err, "pixels do not match its record"))
            << changed.err;
    }
    EXPECT_TRUE(contains(run("explain --json new/a.png").out, "\"verified\": \"no\""));
    // The JSON contains all values of the record.
    ASSERT_EQ(run("still scene.toml -q --shading none --text paths -o a.pdf").code, 0);
    for (const char* file : {"deep.png", "a.pdf"}) {
        const std::string told = run(std::string("explain ") + file).out;
        const std::string json = run(std::string("explain --json ") + file).out;
        std::istringstream lines(told.substr(0, told.find("\n\n")));
        std::string line;
        std::getline(lines, line);
        while (std::getline(lines, line)) {
            std::string key = line.substr(0, line.find(": "));
            std::replace(key.begin(), key.end(), '-', '_');
            if (key == "record_sha256") continue;  // of the text itself
            EXPECT_TRUE(contains(json, "\"" + key + "\": ")) << file << ": " << key;
        }
    }
    const ProgramRun refused = approve("a");
    EXPECT_EQ(refused.code, 2);
    EXPECT_TRUE(is_one_line(refused.err)) << refused.err;

    // A film's packets lie at its end.
    ASSERT_EQ(run("render scene.toml -q -o a.mp4").code, 0);
    std::string film = text_of(folder_.path() / "a.mp4");
    film[film.size() - 20] = static_cast<char>(film[film.size() - 20] ^ 1);
    std::ofstream(folder_.path() / "a.mp4", std::ios::binary) << film;
    EXPECT_EQ(run("explain a.mp4").code, 1);
}

// The film stands on its head: the matrix of its track is -1, 0, 0, -1.
TEST_F(ExplainedPictures, OfFilmsThatAreTurnedSayThatThePicturesAreUnchanged) {
    ASSERT_EQ(run("render scene.toml -q -o a.mp4").code, 0);
    std::string film = text_of(folder_.path() / "a.mp4");
    constexpr std::size_t matrix_at = 44;
    for (const std::size_t place : {0, 16})
        film.replace(film.find("tkhd") + matrix_at + place, 4, std::string("\xff\xff\0\0", 4));
    folder_.write("a.mp4", film);
    const ProgramRun verified = run("explain --verify a.mp4");
    EXPECT_EQ(verified.code, 1);
    EXPECT_TRUE(is_one_line(verified.err) &&
                contains(verified.err, "its coded pictures are unchanged") &&
                contains(verified.err, "it is shown turned or mirrored"))
        << verified.err;
}

// Files that hold films or scenes are not called broken films.
TEST_F(ExplainedPictures, AreNotPresentationsAndPages) {
    folder_.write("a.pptx", "PK");
    folder_.write("a.html", "<!doctype html>");
    for (const auto& [file, words] : {std::pair{"a.pptx", "each of its films has a record"},
                                      std::pair{"a.html", "is a page for browsers"}})
        for (const std::string command : {"explain ", "rerender -o b.mp4 "}) {
            const ProgramRun refused = run(command + file);
            EXPECT_EQ(refused.code, 2) << command << file;
            EXPECT_TRUE(is_one_line(refused.err) && contains(refused.err, words)) << refused.err;
        }
}

// Data that players, browsers and demuxers ignore is detected.
TEST_F(ExplainedPictures, WithBytesAppendedAreNotVerified) {
    for (const std::string name :
         {"a.png", "a.pdf", "a.svg", "a.mp4", "a.webm", "a.mov", "a.gif"}) {
        const bool is_still = name == "a.png" || name == "a.pdf" || name == "a.svg";
        ASSERT_EQ(
            run((is_still ? "still" : "render") + std::string(" scene.toml -q -o ") + name).code,
            0);
        ASSERT_EQ(run("explain --verify " + name).code, 0) << name;
        const std::string whole = text_of(folder_.path() / name);
        const std::string box("\0\0\0\x10mdatjunkjunk", 16), padding(
                                                                 "\0\0\0\x0c"
                                                                 "freejunk",
                                                                 12);
        for (const std::string& more :
             {std::string("x"), std::string("\n"), std::string(1000, '\0'), std::string("%%EOF\n"),
              box, padding, whole}) {
            folder_.write(name, whole + more);
            const ProgramRun verified = run("explain --verify " + name);
            EXPECT_EQ(verified.code, 1) << name << " with " << more.size() << " bytes behind it";
            EXPECT_TRUE(is_one_line(verified.err)) << verified.err;
            EXPECT_EQ(run("explain " + name).code, 1) << name;
        }
        folder_.write(name, whole);
        EXPECT_EQ(run("explain --verify " + name).code, 0) << name;
    }
    // Such a picture is neither accepted as a baseline nor kept as a frame by another run.
    draw("new/a.png", "--portable --time 0.3");
    std::ofstream(folder_.path() / "new/a.png", std::ios::binary | std::ios::app) << "junk";
    EXPECT_EQ(approve("a").code, 2);
    ASSERT_EQ(run("render scene.toml -q --frames 2-4 -o f_##.png").code, 0);
    const std::string third = text_of(folder_.path() / "f_03.png");
    std::ofstream(folder_.path() / "f_03.png", std::ios::binary | std::ios::app) << "junk";
    ASSERT_EQ(run("render scene.toml -q --frames 2-4 -o f_##.png").code, 0);
    EXPECT_TRUE(text_of(folder_.path() / "f_03.png") == third);
}

// Writes a record with another scene and matching hashes, as a program with that defect would.
void write_with_scene(const fs::path& file, const std::string& words, const std::string& others) {
    retell(file, [&](std::string& text) {
        replace(text, words, others);
        const auto set = [&text](const std::string& key, const std::string& value) {
            const std::size_t at = text.find("\n" + key + ": ") + 1;
            text.replace(at, text.find('\n', at) - at, key + ": " + value);
        };
        set("scene-sha256", sha256_of(text.substr(text.find("\n\n") + 2)));
        const std::size_t seal = text.find("\nrecord-sha256: ") + 1;
        std::string rest = text;
        rest.erase(seal, text.find('\n', seal) + 1 - seal);
        set("record-sha256", sha256_of(rest));
    });
}

// A record from which nothing can be rendered is reported, and its picture is no baseline.
TEST_F(ExplainedPictures, ReportWhyTheyCannotBeRerendered) {
    struct Case {
        std::string words, others, why;
        bool is_scene;
    };
    for (const Case& one :
         {Case{"\n[body]", "\n[]\n[body]", "its scene cannot be read again: scene.toml:", false},
          Case{"\n[body]", "\n[later]\nmood = 1\n\n[body]", "unknown table \"later\"", false},
          Case{"theme = \"light\"", "theme = \"neon\"", "neon", true},
          Case{"quality = \"lecture\"", "quality = \"finest\"", "finest", true}}) {
        draw("new/a.png", "--portable --time 0.3");
        write_with_scene(folder_.path() / "new/a.png", one.words, one.others);
        EXPECT_EQ(run("explain new/a.png").code, 0) << one.others;
        const ProgramRun asked = run("explain --verify new/a.png");
        EXPECT_EQ(asked.code, 1) << one.others;
        EXPECT_TRUE(is_one_line(asked.err) && contains(asked.err, "cannot be drawn again here") &&
                    contains(asked.err, one.why))
            << asked.err;
        const ProgramRun json = run("explain --verify --json new/a.png");
        EXPECT_TRUE(contains(json.out, "\"can_be_drawn_again\": \"no\"")) << json.out;
        EXPECT_EQ(run("rerender new/a.png -o b.png").code, 2) << one.others;
        const ProgramRun approved = approve("a");
        EXPECT_EQ(approved.code, one.is_scene ? 0 : 2) << one.others << approved.err;
        EXPECT_EQ(contains(approved.err, "cannot be read again"), !one.is_scene) << approved.err;
        fs::remove_all(folder_.path() / "ref");
    }
    EXPECT_TRUE(contains(run("explain --json --verify new/a.png").out, "\"why_not\": "));
}

// The files of a scene belong to it.
TEST_F(ExplainedPictures, ReportAMissingFileOfTheirScene) {
    folder_.write("wedge.obj",
                  "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 3 2\n"
                  "f 4 5 6\nf 1 2 5 4\nf 2 3 6 5\nf 3 1 4 6\n");
    folder_.write("scene.toml",
                  "[body]\nmesh = \"wedge.obj\"\ndensity_kg_m3 = 1.0\n[start]\nomega_rad_s = "
                  "[0.5, 2.0, 0.1]\n[film]\nsize = [128, 72]\n");
    draw("new/a.png", "--portable");
    EXPECT_EQ(run("explain --verify new/a.png").code, 0);
    fs::rename(folder_.path() / "wedge.obj", folder_.path() / "new/wedge.obj");
    const ProgramRun missing = run("explain --verify new/a.png");
    EXPECT_EQ(missing.code, 1);
    EXPECT_TRUE(is_one_line(missing.err) && contains(missing.err, "wedge.obj")) << missing.err;
    // The picture itself is unchanged.
    EXPECT_EQ(approve("a").code, 0);
    folder_.write("wedge.obj",
                  "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nv 2 0 1\nv 0 1 1\nf 1 3 2\n"
                  "f 4 5 6\nf 1 2 5 4\nf 2 3 6 5\nf 3 1 4 6\n");
    const ProgramRun other = run("explain --verify new/a.png");
    EXPECT_EQ(other.code, 1);
    EXPECT_TRUE(contains(other.err, "wedge.obj has changed since the file was drawn")) << other.err;
}

// A picture of an older poinsot is explained and rendered again; verification is impossible, which
// is neither success nor failure.
TEST_F(ExplainedPictures, WithoutAHashCannotBeVerified) {
    draw("new/a.png", "--portable --time 0.3");
    retell(folder_.path() / "new/a.png", [](std::string& text) {
        const std::size_t from = text.find("pixels-xxh64: ");
        text.erase(from, text.find("\n\n") + 1 - from);
    });
    const ProgramRun explained = run("explain new/a.png");
    EXPECT_EQ(explained.code, 0);
    EXPECT_EQ(explained.err, "");
    const ProgramRun asked = run("explain --verify new/a.png");
    EXPECT_EQ(asked.code, 1);
    EXPECT_TRUE(is_one_line(asked.err) && contains(asked.err, "cannot be verified")) << asked.err;
    EXPECT_EQ(run("rerender -q new/a.png -o b.png").code, 0);
    const ProgramRun approved = approve("a");
    EXPECT_EQ(approved.code, 0);
    EXPECT_TRUE(is_one_line(approved.err) && contains(approved.err, "cannot be verified"));
}

// A record with impossible numbers is always refused; a field of a later version is accepted.
TEST_F(ExplainedPictures, RefuseRecordsWithImpossibleFrames) {
    ASSERT_EQ(run("render scene.toml -q --frames 2-9 -o f_##.png").code, 0);
    const auto with = [this](const std::string& lines) {
        fs::copy_file(folder_.path() / "f_03.png", folder_.path() / "x.png",
                      fs::copy_options::overwrite_existing);
        retell(folder_.path() / "x.png", [&lines](std::string& text) {
            const std::size_t from = text.find("frames: ");
            text.replace(from, text.find("\n\n") + 1 - from, lines);
        });
        return run("explain x.png");
    };
    for (const char* lines :
         {"frames: 9-2\n", "frames: -1-2\n", "frames: 0-9223372036854775807\n",
          "frames: 2-9\nrun: 3-9\n", "frames: 2-9\nrun: 2-8\n", "frames: 2-9\nframe: 1\n",
          "frames: 2-9\nframe: 1e300\n", "frames: 2-9\ndepth: 1e300\n", "time_s: 1\nframe: 1\n"}) {
        const ProgramRun refused = with(lines);
        EXPECT_EQ(refused.code, 2) << lines;
        EXPECT_TRUE(is_one_line(refused.err)) << refused.err;
    }
    const ProgramRun later = with("frames: 2-9\nmood: good\n");
    EXPECT_EQ(later.code, 0);
    EXPECT_EQ(said(later.out, "mood"), "good");
}

TEST_F(ExplainedPictures, OfASequenceRecordTheirFrameNumbers) {
    ASSERT_EQ(run("render scene.toml -q --frames 2-9 -o f_##.png").code, 0);
    const std::string third = text_of(folder_.path() / "f_03.png");
    fs::rename(folder_.path() / "f_03.png", folder_.path() / "x.png");
    fs::rename(folder_.path() / "f_04.png", folder_.path() / "f_03.png");
    fs::rename(folder_.path() / "x.png", folder_.path() / "f_04.png");
    const ProgramRun renamed = run("explain f_03.png");
    EXPECT_EQ(said(renamed.out, "frame"), "4");
    EXPECT_TRUE(is_one_line(renamed.err) && contains(renamed.err, "its record says frame 4"))
        << renamed.err;
    // Rendered again as a frame.
    ASSERT_EQ(run("rerender -q f_04.png -o again.png").code, 0);
    EXPECT_TRUE(text_of(folder_.path() / "again.png") == third);
    ASSERT_EQ(run("render scene.toml -q --frames 2-9 -o f_##.png").code, 0);
    EXPECT_TRUE(text_of(folder_.path() / "f_03.png") == third);

    const ProgramRun shorter = run("render scene.toml --frames 2-5 -o f_##.png");
    EXPECT_EQ(shorter.code, 0);
    EXPECT_TRUE(
        contains(shorter.err, "4 frames of another run in the same folder: f_06.png to f_09.png"))
        << shorter.err;
}

}  // namespace
}  // namespace poinsot::testing
