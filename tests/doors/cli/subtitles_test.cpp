// Captions of a film as a subtitle file next to it.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/program_run.h"

namespace poinsot::testing {
namespace {

const std::string told = R"(title = "Told"
[body]
moments_kg_m2 = [1.0, 2.0, 2.5]
[start]
omega_rad_s = [0.3, 1.0, 0.2]
[film]
size = [64, 48]
fps = 10
duration_s = 4.0
[[captions]]
at_s = 0.5
over_s = 1.25
text = '$\mathbf{L}$ & $\boldsymbol\omega_1$ < 2'
[[captions]]
at_s = 2.0
text = 't = {time_s:.1f} s'
place = "top"
)";

TEST(Subtitles, HaveTheTimesOfTheFilmsCaptions) {
    const ScratchFolder folder;
    folder.write("told.toml", told);
    ASSERT_EQ(run_program_in(folder, "render told.toml -q -o film.mp4").code, 0);
    EXPECT_EQ(without_seal(text_of(folder.path() / "film.vtt")),
              "WEBVTT\n\nNOTE poinsot: film.mp4\n"
              "\n00:00:00.500 --> 00:00:01.750\nL &amp; ω₁ &lt; 2\n"
              "\n00:00:02.000 --> 00:00:04.000 line:0\nt = 2.0 s\n");
    // A part of the film has subtitles with the times of that part.
    ASSERT_EQ(run_program_in(folder, "render told.toml -q --frames 10-29 -o part.webm").code, 0);
    EXPECT_EQ(without_seal(text_of(folder.path() / "part.webm.vtt")),
              "WEBVTT\n\nNOTE poinsot: part.webm\n"
              "\n00:00:00.000 --> 00:00:00.750\nL &amp; ω₁ &lt; 2\n"
              "\n00:00:01.000 --> 00:00:02.000 line:0\nt = 2.0 s\n");
}

TEST(Subtitles, AreRemovedForAFilmWithoutCaptions) {
    const ScratchFolder folder;
    folder.write("told.toml", told);
    folder.write("mute.toml", told.substr(0, told.find("[[captions]]")));
    ASSERT_EQ(run_program_in(folder, "render told.toml -q --frames 0-9 -o film.mp4").code, 0);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "film.vtt"));
    ASSERT_EQ(run_program_in(folder, "render mute.toml -q --frames 0-9 -o film.mp4").code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "film.vtt"));
    // A file of another origin is kept.
    folder.write("film.vtt", "WEBVTT\n\nmine\n");
    ASSERT_EQ(run_program_in(folder, "render mute.toml -q --frames 0-9 -o film.mp4").code, 0);
    EXPECT_EQ(text_of(folder.path() / "film.vtt"), "WEBVTT\n\nmine\n");
}

TEST(Subtitles, BadCaptionsAreRefusedAtTheirPlace) {
    const ScratchFolder folder;
    const auto refuses = [&folder](const std::string& captions, const std::string& what) {
        folder.write("bad.toml", told.substr(0, told.find("[[captions]]")) + captions);
        const ProgramRun run = run_program_in(folder, "still bad.toml -o a.png");
        EXPECT_EQ(run.code, 2);
        EXPECT_NE(run.err.find(what), std::string::npos) << run.err;
    };
    refuses("[[captions]]\nat_s = 1\n", "captions[0].text is missing");
    refuses("[[captions]]\nat_s = 9\ntext = \"x\"\n", "bad.toml:11:1: captions[0].at_s is 9");
    refuses("[[captions]]\nat_s = 1\ntext = \"{nosuch}\"\n", "bad.toml:12:1: ");
    refuses(
        "[[captions]]\nat_s = 1\ntext = \"x\"\nover_s = 2\n[[captions]]\nat_s = 2\ntext = "
        "\"y\"\n",
        "captions[1] begins at 2 s, while captions[0] is still shown in the same place");
}

}  // namespace
}  // namespace poinsot::testing
