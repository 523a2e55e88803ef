// The behaviour of each command, with small pictures.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program_run.h"
#include "image/files/png_files.h"
#include "output/video_reader.h"
#include "places.h"

namespace poinsot::testing {
namespace {

const std::string racket = R"(
title = "Racket"
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.01, 2.0, 0.01]
[film]
size = [320, 180]
duration_s = 1.0
)";

std::vector<double> numbers_of(const std::string& line) {
    std::vector<double> numbers;
    std::stringstream stream(line);
    for (std::string item; std::getline(stream, item, ',');) numbers.push_back(std::stod(item));
    return numbers;
}

TEST(Sample, PrintsTheFixedColumnsAndExactDoubles) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const ProgramRun run = run_program_in(folder, "sample scene.toml --times 0,0.1");
    ASSERT_EQ(run.code, 0) << run.err;
    std::stringstream lines(run.out);
    std::string header;
    std::string first;
    std::string second;
    std::getline(lines, header);
    std::getline(lines, first);
    std::getline(lines, second);
    EXPECT_EQ(header,
              "time_s,omega_body_1,omega_body_2,omega_body_3,q_w,q_x,q_y,q_z,"
              "herpolhode_x,herpolhode_y,herpolhode_z");
    const auto at_0 = numbers_of(first);
    ASSERT_EQ(at_0.size(), 11u);
    // The start is printed exactly.
    const std::vector<double> start(at_0.begin(), at_0.begin() + 8);
    EXPECT_EQ(start, (std::vector<double>{0.0, 0.01, 2.0, 0.01, 1.0, 0.0, 0.0, 0.0}));
    EXPECT_EQ(numbers_of(second)[0], 0.1);
}

TEST(Check, NamesRegimeAndConstants) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const ProgramRun run = run_program_in(folder, "check scene.toml --json");
    ASSERT_EQ(run.code, 0) << run.err;
    // T = ½ Σ I ω² and the plane's distance √(2T)/L from the input by hand.
    const double twice_T = 3e-4 + 8.0 + 1e-4;
    const double L = std::sqrt(9e-4 + 16.0 + 1e-4);
    const auto number = [&run](const std::string& key) {
        const std::size_t at = run.out.find("\"" + key + "\": ");
        EXPECT_NE(at, std::string::npos) << run.out;
        return std::stod(run.out.substr(at + key.size() + 4));
    };
    EXPECT_NEAR(number("kinetic_energy_J"), 0.5 * twice_T, 1e-14);
    EXPECT_NEAR(number("momentum_kg_m2_s"), L, 1e-14);
    EXPECT_NEAR(number("plane_distance"), std::sqrt(twice_T) / L, 1e-15);
    EXPECT_EQ(number("n_frames"), 30.0);
}

TEST(Still, HasTheRequestedSize) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const ProgramRun run =
        run_program_in(folder, "still scene.toml --time 0.5 --size 200x120 -o a.png");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.out, "");
    const Image image = read_png(folder.path() / "a.png");
    EXPECT_EQ(image.width(), 200);
    EXPECT_EQ(image.height(), 120);
}

TEST(Still, IsReproducible) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    ASSERT_EQ(run_program_in(folder, "still scene.toml -o a.png").code, 0);
    ASSERT_EQ(run_program_in(folder, "still scene.toml -o b.png").code, 0);
    EXPECT_EQ(text_of(folder.path() / "a.png"), text_of(folder.path() / "b.png"));
}

// The default title of a scene is its file's name, whatever characters that has. The dynamic loader
// logs every library that it opens.
TEST(Still, DoesNotLoadFFmpeg) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const std::string loader = "LD_DEBUG=files";
    const ProgramRun still = run_program_in(folder, "still scene.toml -o a.png", loader);
    ASSERT_EQ(still.code, 0);
    EXPECT_NE(still.err.find("libpng"), std::string::npos);
    EXPECT_EQ(still.err.find("libav"), std::string::npos);
    EXPECT_EQ(still.err.find("libsw"), std::string::npos);
    const ProgramRun film =
        run_program_in(folder, "render scene.toml --set film.duration_s=0.1 -o a.mp4", loader);
    ASSERT_EQ(film.code, 0);
    EXPECT_NE(film.err.find("libavcodec"), std::string::npos);
}

TEST(Still, AcceptsAnySceneName) {
    const ScratchFolder folder;
    std::string untitled = racket;
    untitled.erase(untitled.find("title"), std::string("title = \"Racket\"\n").size());
    for (const std::string name :
         {"a$b", "{x", "a\\b", "a_b^c", "--5--", "~`'%&#", "Волчок", "陀螺", "a\xff", "\u202ea"}) {
        folder.write(name + ".toml", untitled);
        std::string quoted;
        for (const char c : name) quoted += c == '\'' ? "'\\''" : std::string(1, c);
        const std::string file = "'./" + quoted + ".toml'";
        const ProgramRun still = run_program_in(folder, "still " + file + " -o a.png");
        EXPECT_EQ(still.code, 0) << name << ": " << still.err;
        EXPECT_EQ(run_program_in(folder, "check -q " + file).code, 0) << name;
        const ProgramRun again = run_program_in(folder, "rerender -q a.png -o b.png");
        EXPECT_EQ(again.code, 0) << name << ": " << again.err;
        // Replaced letters are in the record, and missing ones were reported.
        const bool plain = name.find_first_not_of("a$bc{x\\_^-5~`'%&#") == std::string::npos;
        const std::string record = run_program_in(folder, "explain a.png").out;
        const bool recorded = record.find("\nfonts: ") != std::string::npos;
        const bool said = still.err.find("drawn as boxes") != std::string::npos;
        EXPECT_EQ(recorded || said, !plain) << name << still.err << record.substr(0, 600);
    }
    // A title in the scene is markup as usual.
    folder.write("own.toml", "title = \"a$b\"\n" + untitled);
    EXPECT_EQ(run_program_in(folder, "still own.toml -o c.png").code, 2);
}

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

TEST(Render, InterruptedLeavesNothingUnderTheFinalName) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const ProgramRun run = run_program_in(
        folder,
        "render scene.toml -o a.mp4 --set film.duration_s=2000 & sleep 1; kill -INT $!; wait $!");
    EXPECT_EQ(run.code, 3);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.mp4"));
}

// The finished frames of an interrupted film are the beginning of the complete one, and repeating
// the command gives a byte-identical film.
TEST(Recover, GivesTheFinishedFramesAndRenderContinues) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const std::string film = " --size 96x54 --set film.duration_s=60 --frames 0-899 -q";
    ASSERT_EQ(run_program_in(folder, "recover a.mp4").code, 2);
    ASSERT_EQ(run_program_in(folder, "render scene.toml -o whole.mp4" + film).code, 0);
    // Killed when the log has more than a chunk of 120 frames; the complete film has three times as
    // many.
    const auto n_bytes = std::filesystem::file_size(folder.path() / "whole.mp4") / 3;
    const std::string script = "cd '" + folder.path().string() + "' || exit 1\n'" + program_path() +
                               "' render scene.toml -o a.mp4" + film +
                               " &\nwhile kill -0 $! 2>/dev/null && [ \"$(stat -c " +
                               "%s .a.mp4.part.frames 2>/dev/null || echo 0)\" -lt " +
                               std::to_string(n_bytes) +
                               " ]; do sleep 0.01; done\nkill -9 $!\nwait $! 2>/dev/null\n" +
                               "cp .a.mp4.part.frames .b.mp4.part.frames\n";
    ASSERT_EQ(std::system(script.c_str()), 0);
    ASSERT_FALSE(std::filesystem::exists(folder.path() / "a.mp4"));
    ASSERT_EQ(run_program_in(folder, "recover b.mp4").code, 0);
    VideoReader whole(folder.path() / "whole.mp4"), recovered(folder.path() / "b.mp4");
    const std::int64_t n_frames = recovered.info().n_frames;
    ASSERT_GT(n_frames, 100);
    ASSERT_LT(n_frames, 900);
    Image expected, found;
    for (std::int64_t k = 0; k < n_frames; ++k) {
        ASSERT_TRUE(whole.read(expected) && recovered.read(found)) << k;
        ASSERT_TRUE(expected == found) << k;
    }
    const ProgramRun says = run_program_in(folder, "explain b.mp4");
    EXPECT_NE(says.out.find("frames: 0-" + std::to_string(n_frames - 1) + "\nrun: 0-899\n"),
              std::string::npos)
        << says.out;
    // A recovered film can be rendered again, like every output.
    ASSERT_EQ(run_program_in(folder, "rerender -q b.mp4 -o again.mp4").code, 0);
    EXPECT_TRUE(text_of(folder.path() / "again.mp4") == text_of(folder.path() / "b.mp4"));
    const ProgramRun gone_on = run_program_in(folder, "render scene.toml -o a.mp4" + film);
    ASSERT_EQ(gone_on.code, 0) << gone_on.err;
    EXPECT_EQ(text_of(folder.path() / "a.mp4"), text_of(folder.path() / "whole.mp4"));
}

// Renders a film of a minute in one process and interrupts it when the log has some 40 kB.
void interrupt_render(const ScratchFolder& folder, const std::string& scene,
                      const std::string& film) {
    const std::string script =
        "cd '" + folder.path().string() + "' && '" + program_path() + "' render " + scene + " -o " +
        film +
        " --jobs 1 --size 96x54 --set film.duration_s=60 -q & pid=$!\nwhile [ \"$(stat -c %s '" +
        (folder.path() / ("." + film + ".part.frames")).string() +
        "' 2>/dev/null || echo 0)\" -lt 40000 ]; do sleep 0.01; done\nkill -INT $pid; wait $pid";
    ASSERT_NE(std::system(script.c_str()), 0);
}

// The chapters come from the scene in the film's record, which is read again: here a scene with
// symbols and with keys without a table, whose rows come later.
TEST(Recover, WritesTheFinishedChapters) {
    const ScratchFolder folder;
    folder.write("scene.toml", "labels = false\nunlabelled = [\"omega\"]\n" + racket +
                                   "[symbols]\nomega = \"w\"\n"
                                   "[[chapters]]\nat_s = 0\ntitle = \"One\"\n"
                                   "[[chapters]]\nat_s = 3\ntitle = \"Two\"\n"
                                   "[[chapters]]\nat_s = 50\ntitle = \"Three\"\n");
    // Interrupted when the log has some 250 frames: the second chapter has begun with frame 90.
    interrupt_render(folder, "scene.toml", "a.webm");
    ASSERT_EQ(run_program_in(folder, "recover a.webm").code, 0);
    const VideoInfo info = VideoReader(folder.path() / "a.webm").info();
    ASSERT_EQ(info.chapters.size(), 2u);
    EXPECT_EQ(info.chapters[1].title, "Two");
    EXPECT_EQ(info.chapters[1].end_frame, info.n_frames);
    const std::string beside = text_of(folder.path() / "a.webm.chapters.json");
    EXPECT_NE(beside.find("\"last_frame\": " + std::to_string(info.n_frames - 1)),
              std::string::npos)
        << beside;
    EXPECT_EQ(beside.find("Three"), std::string::npos);
}

// Recovering a film without chapters removes the chapters file of the film that it replaces.
TEST(Recover, RemovesTheChaptersOfAReplacedFilm) {
    const ScratchFolder folder;
    folder.write("told.toml", racket + "[[chapters]]\nat_s = 0.0\ntitle = \"Start\"\n");
    folder.write("plain.toml", racket);
    ASSERT_EQ(run_program_in(folder, "render told.toml -q --size 96x54 -o a.mp4").code, 0);
    ASSERT_TRUE(std::filesystem::exists(folder.path() / "a.chapters.json"));
    interrupt_render(folder, "plain.toml", "a.mp4");
    ASSERT_EQ(run_program_in(folder, "recover a.mp4").code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.chapters.json"));
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

TEST(List, EveryListHasRows) {
    const ScratchFolder folder;
    const ProgramRun lists = run_program_in(folder, "list");
    ASSERT_EQ(lists.code, 0);
    std::stringstream names(lists.out);
    int n_lists = 0;
    for (std::string name; std::getline(names, name); ++n_lists) {
        const ProgramRun rows = run_program_in(folder, "list " + name);
        EXPECT_EQ(rows.code, 0) << rows.err;
        EXPECT_NE(rows.out, "") << name;
    }
    EXPECT_GE(n_lists, 5);
    EXPECT_NE(lists.out.find("quantities\n"), std::string::npos);
}

// The scenes are found next to the program, not in the source folder.
TEST(List, FindsTheScenesOfAnInstalledProgram) {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder.path() / "bin");
    std::filesystem::create_directories(folder.path() / "share/poinsot/scenes");
    std::filesystem::copy_file(program_path(), folder.path() / "bin/poinsot");
    folder.write("share/poinsot/scenes/one.toml", racket);
    const auto list = [&folder] {
        const int status = std::system(
            ("cd '" + folder.path().string() + "' && bin/poinsot list scenes >out 2>err").c_str());
        return WEXITSTATUS(status);
    };
    EXPECT_EQ(list(), 0);
    EXPECT_EQ(text_of(folder.path() / "out"), "one  Racket\n");
    std::filesystem::remove_all(folder.path() / "share");
    EXPECT_EQ(list(), 3);
    const std::string err = text_of(folder.path() / "err");
    EXPECT_EQ(err.find("/scenes"), std::string::npos) << err;
    // The program does not contain the path of its source folder.
    const std::string program = text_of(program_path());
    const std::string checkout = (source_folder() / "scenes").string();
    EXPECT_EQ(program.find(checkout), std::string::npos);
}

// About two hundred rows: by default only the Pareto front is printed; the files have all rows.
TEST(Tradeoff, PrintsTheFrontAndLeavesNoTemporaryFiles) {
    const ScratchFolder folder, temporary;
    folder.write("scene.toml", racket);
    const std::string arguments =
        "tradeoff scene.toml -q --size 64x36 --set film.duration_s=0.2 -o t";
    const std::string runner = "env TMPDIR='" + temporary.path().string() + "'";
    const ProgramRun front = run_program_in(folder, arguments, runner);
    ASSERT_EQ(front.code, 0) << front.err;
    EXPECT_EQ(temporary.listing(), "");
    const std::string csv = text_of(folder.path() / "t.csv");
    const auto count = [](const std::string& text, const std::string& what) {
        std::ptrdiff_t n = 0;
        for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++n;
        return n;
    };
    EXPECT_EQ(count(front.out, "\n* "), count(csv, ",true\n"));
    EXPECT_EQ(count(front.out, "\n  euler "), 0);
    EXPECT_GT(count(csv, ",false\n"), 20);
    // The cost of a frame is measured at the film's own size and quality.
    EXPECT_NE(front.out.find("at 64x36 and quality lecture"), std::string::npos) << front.out;
    const ProgramRun all = run_program_in(folder, arguments + " --all", runner);
    ASSERT_EQ(all.code, 0) << all.err;
    EXPECT_GT(count(all.out, "\n"), count(front.out, "\n") + 20);
}

TEST(Doctor, FindsAContextHere) {
    const ScratchFolder folder;
    const ProgramRun run = run_program_in(folder, "doctor");
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    EXPECT_NE(run.out.find("context OSMesa"), std::string::npos);
}

// A file that is not a library simulates a missing library.
TEST(Doctor, AdvisesAvailablePackages) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder.path() / "lib");
    folder.write("lib/libOSMesa.so.8", "no library");
    const ProgramRun run = run_program_in(folder, "doctor", "LD_LIBRARY_PATH=$PWD/lib");
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    const std::size_t at = run.out.find("context OSMesa");
    const std::string line = run.out.substr(at, run.out.find('\n', at) - at);
    EXPECT_NE(line.find("not needed: EGL works"), std::string::npos) << line;
    EXPECT_EQ(run.out.find("libosmesa6"), std::string::npos) << run.out;
    // Both are missing: the advice also covers distributions without the first.
    folder.write("lib/libEGL.so.1", "no library");
    const ProgramRun none = run_program_in(folder, "doctor", "LD_LIBRARY_PATH=$PWD/lib");
    EXPECT_EQ(none.code, 1) << none.out << none.err;
    EXPECT_NE(none.out.find("libosmesa6 where there is one"), std::string::npos) << none.out;
    EXPECT_NE(none.out.find("libegl1, libegl-mesa0 and libgl1-mesa-dri"), std::string::npos)
        << none.out;
}

// Some of these make Mesa crash or draw something else.
TEST(Environment, OfTheRendererChangesNoPicture) {
    const ScratchFolder folder;
    const std::string scene = "'" + (source_folder() / "scenes/generic.toml").string() + "'";
    const auto drawn = [&](const std::string& environment, const std::string& options) {
        const ProgramRun run = run_program_in(
            folder, "still " + scene + " --size 160x90 -q -o a.png" + options, environment);
        EXPECT_EQ(run.code, 0) << environment << options << ": " << run.err;
        return text_of(folder.path() / "a.png");
    };
    for (const std::string options : {"", " --portable"}) {
        const std::string reference = drawn("", options);
        for (const char* environment :
             {"LP_NATIVE_VECTOR_WIDTH=64", "LP_NATIVE_VECTOR_WIDTH=512", "LP_NATIVE_VECTOR_WIDTH=0",
              "LP_PERF=no_blend", "ST_DEBUG=wf", "DRAW_USE_LLVM=0", "GALLIUM_NOOP=1",
              "MESA_EXTENSION_OVERRIDE=-GL_ARB_texture_float", "MESA_GLSL_VERSION_OVERRIDE=110",
              "MESA_GL_VERSION_OVERRIDE=2.1", "LP_NUM_THREADS=many", "EGL_PLATFORM=x11",
              "LIBGL_ALWAYS_INDIRECT=1", "MESA_LOADER_DRIVER_OVERRIDE=none",
              "GALLIUM_DRIVER=llvmpipe", "GALLIUM_DRIVER="})
            EXPECT_TRUE(drawn(environment, options) == reference) << environment << options;
    }
}

TEST(Environment, WithAnotherDriverIsRefusedInASentence) {
    const ScratchFolder folder;
    const std::string scene = "'" + (source_folder() / "scenes/generic.toml").string() + "'";
    for (const std::string driver : {"bogus", "zink", "swr", "d3d12", "virpipe", "a b"})
        for (const std::string backend : {"auto", "egl"}) {
            const ProgramRun run = run_program_in(
                folder, "still " + scene + " --size 160x90 -q -o a.png --backend " + backend,
                "GALLIUM_DRIVER='" + driver + "'");
            EXPECT_EQ(run.code, 3) << driver << ": " << run.err;
            EXPECT_EQ(run.err.rfind("GALLIUM_DRIVER=" + driver + ": ", 0), 0u) << run.err;
            EXPECT_NE(run.err.find("unset GALLIUM_DRIVER"), std::string::npos) << run.err;
            EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        }
    EXPECT_EQ(folder.listing(), "");
    EXPECT_EQ(run_program_in(folder, "doctor", "GALLIUM_DRIVER=bogus").code, 1);
}

TEST(Program, PrintsVersionAndHelpOnStdout) {
    const ScratchFolder folder;
    const ProgramRun version = run_program_in(folder, "--version");
    EXPECT_EQ(version.code, 0);
    EXPECT_EQ(version.out.rfind("poinsot ", 0), 0u);
    const ProgramRun help = run_program_in(folder, "render --help");
    EXPECT_EQ(help.code, 0);
    EXPECT_NE(help.out.find("--frames"), std::string::npos);
}

// Every supplied scene can be drawn, and its picture has more than one colour.
class EveryScene : public ::testing::TestWithParam<std::string> {};

std::vector<std::string> scene_files() {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() / "scenes")) {
        if (entry.path().extension() == ".toml") files.push_back(entry.path().string());
    }
    return files;
}

TEST_P(EveryScene, FulfilsItsClaims) {
    const ScratchFolder folder;
    const ProgramRun check = run_program_in(folder, "check '" + GetParam() + "'");
    EXPECT_EQ(check.code, 0) << check.err;
    EXPECT_NE(check.out.find("title: "), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, ::testing::ValuesIn(scene_files()),
                         [](const auto& tested) {
                             return std::filesystem::path(tested.param).stem().string();
                         });

// The share of pixels that differ clearly from the background colour.
double share_unlike_corner(const Image& image) {
    std::size_t n_unlike = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const Rgba8 a = image.at(x, y);
            const Rgba8 b = image.at(0, 0);
            n_unlike += std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) > 60;
        }
    }
    return static_cast<double>(n_unlike) / (image.width() * image.height());
}

TEST(Scenes, AllShowSomething) {
    const ScratchFolder folder;
    const std::string scenes = "'" + (source_folder() / "scenes").string() + "'/*.toml";
    const ProgramRun still =
        run_program_in(folder, "still " + scenes + " --size 320x180 --time 1 -q -o '{scene}.png'");
    ASSERT_EQ(still.code, 0) << still.err;
    for (const std::string& file : scene_files()) {
        const std::string name = std::filesystem::path(file).stem().string() + ".png";
        EXPECT_GT(share_unlike_corner(read_png(folder.path() / name)), 0.05) << name;
    }
}

}  // namespace
}  // namespace poinsot::testing
