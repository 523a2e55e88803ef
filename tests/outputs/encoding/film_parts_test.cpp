// Films in parts: for any number of parts, the joined film is byte-identical to a single run.
#include "encoding/film_parts.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>

#include "encoding/films.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

// The plan of part K of N, with its own file.
OutputPlan part_plan(const OutputPlan& film, std::int64_t number, std::int64_t n_parts) {
    OutputPlan plan = film;
    const OutputFormat& format = format_for(film.path);
    plan.path =
        film.path.parent_path() / (std::to_string(number) + "_" + film.path.filename().string());
    plan.part = part_of_film(number, n_parts, film.n_frames, format.n_chunk_frames);
    plan.part->format = format.name;
    plan.n_frames = plan.part->n_frames;
    return plan;
}

void write_part(const OutputPlan& plan, std::int64_t n_frames, bool finishes = true) {
    const auto sink = format_for(plan.path).open(plan);
    for (std::int64_t k = sink->n_frames_kept(); k < n_frames; ++k)
        sink->write(frame_of(plan, plan.part->n_before + k));
    if (finishes) sink->finish();
}

class FilmInParts : public ::testing::TestWithParam<const char*> {
 protected:
    void join(std::int64_t n_parts) {
        std::vector<PartFile> parts;
        for (std::int64_t k = 1; k <= n_parts; ++k)
            parts.emplace_back(part_plan(plan_, k, n_parts).path);
        for (const PartFile& part : parts) EXPECT_TRUE(part.is_whole());
        JoinedEntries entries(parts);
        format_for(plan_.path).join(entries, plan_);
    }

    TemporaryFolder folder_;
    OutputPlan plan_ = film_plan(folder_ / GetParam(), 500);
};

TEST_P(FilmInParts, IsByteIdenticalToASingleRun) {
    write_film(plan_);
    const std::string whole = bytes_of(plan_.path);
    const std::int64_t chunk = format_for(plan_.path).n_chunk_frames;
    for (const std::int64_t n_asked : {1, 2, 3, 5, 40}) {
        const std::int64_t n_parts = part_of_film(1, n_asked, 500, chunk).n_parts;
        for (std::int64_t k = n_parts; k >= 1; --k) {
            const OutputPlan plan = part_plan(plan_, k, n_parts);
            write_part(plan, plan.n_frames);
        }
        fs::remove(plan_.path);
        join(n_parts);
        EXPECT_TRUE(bytes_of(plan_.path) == whole) << n_asked << " parts";
    }
}

TEST_P(FilmInParts, ContinuesAnInterruptedPart) {
    write_film(plan_);
    const std::string whole = bytes_of(plan_.path);
    std::mt19937 random(5);
    for (std::int64_t k = 1; k <= 2; ++k) {
        const OutputPlan plan = part_plan(plan_, k, 2);
        for (int i = 0; i < 3; ++i) {
            write_part(plan, std::uniform_int_distribution<std::int64_t>(1, 230)(random), false);
            EXPECT_FALSE(fs::exists(plan.path));
        }
        write_part(plan, plan.n_frames);
    }
    fs::remove(plan_.path);
    join(2);
    EXPECT_TRUE(bytes_of(plan_.path) == whole);
}

// A part that is truncated anywhere or has any changed bit is not accepted as complete.
TEST_P(FilmInParts, DetectsTruncatedAndChangedParts) {
    const OutputPlan plan = part_plan(plan_, 2, 3);
    write_part(plan, plan.n_frames);
    const std::string right = bytes_of(plan.path);
    const auto is_taken = [&](const std::string& bytes) {
        std::ofstream(plan.path, std::ios::binary) << bytes;
        try {
            return PartFile(plan.path).is_whole();
        } catch (const InputError&) {
            return false;
        }
    };
    EXPECT_TRUE(is_taken(right));
    EXPECT_FALSE(is_taken(right + "x"));
    std::mt19937 random(11);
    std::uniform_int_distribution<std::size_t> place(0, right.size() - 1);
    for (int i = 0; i < 20; ++i) {
        EXPECT_FALSE(is_taken(right.substr(0, place(random)))) << i;
        std::string changed = right;
        char& byte = changed[place(random)];
        byte = static_cast<char>(byte ^ (1 << i % 8));
        EXPECT_FALSE(is_taken(changed)) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, FilmInParts,
                         ::testing::Values("a.mp4", "a.webm", "a.mov", "a.gif", "a.md5"),
                         [](const auto& format) { return std::string(format.param + 2); });

TEST(FilmPart, CoversEveryFrameOnceWithSeamsAtChunks) {
    std::mt19937 random(3);
    for (int i = 0; i < 2000; ++i) {
        const auto dice = [&](std::int64_t most) {
            return std::uniform_int_distribution<std::int64_t>(1, most)(random);
        };
        const std::int64_t n_frames = dice(i % 2 == 0 ? 40 : 100000), n_parts = dice(50);
        const std::int64_t chunk = i % 3 == 0 ? 1 : 120;
        std::int64_t next = 0, fewest = n_frames, most = 0;
        for (std::int64_t k = 1; k <= n_parts; ++k) {
            const FilmPart part = part_of_film(k, n_parts, n_frames, chunk);
            EXPECT_EQ(part.n_parts, std::min(n_parts, (n_frames + chunk - 1) / chunk));
            if (k > part.n_parts) {
                EXPECT_EQ(part.n_frames, 0);
                continue;
            }
            EXPECT_EQ(part.n_before, next);
            EXPECT_EQ(part.n_before % chunk, 0);
            EXPECT_GT(part.n_frames, 0);
            next += part.n_frames;
            fewest = std::min(fewest, part.n_frames);
            most = std::max(most, part.n_frames);
        }
        EXPECT_EQ(next, n_frames);
        EXPECT_LE(most - fewest, 2 * chunk - 1);
    }
}

TEST(FilmPart, IsReadBackFromItsText) {
    FilmPart part = part_of_film(3, 8, 12345, 120);
    part.format = "webm";
    part.chapters = "{\n  \"chapters\": [\"ω 12\"]\n}\n";
    FilmPart again;
    ASSERT_TRUE(parse_part(part_text(part), again));
    EXPECT_EQ(again, part);
    const std::string text = part_text(part);
    for (std::size_t n = 0; n < text.size(); ++n)
        EXPECT_FALSE(parse_part(text.substr(0, n), again)) << n;
    for (const char* wrong : {"0 8 0 1 8\n0\n\n0\n\n", "9 8 0 1 8\n0\n\n0\n\n",
                              "1 8 8 1 8\n0\n\n0\n\n", "1 8 0 0 8\n0\n\n0\n\n"})
        EXPECT_FALSE(parse_part(wrong, again)) << wrong;
}

}  // namespace
}  // namespace poinsot
