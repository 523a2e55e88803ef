// The default of --jobs as a function of the machine's and the film's properties, with made-up
// values.
#include "production/films/job_choice.h"

#include <gtest/gtest.h>

#include "error/error.h"

namespace poinsot {
namespace {

constexpr Machine two_cores{2, 8000}, sixteen_cores{16, 64000};

FilmWork film(std::int64_t n_frames, int width_px, int height_px,
              const std::string& output = "film.mp4", const std::string& quality = "lecture") {
    return {n_frames, width_px, height_px, quality, output};
}

TEST(JobChoice, UsesEveryCoreForALongFilm) {
    EXPECT_EQ(choose_jobs(film(480, 1920, 1080), two_cores).n_jobs, 2);
    EXPECT_EQ(choose_jobs(film(480, 1920, 1080), two_cores).n_threads, 1);
    EXPECT_EQ(choose_jobs(film(16 * 120, 1920, 1080), sixteen_cores).n_jobs, 16);
    EXPECT_EQ(choose_jobs(film(480, 1920, 1080), {1, 8000}).n_jobs, 1);
}

// Four chunks on sixteen cores: four jobs, which share the remaining cores.
TEST(JobChoice, DistributesRemainingCores) {
    const JobChoice choice = choose_jobs(film(4 * 120, 1920, 1080), sixteen_cores);
    EXPECT_EQ(choice.n_jobs, 4);
    EXPECT_EQ(choice.n_threads, 4);
    EXPECT_EQ(choose_jobs(film(120, 1920, 1080), sixteen_cores).n_jobs, 1);
    // Sequences of pictures can be divided at any frame.
    EXPECT_EQ(choose_jobs(film(120, 1920, 1080, "f_###.png"), sixteen_cores).n_jobs, 10);
}

TEST(JobChoice, DrawsTinyFilmsInOneProcess) {
    EXPECT_EQ(choose_jobs(film(240, 96, 54), sixteen_cores).n_jobs, 1);
    EXPECT_EQ(choose_jobs(film(240, 320, 180), two_cores).n_jobs, 1);
    EXPECT_EQ(choose_jobs(film(60, 320, 180, "f_##.png"), two_cores).n_jobs, 1);
    EXPECT_GT(choose_jobs(film(36000, 96, 54), two_cores).n_jobs, 1);
}

TEST(JobChoice, ConsidersFormatsThatOneProcessAssembles) {
    for (const char* output : {"a.gif", "a.md5", "a.png", "null", "-.gif", "/dev/stdout.gif"})
        EXPECT_EQ(choose_jobs(film(4800, 1920, 1080, output), sixteen_cores).n_jobs, 1) << output;
    EXPECT_EQ(choose_jobs(film(4800, 1920, 1080, "a.webm"), two_cores).n_jobs, 1);
    EXPECT_EQ(choose_jobs(film(4800, 1920, 1080, "a.webm"), sixteen_cores).n_jobs, 8);
    EXPECT_THROW(choose_jobs(film(10, 96, 54, "a.avi"), two_cores), InputError);
}

TEST(JobChoice, LeavesHalfOfTheMemory) {
    // 1,089 MiB per process at 3840 × 2160.
    const JobChoice choice = choose_jobs(film(4800, 3840, 2160), {16, 9000});
    EXPECT_EQ(choice.n_jobs, 4);
    EXPECT_LE(choice.memory_MiB, 4500);
    EXPECT_EQ(choose_jobs(film(4800, 3840, 2160), {16, 1000}).n_jobs, 1);
    EXPECT_NE(choice.why.find("memory"), std::string::npos) << choice.why;
    EXPECT_GT(choose_jobs(film(4800, 1920, 1080, "a.mp4", "reference"), two_cores).memory_MiB,
              2 * choose_jobs(film(4800, 1920, 1080), two_cores).memory_MiB);
}

// The number of jobs grows with the film, and never exceeds the numbers of cores and chunks.
TEST(JobChoice, GrowsWithTheFilm) {
    int last = 0;
    for (std::int64_t n_frames = 1; n_frames < 100000; n_frames = n_frames * 5 / 4 + 1) {
        const JobChoice choice = choose_jobs(film(n_frames, 640, 360), sixteen_cores);
        EXPECT_GE(choice.n_jobs, last) << n_frames;
        EXPECT_LE(choice.n_jobs, (n_frames + 119) / 120);
        EXPECT_LE(choice.n_jobs * choice.n_threads, 16);
        last = choice.n_jobs;
    }
    EXPECT_EQ(last, 16);
}

TEST(JobChoice, IsDescribedInWords) {
    EXPECT_EQ(in_words(choose_jobs(film(480, 1920, 1080), two_cores)),
              "2 processes, each drawing with one thread, about 724 MiB together");
}

}  // namespace
}  // namespace poinsot
