// The end of a film, from its container's structure.
#include "encoding/film_end.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "encoding/films.h"

namespace poinsot {
namespace {

// A number of n_bytes bytes, the highest first.
std::string high_first(std::uint64_t number, std::size_t n_bytes) {
    std::string text(n_bytes, '\0');
    for (std::size_t k = n_bytes; k > 0; number >>= 8) text[--k] = static_cast<char>(number & 0xff);
    return text;
}

std::string box(const std::string& type, std::size_t n_bytes_inside = 5) {
    return high_first(8 + n_bytes_inside, 4) + type + std::string(n_bytes_inside, 'x');
}
std::string long_box(const std::string& type) {
    return high_first(1, 4) + type + high_first(16 + 3, 8) + "xxx";
}

std::optional<std::uintmax_t> end_of_bytes(const std::string& bytes) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.film", std::ios::binary) << bytes;
    return end_of_film(folder / "a.film");
}

class FilmEnd : public ::testing::TestWithParam<const char*> {};

TEST_P(FilmEnd, IsTheFilesAndDoesNotMoveWhenDataFollows) {
    const TemporaryFolder folder;
    OutputPlan plan = small_plan(folder / GetParam(), 7);
    plan.chapters = {{"One", 0, 3}, {"Two", 3, 7}};
    plan.subtitles = {{"Said", 0, 100, false}};
    write_film(plan);
    const std::string film = bytes_of(plan.path);
    EXPECT_EQ(end_of_film(plan.path), film.size());
    for (const std::string& more :
         {std::string("x"), std::string(5, '\0'), std::string(100, '\xff'),
          std::string("no box, no element, no block"), box("mdat"), box("free"), film})
        EXPECT_EQ(end_of_bytes(film + more), film.size()) << more.size() << " bytes more";
}

INSTANTIATE_TEST_SUITE_P(Formats, FilmEnd, ::testing::Values("a.mp4", "a.webm", "a.mov", "a.gif"),
                         [](const auto& tested) { return std::string(tested.param).substr(2); });

TEST(FilmEnd, IsFoundInFilmsOfOtherPrograms) {
    for (const std::string& film :
         {box("ftyp") + box("wide", 0) + box("mdat") + box("moov"),
          box("ftyp") + box("free") + long_box("mdat") + box("moov"),
          box("ftyp") + box("moov") + box("styp") + box("sidx") + box("moof") + box("mdat") +
              box("moof") + box("mdat") + box("mfra")}) {
        EXPECT_EQ(end_of_bytes(film), film.size());
        EXPECT_EQ(end_of_bytes(film + film), film.size());
        EXPECT_EQ(end_of_bytes(film + "junk"), film.size());
        // A box that is longer than the file ends at its stated size.
        EXPECT_EQ(end_of_bytes(film.substr(0, film.size() - 1)), film.size());
    }
}

TEST(FilmEnd, IsUnknownIfTheContainerDoesNotStoreIt) {
    const std::string header = "\x1a\x45\xdf\xa3\x81x", segment = "\x18\x53\x80\x67";
    EXPECT_EQ(end_of_bytes(header + segment + "\x82xx"), 13u);
    // A size that was unknown when it was written, and data up to the end of the file.
    EXPECT_EQ(end_of_bytes(header + segment + "\xffxx"), std::nullopt);
    EXPECT_EQ(end_of_bytes(header + segment + "\x01\xff\xff\xff\xff\xff\xff\xffxx"), std::nullopt);
    EXPECT_EQ(end_of_bytes(box("ftyp") + box("moov") + high_first(0, 4) + "mdatxxx"), std::nullopt);
    EXPECT_EQ(end_of_bytes("RIFFxxxxAVI LISTxxxx"), std::nullopt);
    EXPECT_EQ(end_of_bytes(""), std::nullopt);
    EXPECT_THROW(end_of_bytes("GIF89a cut short"), InputError);
}

}  // namespace
}  // namespace poinsot
