// Metadata and chapters are read back from the containers that support them.
#include "encoding/film_metadata.h"

#include <gtest/gtest.h>

#include "encoding/films.h"
#include "encoding/video_reader.h"

namespace poinsot {
namespace {

TEST(FilmMetadata, IsReadBackFromEveryFormat) {
    for (const char* name : {"a.mp4", "a.webm", "a.mov", "a.gif"}) {
        // As long as a complete scene, with the characters that formats escape, and of several
        // lines.
        for (const std::string& text :
             {std::string("title = \"L'ω\"\n[body]\nmoments = [3, 2, 1] # = ; \\ é\n"),
              std::string(20000, 'x') + "end", std::string("1")}) {
            const TemporaryFolder folder;
            OutputPlan plan = small_plan(folder / name, 1);
            plan.metadata = text;
            write_film(plan);
            EXPECT_EQ(film_metadata(plan.path), text) << name;
        }
    }
}

TEST(FilmMetadata, IsEmptyWithoutMetadata) {
    for (const char* name : {"a.mp4", "a.webm", "a.mov", "a.gif"}) {
        const TemporaryFolder folder;
        OutputPlan plan = small_plan(folder / name, 1);
        plan.metadata = "";
        write_film(plan);
        EXPECT_EQ(film_metadata(plan.path), "") << name;
    }
}

TEST(FilmMetadata, OfAMissingFileIsRefused) {
    const TemporaryFolder folder;
    EXPECT_NE(refusal_message([&] { film_metadata(folder / "a.mp4"); }), "");
}

TEST(Chapters, AreReadBackFromTheFilm) {
    // WebM and MP4 store chapters in milliseconds: at these rates these identify frames.
    for (const char* name : {"a.mp4", "a.webm", "a.mov"}) {
        for (const FrameRate rate : {FrameRate{30, 1}, FrameRate{30000, 1001}}) {
            const TemporaryFolder folder;
            OutputPlan plan = small_plan(folder / name, 12);
            plan.rate = rate;
            plan.chapters = {{"The ellipsoid", 0, 5}, {"ρ = n/√I, \"half-axes\"", 5, 12}};
            write_film(plan);
            const VideoInfo info = VideoReader(plan.path).info();
            EXPECT_EQ(info.n_frames, 12);
            ASSERT_EQ(info.chapters.size(), 2u) << name;
            for (std::size_t i = 0; i < 2; ++i) {
                EXPECT_EQ(info.chapters[i].title, plan.chapters[i].title) << name;
                EXPECT_EQ(info.chapters[i].first_frame, plan.chapters[i].first_frame) << name;
                EXPECT_EQ(info.chapters[i].end_frame, plan.chapters[i].end_frame) << name;
            }
        }
    }
}

TEST(Chapters, AreNoneWithoutChapters) {
    for (const char* name : {"a.mp4", "a.webm", "a.mov"}) {
        const TemporaryFolder folder;
        const OutputPlan plan = small_plan(folder / name, 3);
        write_film(plan);
        EXPECT_TRUE(VideoReader(plan.path).info().chapters.empty()) << name;
    }
}

}  // namespace
}  // namespace poinsot
