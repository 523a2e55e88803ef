// render: films and sequences, their sidecars, and messages about their formats.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "cli/program_run.h"
#include "cli/small_scene.h"
#include "encoding/video_reader.h"
#include "image/files/png_files.h"

namespace poinsot::testing {
namespace {

using RenderMessages = Messages;

TEST(Render, SingleFrameEqualsTheFrameOfTheSequence) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    ASSERT_EQ(run_program_in(folder, "render scene.toml -o all-####.png --frames 0-12 -q").code, 0);
    ASSERT_EQ(run_program_in(folder, "render scene.toml -o one-####.png --frames 12-12 -q").code,
              0);
    const Image together = read_png(folder.path() / "all-0012.png");
    const Image alone = read_png(folder.path() / "one-0012.png");
    EXPECT_TRUE(together == alone);
}

TEST(Render, FilmHasItsFramesSizeRateAndColours) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const ProgramRun run =
        run_program_in(folder, "render scene.toml -o a.mp4 --fps 30000/1001 --quality print");
    ASSERT_EQ(run.code, 0) << run.err;
    VideoReader reader(folder.path() / "a.mp4");
    EXPECT_EQ(reader.info().width_px, 320);
    EXPECT_EQ(reader.info().height_px, 180);
    EXPECT_EQ(reader.info().rate.numerator, 30000);
    EXPECT_EQ(reader.info().rate.denominator, 1001);
    EXPECT_EQ(reader.info().codec, "h264");
    EXPECT_EQ(reader.info().pixel_format, "yuv420p");
    EXPECT_EQ(reader.info().matrix, "bt709");
    EXPECT_EQ(reader.info().range, "tv");

    // The first frame is the still of the same instant, within the average loss by 4:2:0 and
    // quantisation.
    ASSERT_EQ(
        run_program_in(folder, "still scene.toml --time 0 --set film.quality=print -o first.png")
            .code,
        0);
    const Image still = read_png(folder.path() / "first.png");
    std::int64_t n_frames = 0;
    double difference = 0.0;
    for (Image frame; reader.read(frame);) {
        if (n_frames == 0) {
            for (std::size_t i = 0; i < still.bytes().size(); ++i) {
                difference += std::abs(static_cast<int>(still.bytes()[i]) -
                                       static_cast<int>(frame.bytes()[i]));
            }
            difference /= static_cast<double>(still.bytes().size());
        }
        ++n_frames;
    }
    EXPECT_EQ(n_frames, 30);
    EXPECT_LT(difference, 2.0);
}

TEST(Render, RefusesOptionsOfFramesForPages) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    for (const std::string option : {"--frames 0-1", "--part 1/2", "--jobs 2", "--certify"}) {
        const ProgramRun run = run_program_in(folder, "render scene.toml -o a.html " + option);
        EXPECT_EQ(run.code, 2) << option;
        EXPECT_EQ(run.err, "a.html: a page has no frames, it shows every instant; leave " +
                               option.substr(0, option.find(' ')) + " out\n");
    }
    EXPECT_EQ(folder.listing(), "scene.toml\n");
}

// One file with the scene, its options and its files; or what to install, where the program was
// built without the module.
TEST(Render, PageIsOneFile) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    folder.write("bad.toml", racket + "[[stops]]\nat_s = 1e6\n");
    const ProgramRun run = run_program_in(
        folder, "render scene.toml -o a.html --set 'title=</script>\"b' --theme dark -q");
    if (run.code == 3) {
        EXPECT_TRUE(contains(run.err, "clang-19"));
        EXPECT_EQ(run_program_in(folder, "render bad.toml -o b.html").code, 3);
        EXPECT_EQ(std::filesystem::exists(folder.path() / "a.html"), false);
        return;
    }
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string page = text_of(folder.path() / "a.html");
    EXPECT_LE(page.size(), 1'200'000U);
    EXPECT_TRUE(contains(page, "<title>&lt;/script&gt;"));
    EXPECT_TRUE(contains(page, "\"theme=dark\""));
    EXPECT_EQ(run_program_in(folder, "render bad.toml -o b.html").code, 2);
    EXPECT_EQ(std::filesystem::exists(folder.path() / "b.html"), false);
    // The same scene and options give the same bytes.
    ASSERT_EQ(run_program_in(
                  folder, "render scene.toml -o c.html --set 'title=</script>\"b' --theme dark -q")
                  .code,
              0);
    EXPECT_EQ(text_of(folder.path() / "c.html"), page);
}

TEST(Render, InterruptedLeavesNothingUnderTheFinalName) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const ProgramRun run = run_program_in(
        folder,
        "render scene.toml -o a.mp4 --set film.duration_s=2000 & sleep 1; kill -INT $!; wait $!");
    EXPECT_EQ(run.code, 3);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.mp4"));
}

// A chapters file belongs to one film: only a film that replaces it removes the file.
TEST(Render, RemovesOnlyTheChaptersOfAReplacedFilm) {
    const ScratchFolder folder;
    folder.write("plain.toml", racket);
    folder.write("told.toml", racket + "[[chapters]]\nat_s = 0.0\ntitle = \"Start\"\n");
    const auto render = [&folder](const std::string& arguments) {
        const ProgramRun run = run_program_in(folder, "render " + arguments + " -q --size 96x54");
        EXPECT_EQ(run.code, 0) << run.err;
    };
    const auto exists = [&folder](const char* name) {
        return std::filesystem::exists(folder.path() / name);
    };
    render("told.toml -o g.mp4");
    render("told.toml -o g.webm");
    EXPECT_NE(text_of(folder.path() / "g.chapters.json").find("\"g.mp4\""), std::string::npos);
    EXPECT_NE(text_of(folder.path() / "g.webm.chapters.json").find("\"g.webm\""),
              std::string::npos);
    // A film without chapters removes its own file of chapters, and no other file.
    folder.write("h.chapters.json", "[]\n");
    render("plain.toml -o g.mp4");
    render("plain.toml -o h.mp4");
    EXPECT_FALSE(exists("g.chapters.json"));
    EXPECT_TRUE(exists("g.webm.chapters.json"));
    EXPECT_TRUE(exists("h.chapters.json"));
}

TEST_F(RenderMessages, LostTransparencyIsReported) {
    const auto said = [this](const std::string& theme, const std::string& output) {
        const ProgramRun made =
            run("render scene.toml --frames 0-0 --theme " + theme + " -o " + output);
        EXPECT_EQ(made.code, 0) << made.err;
        return made.err;
    };
    for (const char* theme : {"transparent", "transparent-dark"}) {
        EXPECT_NE(said(theme, "a.mp4").find(".mp4 has no transparency"), std::string::npos);
        EXPECT_NE(said(theme, "a.mp4").find(".webm, .mov and a .png sequence keep transparency"),
                  std::string::npos);
        EXPECT_NE(said(theme, "a.gif").find("a pixel of a GIF is either transparent or opaque"),
                  std::string::npos);
        EXPECT_EQ(said(theme, "a.webm").find("note"), std::string::npos);
        EXPECT_EQ(said(theme, "a.mov").find("note"), std::string::npos);
        EXPECT_EQ(said(theme, "'a_####.png'").find("transparency"), std::string::npos);
    }
    EXPECT_EQ(said("light", "a.mp4").find("transparen"), std::string::npos);
}

// FFmpeg lays a frame of the film over a coloured ground; by the formula, the picture is laid over
// it. FFmpeg's own rounding is within the limit. Measured: 3, with the next quantizer 7.
TEST(Render, AMovOverAGroundIsThePictureOnThatGround) {
    if (std::system("command -v ffmpeg >/dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg";
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    for (const char* theme : {"transparent", "transparent-dark"}) {
        for (const char* output : {"a.mov", "'a_#.png'"}) {
            const ProgramRun made = run_program_in(
                folder, std::string("render scene.toml -q --size 320x180 --frames 0-1 ") +
                            "--theme " + theme + " -o " + output);
            ASSERT_EQ(made.code, 0) << made.err;
        }
        const Image picture = read_png(folder.path() / "a_1.png");
        for (const auto& [colour, ground] : {std::pair{"white", Rgba8{255, 255, 255, 255}},
                                             {"black", Rgba8{0, 0, 0, 255}},
                                             {"0x2040a0", Rgba8{32, 64, 160, 255}}}) {
            const std::string command =
                "cd '" + folder.path().string() +
                "' && ffmpeg -nostdin -v error -y -f lavfi -i color=" + colour +
                ":s=320x180:r=30,format=gbrp -i a.mov -filter_complex '[1]scale=in_color_matrix="
                "bt709:flags=accurate_rnd+full_chroma_int,format=gbrap[film];[0][film]overlay="
                "format=gbrp:shortest=1,select=eq(n\\,1),format=rgb24' -frames:v 1 shown.png";
            ASSERT_EQ(std::system(command.c_str()), 0);
            const Image shown = read_png(folder.path() / "shown.png");
            int worst = 0;
            for (int y = 0; y < 180; ++y)
                for (int x = 0; x < 320; ++x) {
                    const Rgba8 over = picture.at(x, y), found = shown.at(x, y);
                    const auto differ = [&](int of_picture, int of_ground, int of_film) {
                        const int wanted =
                            (over.a * of_picture + (255 - over.a) * of_ground + 127) / 255;
                        worst = std::max(worst, std::abs(wanted - of_film));
                    };
                    differ(over.r, ground.r, found.r);
                    differ(over.g, ground.g, found.g);
                    differ(over.b, ground.b, found.b);
                }
            EXPECT_LE(worst, 3) << theme << " over " << colour;
        }
    }
}

TEST_F(RenderMessages, AnUnsupportedRateIsReported) {
    refuses("render scene.toml --fps 60 -o a.gif", 2, {"--fps 60: ", "at most 50 frames a second"});
}

// A pipe has no random access: the file is complete without it.
TEST_F(RenderMessages, AGifCanBeWrittenToAPipe) {
    const ProgramRun done =
        run_program_in(folder_, "render scene.toml -q -o p.gif && wait && cat got.gif | head -c 6",
                       "mkfifo p.gif && (cat p.gif >got.gif &) &&");
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(done.out, "GIF89a");
}

TEST_F(RenderMessages, AnUnsupportedSuffixGetsTheNearestAlternative) {
    refuses("render scene.toml --size 20000x100 -o a.mp4", 2,
            {"film.size is 20000x100", "at most 16384 pixels per side"});
    refuses("render scene.toml -o a.mpg4", 2, {"did you mean \".mp4\"?"});
    refuses("render scene.toml -o a.mkv", 2, {"\".mkv\"", "write .mp4", "ffmpeg -i film.mp4"});
    refuses("render scene.toml -o a.avi", 2, {"write .mp4"});
    refuses("render scene.toml -o a.jpg", 2, {"write .png"});
    refuses("render scene.toml -o a.xyzzy", 2, {"the formats are .mp4, .webm, .mov, .gif"});
}

// The stops of tests/outputs/production/slide_deck_test.cpp are drawn by one process.
TEST(Slides, HaveTheSameBytesFromSeveralProcesses) {
    const ScratchFolder folder;
    folder.write("a.toml", racket + "fps = 200\n[[stops]]\nat_s = 0.8\nloop_s = 0.7\n");
    for (const std::string n_jobs : {"1", "3"}) {
        const ProgramRun run =
            run_program_in(folder, "render a.toml --slides deck" + n_jobs + " --jobs " + n_jobs);
        ASSERT_EQ(run.code, 0) << run.err;
        EXPECT_EQ(run.out, "");
    }
    for (const std::string file : {"01.mp4", "01-loop.mp4", "01.png", "01.pdf", "02.mp4", "02.png",
                                   "02.pdf", "slides.json", "index.html"}) {
        EXPECT_NE(text_of(folder.path() / "deck1" / file), "") << file;
        EXPECT_EQ(text_of(folder.path() / "deck1" / file), text_of(folder.path() / "deck3" / file))
            << file;
    }
}

TEST_F(RenderMessages, SlidesAreRefusedWithOptionsOfOneFilmAndWithoutStops) {
    refuses("render scene.toml --slides d -o a.mp4", 2, {"--slides", "leave --output out"});
    refuses("render scene.toml --slides d --part 1/2", 2, {"--slides", "leave --part out"});
    refuses("render scene.toml --slides d --frames 0-1", 2, {"--slides", "leave --frames out"});
    refuses("render scene.toml --slides d", 2,
            {"scene.toml:1:1", "no [[stops]] and no [[chapters]] for --slides"});
    folder_.write("stops.toml", scene + "[[stops]]\nat_s = 0.1\n");
    refuses("render stops.toml --slides d --size 65x49", 2, {"--size 65x49", "even"});
    refuses("render stops.toml --slides stops.toml", 2, {"stops.toml", "not a folder"});
    refuses("render stops.toml --slides .", 2, {"current folder"});
    refuses("render stops.toml --slides no/d", 3, {"cannot write no/d"});
    refuses("render scene.toml stops.toml --slides d", 2, {"d", "{scene}"});
}

TEST_F(RenderMessages, PresentationsAreRefusedWithOptionsOfOneFilmAndWithoutStops) {
    refuses("render scene.toml -o a.pptx --part 1/2", 2, {"a.pptx", "leave --part out"});
    refuses("render scene.toml -o a.pptx --frames 0-1", 2, {"a.pptx", "leave --frames out"});
    refuses("render scene.toml -o a.pptx", 2,
            {"scene.toml:1:1", "no [[stops]] and no [[chapters]] for -o a.pptx"});
    folder_.write("stops.toml", scene + "[[stops]]\nat_s = 0.1\n");
    refuses("render stops.toml -o a.pptx --size 65x49", 2, {"--size 65x49", "even"});
    refuses("render stops.toml -o no/a.pptx", 3, {"cannot write no/a.pptx"});
    refuses("render scene.toml stops.toml -o a.pptx", 2, {"a.pptx", "{scene}"});
    for (const std::string suffix : {"ppt", "odp", "key"})
        refuses("render scene.toml -o a." + suffix, 2, {"write .pptx"});
    folder_.write("a.pptx", "mine");
    refuses("render stops.toml -o a.pptx", 2, {"a.pptx", "not written by poinsot", "name another"});
}

}  // namespace
}  // namespace poinsot::testing
