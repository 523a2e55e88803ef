// Records, comparison and baselines detect changed pictures and accept unchanged ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <utility>

#include "cli/program_run.h"
#include "image/files/png_bands.h"
#include "image/files/png_files.h"
#include "places.h"
#include "system/sha256.h"

namespace poinsot::testing::trust_tests {
namespace {

namespace fs = std::filesystem;

const std::string racket = R"(
title = "Racket"
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.01, 2.0, 0.01]
[film]
size = [128, 72]
duration_s = 0.5
)";

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

bool is_one_line(const std::string& text) {
    return !text.empty() && std::count(text.begin(), text.end(), '\n') == 1;
}

// Returns the value of a key in the record of a file.
std::string said(const std::string& explained, const std::string& key) {
    const std::size_t at = explained.find("\n" + key + ": ");
    if (at == std::string::npos) return "";
    const std::size_t from = at + key.size() + 3;
    return explained.substr(from, explained.find('\n', from) - from);
}

class Pictures : public ::testing::Test {
 protected:
    Pictures() {
        folder_.write("scene.toml", racket);
        for (const char* name : {"ref", "new"}) fs::create_directory(folder_.path() / name);
    }

    ProgramRun run(const std::string& arguments) const {
        return run_program_in(folder_, arguments);
    }
    // Renders a picture of the scene, and the same again from its record.
    void draw(const std::string& file, const std::string& options) const {
        const ProgramRun drawn = run("still scene.toml -q -o " + file + " " + options);
        ASSERT_EQ(drawn.code, 0) << drawn.err;
    }
    ProgramRun approve(const std::string& arguments) const {
        return run("approve --results new --baselines ref " + arguments);
    }

    ScratchFolder folder_;
};

TEST_F(Pictures, HaveRecordsAndAreRerendered) {
    struct Case {
        std::string name, command, profile;
    };
    for (const auto& [name, command, profile] :
         {Case{"a.png", "still scene.toml --time 0.3 --portable", "portable"},
          Case{"n.png", "still scene.toml --time 0.3", "native"},
          Case{"a.mp4", "render scene.toml", "native"},
          Case{"a.webm", "render scene.toml --portable", "portable"},
          Case{"a.gif", "render scene.toml --frames 2-5", "native"},
          Case{"a_####.png", "render scene.toml --portable", "portable"}}) {
        ASSERT_EQ(run(command + " -q -o " + name).code, 0) << name;
        const std::string file = name == "a_####.png" ? "a_0007.png" : name;
        const std::string explained = run("explain " + file).out;
        EXPECT_EQ(said(explained, "scene"), "scene");
        EXPECT_EQ(said(explained, "scene-sha256").size(), 64u);
        EXPECT_EQ(said(explained, "method"), "exact");
        EXPECT_TRUE(contains(said(explained, "bounds"), "px"));
        EXPECT_TRUE(contains(said(explained, "renderer"), "llvmpipe"));
        EXPECT_FALSE(said(explained, "mesa").empty());
        EXPECT_EQ(said(explained, "profile"), profile);
        EXPECT_TRUE(contains(explained, "omega_rad_s = [0.01, 2.0, 0.01]")) << explained;
        const std::string again = "again_0007" + fs::path(file).extension().string();
        ASSERT_EQ(run("rerender -q " + file + " -o " + again).code, 0) << file;
        EXPECT_TRUE(text_of(folder_.path() / file) == text_of(folder_.path() / again)) << file;
        fs::remove(folder_.path() / again);
    }
}

// A theme file is read once: the record contains its values.
TEST_F(Pictures, WithAUsersThemeAreRerenderedWithoutItsFile) {
    folder_.write("mine.toml", "extends = \"dark\"\nomega = \"#ff5050 1.5 dashed\"\n");
    ASSERT_EQ(run("still scene.toml -q --theme mine.toml -o a.png").code, 0);
    ASSERT_EQ(run("render scene.toml -q --theme mine.toml --jobs 2 -o a.mp4").code, 0);
    ASSERT_EQ(run("still scene.toml -q --theme dark -o dark.png").code, 0);
    EXPECT_FALSE(text_of(folder_.path() / "a.png") == text_of(folder_.path() / "dark.png"));
    fs::remove(folder_.path() / "mine.toml");
    for (const std::string suffix : {".png", ".mp4"}) {
        EXPECT_TRUE(contains(run("explain a" + suffix).out, "omega = \"#ff5050 1.5 dashed\""));
        ASSERT_EQ(run("rerender -q a" + suffix + " -o again" + suffix).code, 0);
        EXPECT_TRUE(text_of(folder_.path() / ("a" + suffix)) ==
                    text_of(folder_.path() / ("again" + suffix)))
            << suffix;
    }
}

// A picture on a face belongs to the scene: if its file has changed, the output is not rendered
// again.
TEST_F(Pictures, WithAPictureOnAFaceNeedTheSamePictureToBeRerendered) {
    const auto cover = [this](std::uint8_t green) {
        Image image(2, 2);
        for (const int k : {0, 1, 2, 3}) image.set(k / 2, k % 2, {200, green, 40, 255});
        write_png(folder_.path() / "cover.png", image);
    };
    cover(30);
    folder_.write("scene.toml", racket +
                                    "[[object.pictures]]\nface = \"+e3\"\nfile = \"cover.png\"\n"
                                    "[[panels]]\nkind = \"object\"\n");
    for (const std::string file : {"a.png", "a.pdf"}) {
        const std::string size = file == "a.pdf" ? " --width-mm 120" : "";
        ASSERT_EQ(run("still scene.toml -q -o " + file + size).code, 0);
        ASSERT_EQ(run("rerender -q " + file + " -o again_" + file).code, 0);
        EXPECT_TRUE(text_of(folder_.path() / file) == text_of(folder_.path() / ("again_" + file)));
    }
    cover(31);
    const ProgramRun changed = run("rerender a.png -o b.png");
    EXPECT_EQ(changed.code, 2);
    EXPECT_EQ(
        changed.err,
        "a.png: cover.png has changed since the file was drawn; restore the earlier version\n");
    EXPECT_FALSE(fs::exists(folder_.path() / "b.png"));
    cover(30);
    EXPECT_EQ(run("rerender -q a.png -o b.png").code, 0);
}

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
TEST_F(Pictures, RefuseAChangedRecord) {
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
    for (const char* film : {"a.mp4", "a.webm", "a.gif"}) {
        ASSERT_EQ(run(std::string("render scene.toml -q -o ") + film).code, 0);
        EXPECT_EQ(run(std::string("explain --verify ") + film).code, 0);
        replace_in(folder_.path() / film, "profile: native", "profile: nativE");
        EXPECT_EQ(run(std::string("explain ") + film).code, 2) << film;
    }
}

TEST_F(Pictures, VerifyTheirPixels) {
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

// Data that players, browsers and demuxers ignore is detected.
TEST_F(Pictures, WithBytesAppendedAreNotVerified) {
    for (const std::string name : {"a.png", "a.pdf", "a.svg", "a.mp4", "a.webm", "a.gif"}) {
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

const std::string with_symbols = R"(
title = "Renamed"
show = ["plane", "ellipsoid", "omega"]
labels = true
unlabelled = ["omega"]
[symbols]
omega = '\Omega'
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.01, 2.0, 0.01]
[film]
size = [128, 72]
length_s = 0.5
[[chapters]]
at_s = 0.0
title = "First"
[[chapters]]
at_s = 0.2
title = "Second"
)";

// Symbols are a table, and keys without a table were once written after them.
TEST_F(Pictures, OfScenesWithSymbolsAreRerendered) {
    folder_.write("scene.toml", with_symbols);
    for (const std::string name : {"a.png", "a.pdf", "a.svg", "a.mp4", "a_##.png"}) {
        const bool is_film = name == "a.mp4" || name == "a_##.png";
        const std::string file = name == "a_##.png" ? "a_07.png" : name;
        const std::string again = "again_07" + fs::path(file).extension().string();
        ASSERT_EQ(
            run((is_film ? "render" : "still") + std::string(" scene.toml -q -o ") + name).code, 0);
        const ProgramRun verified = run("explain --verify " + file);
        EXPECT_EQ(verified.code, 0) << verified.err;
        EXPECT_TRUE(is_one_line(verified.err) && contains(verified.err, "can be drawn again here"));
        const ProgramRun drawn = run("rerender -q " + file + " -o " + again);
        ASSERT_EQ(drawn.code, 0) << drawn.err;
        EXPECT_TRUE(text_of(folder_.path() / file) == text_of(folder_.path() / again)) << file;
        fs::remove(folder_.path() / again);
    }
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
TEST_F(Pictures, ReportWhyTheyCannotBeRerendered) {
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
TEST_F(Pictures, ReportAMissingFileOfTheirScene) {
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
TEST_F(Pictures, WithoutAHashCannotBeVerified) {
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
TEST_F(Pictures, RefuseRecordsWithImpossibleFrames) {
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

TEST_F(Pictures, OfASequenceRecordTheirFrameNumbers) {
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

TEST_F(Pictures, ComparedReportTheirDifferences) {
    draw("a.png", "--portable --time 0.1");
    draw("b.png", "--portable --time 0.11");
    draw("c.png", "--portable --time 0.1 --size 130x72");
    EXPECT_EQ(run("compare a.png a.png").code, 0);
    const ProgramRun pixels = run("compare a.png b.png --diff d.png");
    EXPECT_EQ(pixels.code, 1);
    EXPECT_TRUE(contains(pixels.out, "pixels: b: ")) << pixels.out;
    EXPECT_EQ(pixels.err, "");
    // Expected, difference and actual side by side.
    EXPECT_GE(read_png(folder_.path() / "d.png").width(), 3 * 128);
    const ProgramRun size = run("compare a.png c.png");
    EXPECT_EQ(size.code, 1);
    EXPECT_TRUE(contains(size.out, "size: c: ")) << size.out;
    const ProgramRun missing = run("compare a.png none.png");
    EXPECT_EQ(missing.code, 1);
    EXPECT_TRUE(contains(missing.out, "missing: none: ")) << missing.out;
    folder_.write("broken.png", text_of(folder_.path() / "a.png").substr(0, 500));
    const ProgramRun broken = run("compare a.png broken.png");
    EXPECT_EQ(broken.code, 2);
    EXPECT_TRUE(is_one_line(broken.err)) << broken.err;
}

TEST_F(Pictures, ComparedAreNotOverwritten) {
    draw("a.png", "--portable --time 0.1");
    draw("b.png", "--portable --time 0.11");
    fs::create_symlink("a.png", folder_.path() / "link.png");
    const std::string before = text_of(folder_.path() / "a.png");
    for (const char* options :
         {"--diff a.png", "--diff ./b.png", "--diff link.png", "--report a.png", "--junit b.png",
          "--diff d.png --report d.png", "--report x.html --junit ./x.html"}) {
        const ProgramRun run_of = run(std::string("compare a.png b.png ") + options);
        EXPECT_EQ(run_of.code, 2) << options;
        EXPECT_TRUE(is_one_line(run_of.err)) << run_of.err;
        EXPECT_TRUE(text_of(folder_.path() / "a.png") == before) << options;
        EXPECT_FALSE(fs::exists(folder_.path() / "d.png")) << options;
    }
}

// File suffixes are case-insensitive.
TEST_F(Pictures, WithSuffixesInCapitalsAreCompared) {
    draw("ref/a.png", "--portable --time 0.1");
    fs::rename(folder_.path() / "ref/a.png", folder_.path() / "ref/a.PNG");
    draw("new/a.png", "--portable --time 0.3");
    fs::copy(folder_.path() / "ref/a.PNG", folder_.path() / "new/b.Png");
    const ProgramRun compared = run("compare ref new");
    EXPECT_EQ(compared.code, 1);
    EXPECT_TRUE(contains(compared.out, "pixels: a: ")) << compared.out;
    EXPECT_TRUE(contains(compared.out, "unexpected: b: ")) << compared.out;
}

TEST_F(Pictures, WithSuffixesInCapitalsWorkInEveryCommand) {
    draw("ref/a.PNG", "--portable --time 0.1");
    draw("new/a.PNG", "--portable --time 0.1");
    EXPECT_EQ(run("compare ref/a.PNG new/a.PNG").code, 0);
    EXPECT_EQ(run("compare ref/a.PNG new/a.PNG --diff d.PNG").code, 0);
    EXPECT_TRUE(fs::exists(folder_.path() / "d.PNG"));
    const ProgramRun explained = run("explain new/a.PNG --verify");
    EXPECT_EQ(explained.code, 0) << explained.err << explained.out;
    EXPECT_EQ(run("rerender new/a.PNG -o again.Png -q").code, 0);
    EXPECT_TRUE(text_of(folder_.path() / "again.Png") == text_of(folder_.path() / "new/a.PNG"));
    fs::remove_all(folder_.path() / "ref");
    EXPECT_EQ(approve("a.PNG").out, "a: new\n");
    EXPECT_EQ(approve("a").out, "a: unchanged\n");
    EXPECT_EQ(run("compare ref new").code, 0);

    for (const char* film : {"f.MP4", "f.WebM", "f.GIF"}) {
        const std::string name = film;
        const ProgramRun made = run("render scene.toml --frames 0-2 --portable -q -o " + name);
        EXPECT_EQ(made.code, 0) << made.err;
        EXPECT_EQ(run("explain --verify " + name).code, 0) << name;
        EXPECT_EQ(run("rerender -q -o again_" + name + " " + name).code, 0) << name;
        EXPECT_TRUE(text_of(folder_.path() / name) == text_of(folder_.path() / ("again_" + name)));
    }
    EXPECT_EQ(run("render scene.toml --frames 0-2 --portable -q -o 's_##.PNG'").code, 0);
    EXPECT_EQ(run("explain --verify s_02.PNG").code, 0);
    EXPECT_EQ(run("rerender s_02.PNG -q -o again_02.PNG").code, 0);
    EXPECT_TRUE(text_of(folder_.path() / "s_02.PNG") == text_of(folder_.path() / "again_02.PNG"));
}

TEST_F(Pictures, InFoldersAreComparedInOnePass) {
    draw("ref/same.png", "--portable --time 0.1");
    fs::copy(folder_.path() / "ref/same.png", folder_.path() / "new/same.png");
    fs::copy(folder_.path() / "ref/same.png", folder_.path() / "ref/gone.png");
    fs::copy(folder_.path() / "ref/same.png", folder_.path() / "ref/turned.png");
    draw("new/turned.png", "--portable --time 0.3");
    const ProgramRun compared = run("compare ref new --json --report page.html --junit tests.xml");
    EXPECT_EQ(compared.code, 1);
    // The worst is first, in the JSON, the page and the test results.
    for (const std::string& text : {compared.out, text_of(folder_.path() / "page.html"),
                                    text_of(folder_.path() / "tests.xml")})
        EXPECT_LT(text.find("gone"), text.find("turned"));
    const std::string xml = text_of(folder_.path() / "tests.xml");
    EXPECT_TRUE(contains(xml, R"(tests="3" failures="2" errors="0")")) << xml;
}

// Another processor may draw a native picture otherwise, so that is said where it may be all that
// there is: the same scene and instant, and no more than a few levels of a few pixels.
TEST_F(Pictures, ComparedWithoutPortableAreTold) {
    draw("a.png", "--time 0.1");
    draw("b.png", "--time 0.3");
    PngInfo info;
    Image rounded = read_png(folder_.path() / "a.png", &info);
    Rgba8 pixel = rounded.at(5, 5);
    pixel.g = static_cast<std::uint8_t>(pixel.g > 0 ? pixel.g - 1 : 1);
    rounded.set(5, 5, pixel);
    write_png(folder_.path() / "rounded.png", rounded, {.texts = info.texts});
    const ProgramRun told = run("compare a.png rounded.png");
    EXPECT_EQ(told.code, 1);
    EXPECT_TRUE(is_one_line(told.err) && contains(told.err, "--portable")) << told.err;
    EXPECT_TRUE(
        contains(told.err, "note: 1 pair differs by no more than the rounding of two processors"))
        << told.err;
    EXPECT_EQ(run("compare a.png rounded.png --quiet").err, "");
    EXPECT_EQ(run("compare a.png rounded.png --profile native").err, "");
    EXPECT_EQ(run("compare a.png a.png").err, "");
    // 0.07/100 in doubles would be 0.0007000000000000001.
    const ProgramRun capped = run("compare a.png a.png --json --max-differing 0.07%");
    EXPECT_TRUE(contains(capped.out, "\"differing_share\": 0.0007,")) << capped.out;
    // Another instant, or another theme, is no rounding.
    EXPECT_EQ(run("compare a.png b.png").err, "");
    draw("dark.png", "--time 0.1 --set theme=dark");
    EXPECT_EQ(run("compare a.png dark.png").err, "");
}

TEST_F(Pictures, MeasureLikenessWhenAsked) {
    draw("a.png", "--portable --time 0.1");
    draw("b.png", "--portable --time 0.3");
    EXPECT_TRUE(contains(run("compare a.png b.png --json").out, "\"flip\": null"));
    EXPECT_FALSE(contains(run("compare a.png b.png").out, "FLIP"));
    const ProgramRun measured = run("compare a.png b.png --measures");
    EXPECT_TRUE(contains(measured.out, "FLIP") && contains(measured.out, "SSIM")) << measured.out;
    EXPECT_FALSE(contains(run("compare a.png b.png --measures --json").out, "\"flip\": null"));
}

TEST_F(Pictures, AreBaselinesOnlyIfPortable) {
    draw("new/a.png", "--time 0.1");
    const ProgramRun refused = approve("a");
    EXPECT_EQ(refused.code, 2);
    EXPECT_TRUE(is_one_line(refused.err) && contains(refused.err, "--portable")) << refused.err;
    EXPECT_FALSE(fs::exists(folder_.path() / "ref/a.png"));
    EXPECT_EQ(approve("a --any-renderer").code, 0);
    EXPECT_TRUE(fs::exists(folder_.path() / "ref/a.png"));
}

TEST_F(Pictures, AreApprovedWithHashesRendererAndReason) {
    draw("new/a.png", "--portable --time 0.1");
    ASSERT_EQ(approve("a").code, 0);
    const std::string manifest = text_of(folder_.path() / "ref/manifest.toml");
    const std::string explained = run("explain new/a.png").out;
    EXPECT_TRUE(contains(manifest, said(explained, "scene-sha256")));
    EXPECT_TRUE(contains(manifest, said(explained, "renderer")));
    EXPECT_TRUE(contains(manifest, "mesa = \"" + said(explained, "mesa") + "\""));
    EXPECT_TRUE(text_of(folder_.path() / "ref/a.png") == text_of(folder_.path() / "new/a.png"));
    EXPECT_EQ(approve("a").out, "a: unchanged\n");

    // A changed picture needs a reason; without one, no file is changed.
    draw("new/a.png", "--portable --time 0.2");
    const ProgramRun why = approve("a");
    EXPECT_EQ(why.code, 2);
    EXPECT_TRUE(is_one_line(why.err) && contains(why.err, "--why")) << why.err;
    EXPECT_EQ(text_of(folder_.path() / "ref/manifest.toml"), manifest);
    EXPECT_EQ(approve("a --why 'later'").code, 0);
    EXPECT_TRUE(contains(text_of(folder_.path() / "ref/manifest.toml"), "why = \"later\""));
    EXPECT_EQ(run("compare ref new").code, 0);
}

TEST_F(Pictures, OfAnotherRendererNeedAnOption) {
    draw("new/a.png", "--portable --time 0.1");
    draw("new/b.png", "--portable --time 0.2");
    ASSERT_EQ(approve("a").code, 0);
    std::string manifest = text_of(folder_.path() / "ref/manifest.toml");
    const std::string mesa = "mesa = \"";
    manifest.insert(manifest.find(mesa) + mesa.size(), "9");
    folder_.write("ref/manifest.toml", manifest);
    const ProgramRun refused = approve("b");
    EXPECT_EQ(refused.code, 2);
    EXPECT_TRUE(is_one_line(refused.err) && contains(refused.err, "--any-renderer")) << refused.err;
    EXPECT_EQ(approve("b --any-renderer").code, 0);
}

// Two pictures that differ with 16 bits and are equal with 8 bits.
TEST_F(Pictures, OfSixteenBitsAreComparedExactly) {
    draw("new/a.png", "--portable --time 0.1 --depth 16");
    ASSERT_EQ(approve("a").code, 0);
    StoredPicture picture = read_stored_png(folder_.path() / "new/a.png");
    for (std::uint16_t& sample : picture.deep.samples())
        if (sample % 257 == 0 && sample != 65535) ++sample;
    PngOptions options;
    options.texts = picture.info.texts;
    PngBandWriter writer(folder_.path() / "new/a.png", picture.deep.width(), picture.deep.height(),
                         true, options, 16);
    writer.write(picture.deep);
    writer.finish();
    ASSERT_TRUE(read_png(folder_.path() / "new/a.png") == picture.image);
    const ProgramRun compared = run("compare ref new");
    EXPECT_EQ(compared.code, 1);
    EXPECT_TRUE(contains(compared.out, "pixels: a: ")) << compared.out;
    EXPECT_NE(approve("a").out, "a: unchanged\n");

    draw("new/a.png", "--portable --time 0.1");
    const ProgramRun shallow = run("compare ref new --profile native");
    EXPECT_EQ(shallow.code, 1);
    EXPECT_TRUE(contains(shallow.out, "depth: a: expected 16 bits per component, found 8"))
        << shallow.out;
}

// compare reports a baseline that is not the approved picture, and approve restores it.
TEST_F(Pictures, ThatDoNotMatchTheManifestAreReported) {
    draw("new/a.png", "--portable --time 0.1");
    ASSERT_EQ(approve("a").code, 0);
    draw("ref/a.png", "--portable --time 0.2");
    for (const char* both : {"ref new", "ref/a.png new/a.png"}) {
        const ProgramRun compared = run(std::string("compare ") + both);
        EXPECT_EQ(compared.code, 1);
        EXPECT_TRUE(contains(compared.out, "baseline: a: ")) << compared.out;
    }
    const ProgramRun back = approve("a");
    EXPECT_EQ(back.code, 0) << back.err;
    EXPECT_TRUE(contains(back.out, "a: restored; the baseline did not match the manifest"))
        << back.out;
    EXPECT_EQ(run("compare ref new").code, 0);
    EXPECT_EQ(approve("a").out, "a: unchanged\n");
}

TEST_F(Pictures, ApprovedConcurrentlyAllHaveTheirLines) {
    for (const char* name : {"a", "b", "c", "d"})
        draw(std::string("new/") + name + ".png", "--portable --time 0.1");
    const std::string approve =
        "'" + program_path() + "' approve -q --results new --baselines ref ";
    const std::string both =
        "cd '" + folder_.path().string() + "' && (" + approve + "a b & " + approve + "c d & wait)";
    ASSERT_EQ(std::system(both.c_str()), 0);
    EXPECT_EQ(run("compare ref new").out, "4 compared, 0 failed, 4 the same\n");
}

TEST_F(Pictures, StayInTheirFolder) {
    draw("a.png", "--portable --time 0.1");
    for (const char* name : {"../a", "/etc/passwd", "b/../../a"}) {
        const ProgramRun refused = approve(name);
        EXPECT_EQ(refused.code, 2) << name;
        EXPECT_TRUE(is_one_line(refused.err)) << refused.err;
    }
    EXPECT_FALSE(fs::exists(folder_.path() / "ref/manifest.toml"));
}

// A tetrahedron whose first corner has a variable distance.
std::string tetrahedron(double x_m) {
    return "v " + std::to_string(x_m) +
           " 0 0\nv 0 1 0\nv 0 0 2\nv 0 0 0\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";
}

// The scene's text does not change when the content of its mesh file does; the meaning of the scene
// does.
TEST_F(Pictures, DetectAChangedMesh) {
    folder_.write("part.obj", tetrahedron(1.0));
    folder_.write("scene.toml",
                  "title = \"Part\"\n[body]\nmesh = \"part.obj\"\nmass_kg = 1.0\n[start]\n"
                  "omega_rad_s = [0.1, 2.0, 0.1]\n[film]\nsize = [96, 54]\nduration_s = 0.5\n");
    draw("a.png", "--portable --time 0.1");
    const std::string film = "render scene.toml -q --portable -o f_##.png";
    ASSERT_EQ(run(film).code, 0);
    EXPECT_EQ(run("rerender -q a.png -o b.png").code, 0);
    EXPECT_TRUE(text_of(folder_.path() / "a.png") == text_of(folder_.path() / "b.png"));
    const std::string hash = said(run("explain a.png").out, "scene-sha256");
    const std::string frame = text_of(folder_.path() / "f_03.png");

    folder_.write("part.obj", tetrahedron(1.5));
    const ProgramRun refused = run("rerender -q a.png -o c.png");
    EXPECT_EQ(refused.code, 2);
    EXPECT_TRUE(is_one_line(refused.err) && contains(refused.err, "part.obj")) << refused.err;
    EXPECT_FALSE(fs::exists(folder_.path() / "c.png"));
    draw("a.png", "--portable --time 0.1");
    EXPECT_NE(said(run("explain a.png").out, "scene-sha256"), hash);
    // An existing sequence is not continued, but rendered again.
    ASSERT_EQ(run(film).code, 0);
    EXPECT_FALSE(text_of(folder_.path() / "f_03.png") == frame);
}

TEST_F(Pictures, RefusedLeaveNoEmptyFolder) {
    for (const std::string options : {"--size 65x49", "--frames 0-99999"}) {
        EXPECT_EQ(run("render scene.toml " + options).code, 2) << options;
        EXPECT_FALSE(fs::exists(folder_.path() / "output")) << options;
    }
    EXPECT_EQ(run("still scene.toml --depth 9").code, 2);
    EXPECT_FALSE(fs::exists(folder_.path() / "output"));
    // An existing folder is kept.
    fs::create_directory(folder_.path() / "output");
    EXPECT_EQ(run("render scene.toml --size 65x49").code, 2);
    EXPECT_TRUE(fs::exists(folder_.path() / "output"));
    EXPECT_EQ(run("render scene.toml -q").code, 0);
    EXPECT_TRUE(fs::exists(folder_.path() / "output/scene.mp4"));
}

}  // namespace
}  // namespace poinsot::testing::trust_tests
