// The hash of a file around a text, wherever the text lies, beside the hash of the bytes
// themselves.
#include "encoding/film_file_hash.h"

#include <gtest/gtest.h>

#include "encoding/films.h"
#include "system/sha256.h"

namespace poinsot {
namespace {

// Files are read in pieces of this size.
constexpr std::size_t piece = 1 << 20;

TEST(FileHash, IsThatOfTheBytesAroundTheRecord) {
    const TemporaryFolder folder;
    const std::string record = "a record, " + std::string(3000, 'r') + " and its end";
    const std::string film(2 * piece + 5000, 'a');  // begins as the record does, again and again
    for (const std::size_t at : {std::size_t{0}, std::size_t{7}, piece - record.size(), piece - 1,
                                 piece, 2 * piece - 100, film.size()}) {
        const std::string before = film.substr(0, at), after = film.substr(at);
        std::ofstream(folder / "a.mp4", std::ios::binary) << before << record << after;
        EXPECT_EQ(file_hash_of(folder / "a.mp4", record), sha256_of(before + after)) << at;
    }
    // Of two, the first counts.
    std::ofstream(folder / "a.mp4", std::ios::binary) << "x" << record << "y" << record;
    EXPECT_EQ(file_hash_of(folder / "a.mp4", record), sha256_of("xy" + record));
}

TEST(FileHash, OfAFileWithoutTheRecordIsNone) {
    const TemporaryFolder folder;
    const std::string record = "a record";
    for (const std::string& bytes :
         {std::string(), std::string("a recor"), std::string(3 * piece, 'a')}) {
        std::ofstream(folder / "a.mp4", std::ios::binary) << bytes;
        EXPECT_EQ(file_hash_of(folder / "a.mp4", record), std::nullopt);
        EXPECT_EQ(file_hash_of(folder / "a.mp4", ""), std::nullopt);
    }
}

class FilmFileHash : public ::testing::TestWithParam<const char*> {};

// Whatever the record says, the bytes around it are the same.
TEST_P(FilmFileHash, IsPutIntoTheRecordOfAFilm) {
    const TemporaryFolder folder;
    OutputPlan plan = small_plan(folder / GetParam(), 7);
    std::string told;
    plan.seal = [&told](const std::string& metadata, const EncodedMetadata& contents) {
        told = metadata + contents.packets + contents.file;
        return told;
    };
    write_film(plan);
    const std::string film = bytes_of(plan.path);
    const std::size_t at = film.find(told);
    ASSERT_NE(at, std::string::npos);
    std::string around = film;
    around.erase(at, told.size());
    EXPECT_EQ(told.substr(told.size() - 64), sha256_of(around));
    EXPECT_EQ(file_hash_of(plan.path, told), sha256_of(around));
}

INSTANTIATE_TEST_SUITE_P(Formats, FilmFileHash, ::testing::Values("a.mp4", "a.webm", "a.mov"),
                         [](const auto& tested) { return std::string(tested.param).substr(2); });

}  // namespace
}  // namespace poinsot
