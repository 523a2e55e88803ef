// Films and stills without a command line: input is a session and a request, output is files and
// messages.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "error/error.h"
#include "image/files/png_files.h"
#include "image/pixels_sha256.h"
#include "image/png.h"
#include "production/films/film_job.h"
#include "production/films/redraw.h"
#include "production/records/record.h"
#include "production/stills/prepared_still.h"
#include "scene/files/load_scene.h"
#include "system/faults.h"
#include "system/files/file_contents.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

Session small_session() {
    return session_of(
        parse_scene(
            "[body]\nmoments_kg_m2 = [1.0, 2.0, 2.9]\n[start]\nomega_rad_s = [1.5, 0.3, 0.75]\n"
            "[film]\nlength_s = 1.0\nfps = 10\n",
            "a.toml", std::vector<Override>{{"film.size", "[96, 54]"}}),
        {installed_fonts()});
}

// All messages of a job, in order.
struct Heard {
    std::vector<std::string> words;
    Task task() {
        return {
            .say = [this](const std::string& line) { words.push_back(line); },
            .begin = [this](const std::string& what,
                            std::int64_t n) { words.push_back(what + " " + std::to_string(n)); },
            .done = [this](std::int64_t n) { words.push_back(std::to_string(n)); },
            .finish = [this](const std::string& made) { words.push_back("made " + made); }};
    }
};

std::string text_of_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(FilmJob, ReportsItsFramesInOrderAndItsBoundAtTheEnd) {
    const TemporaryFolder folder;
    const Session session = small_session();
    const FilmJob job(session, {(folder / "a.md5").string(), {{3, 5}}});
    EXPECT_EQ(job.film().n_frames, 10);
    LazyRenderer renderer;
    Heard heard;
    job.make(renderer, heard.task());
    ASSERT_EQ(heard.words.size(), 6u);
    EXPECT_EQ(heard.words[0], "a 3");
    EXPECT_EQ(heard.words[1], "1");
    EXPECT_EQ(heard.words[3], "3");
    EXPECT_EQ(heard.words[4], "made " + (folder / "a.md5").string() + " (0.3 s of film)");
    EXPECT_EQ(heard.words[5].rfind("within ", 0), 0u) << heard.words[5];
}

// Requested frames are the same as in the whole film, with any callbacks.
TEST(FilmJob, MakesTheRequestedFrames) {
    const TemporaryFolder folder;
    const Session session = small_session();
    LazyRenderer renderer;
    FilmJob(session, {(folder / "all_####.png").string(), {}}).make(renderer, {});
    FilmJob(session, {(folder / "part_####.png").string(), {{3, 5}}}).make(renderer, {});
    for (const std::string number : {"0003", "0004", "0005"})
        EXPECT_EQ(pixels_sha256(read_png(folder / ("all_" + number + ".png"))),
                  pixels_sha256(read_png(folder / ("part_" + number + ".png"))));
    EXPECT_FALSE(std::filesystem::exists(folder / "part_0002.png"));
    EXPECT_FALSE(std::filesystem::exists(folder / "part_0006.png"));
}

TEST(FilmJob, RejectsFramesOutsideTheFilmBeforeOpeningAnything) {
    const Session session = small_session();
    EXPECT_THROW(FilmJob(session, {"", {{0, 10}}}), InputError);
}

TEST(Still, ReportsThePictureWhenItIsComplete) {
    const TemporaryFolder folder;
    LazyRenderer renderer;
    StillWriter writer;
    Heard heard;
    const PreparedStill still =
        prepare_still(small_session(), {.output = (folder / "a.png").string(), .time_s = 0.5});
    EXPECT_EQ(n_pixels(still), 96 * 54);
    draw_still(still, renderer, writer, heard.task());
    EXPECT_TRUE(heard.words.empty());
    writer.finish();
    ASSERT_EQ(heard.words.size(), 1u);
    EXPECT_EQ(heard.words[0].rfind((folder / "a.png").string() + "\nwithin ", 0), 0u);
    EXPECT_EQ(read_record(folder / "a.png").time_s, 0.5);
}

// A prepared still is not used up by drawing it.
TEST(Still, IsTheSamePictureEachTime) {
    const TemporaryFolder folder;
    LazyRenderer renderer;
    StillWriter writer;
    const std::filesystem::path file = folder / "a.png";
    const PreparedStill still =
        prepare_still(small_session(), {.output = file.string(), .time_s = 0.5});
    const PixelStill first = still_in_memory(still, renderer);
    draw_still(still, renderer, writer, {});
    writer.finish();
    Image drawn;
    draw_into(still, renderer, drawn);
    const PixelStill last = still_in_memory(still, renderer);
    EXPECT_EQ(encode_png(first.image, first.png), encode_png(last.image, last.png));
    EXPECT_EQ(read_bytes(file), encode_png(first.image, first.png));
    EXPECT_EQ(pixels_sha256(drawn), pixels_sha256(first.image));
}

TEST(Still, RejectsNamesAndDepthsThatNoPngHas) {
    EXPECT_THROW(prepare_still(small_session(), {.output = "a.mp4"}), InputError);
    EXPECT_THROW(prepare_still(small_session(), {.bit_depth = 12}), InputError);
}

TEST(Redraw, MakesTheSameFile) {
    const TemporaryFolder folder;
    {
        LazyRenderer renderer;
        StillWriter writer;
        draw_still(
            prepare_still(small_session(), {.output = (folder / "a.png").string(), .time_s = 0.5}),
            renderer, writer, {});
        writer.finish();
    }
    Heard heard;
    redraw({.file = folder / "a.png", .output = folder / "b.png"}, heard.task());
    EXPECT_EQ(text_of_file(folder / "a.png"), text_of_file(folder / "b.png"));
    EXPECT_EQ(heard.words.size(), 1u);  // no note of a difference
    EXPECT_THROW(redraw({.file = folder / "a.png", .output = folder / "b.mp4"}, {}), InputError);
}

}  // namespace
}  // namespace poinsot
