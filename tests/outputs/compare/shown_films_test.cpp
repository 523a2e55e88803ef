// Films of the same coded pictures that players show otherwise: turned, stretched, at other times.
#include <gtest/gtest.h>

#include "compare/compared_picture.h"
#include "encoding/films.h"

namespace poinsot {
namespace {

class ShownFilms : public ::testing::Test {
 protected:
    void SetUp() override {
        plan_.quality = "lecture";  // with frames that are decoded before they are shown
        plan_.subtitles = {{"Said", 0, 100, false}};
        write_film(plan_);
        film_ = bytes_of(plan_.path);
    }
    // Compares the film with one that has other bytes at some place after a box's name.
    ComparedPicture with(const std::string& box, std::size_t at, const std::string& bytes) const {
        std::string other = film_;
        other.replace(other.find(box) + box.size() + at, bytes.size(), bytes);
        EXPECT_NE(other, film_);
        std::ofstream(folder_ / "b.mp4", std::ios::binary) << other;
        return compare_files("b.mp4", plan_.path, folder_ / "b.mp4", {});
    }

    TemporaryFolder folder_;
    OutputPlan plan_ = small_plan(folder_ / "a.mp4", 12);
    std::string film_;
};

// ISO/IEC 14496-12 §8.3.2: version and flags, five times and numbers, reserved, layer, group and
// volume, the matrix, width and height.
constexpr std::size_t matrix_at = 40, width_at = 76, height_at = 80;

TEST_F(ShownFilms, WhoseTrackIsOffAreNotTheSame) {
    // Flags: enabled, in the film, in its preview.
    EXPECT_EQ(with("tkhd", 3, "\1").outcome, Outcome::same);
    for (const char* off : {"\2", "\6"}) {
        const ComparedPicture hidden = with("tkhd", 3, off);
        EXPECT_EQ(hidden.outcome, Outcome::size);
        EXPECT_EQ(
            hidden.reason,
            "expected a track of pictures that is switched on, found one that is switched off");
    }
}

// The edit list says that the film begins with its first picture.
TEST_F(ShownFilms, WithoutTheirEditListAreNotTheSame) {
    const ComparedPicture late = with("edts", std::size_t{0} - 4, "free");
    EXPECT_EQ(late.outcome, Outcome::rate) << late.reason;
}

TEST_F(ShownFilms, ThatAreTurnedOrMirroredAreNotTheSame) {
    const std::string minus_one("\xff\xff\0\0", 4), zero(4, '\0'), one("\0\1\0\0", 4);
    const auto matrix = [](const std::string& a, const std::string& b, const std::string& c,
                           const std::string& d) { return a + b + std::string(4, '\0') + c + d; };
    for (const auto& [words, bytes] :
         {std::pair{"turned by 180°", matrix(minus_one, zero, zero, minus_one)},
          std::pair{"turned by 90° clockwise", matrix(zero, one, minus_one, zero)},
          std::pair{"turned by 90° counter-clockwise", matrix(zero, minus_one, one, zero)},
          std::pair{"mirrored left to right", matrix(minus_one, zero, zero, one)},
          std::pair{"mirrored top to bottom", matrix(one, zero, zero, minus_one)}}) {
        const ComparedPicture turned = with("tkhd", matrix_at, bytes);
        EXPECT_EQ(turned.outcome, Outcome::size) << words;
        EXPECT_EQ(turned.reason,
                  std::string("expected pictures that are shown upright, found ") + words);
    }
}

TEST_F(ShownFilms, WhosePixelsAreStretchedAreNotTheSame) {
    const ComparedPicture low = with("tkhd", height_at, std::string("\0\x18\0\0", 4));
    EXPECT_EQ(low.outcome, Outcome::size);
    EXPECT_EQ(low.reason, "expected a pixel aspect of 1:1, found 2:1");
    EXPECT_EQ(with("tkhd", width_at, std::string("\0\x20\0\0", 4)).outcome, Outcome::size);
}

TEST_F(ShownFilms, WithOtherColoursAreNotTheSame) {
    // H.264 has colours of its own, which count; VP9 has none. RFC 9559: Primaries, an integer of
    // one byte: BT.709, BT.2020.
    plan_.path = folder_ / "a.webm";
    write_film(plan_);
    std::string other = bytes_of(plan_.path);
    other.replace(other.find("\x55\xbb\x81\x1"), 4, "\x55\xbb\x81\x9");
    std::ofstream(folder_ / "b.webm", std::ios::binary) << other;
    const ComparedPicture film = compare_files("b.webm", plan_.path, folder_ / "b.webm", {});
    EXPECT_EQ(film.outcome, Outcome::colours);
    EXPECT_EQ(film.reason,
              "expected the primaries bt709 and the transfer bt709, found bt2020 and bt709");
}

TEST_F(ShownFilms, WithFramesAtOtherTimesAreNotTheSame) {
    // §8.6.1.2: one entry, so many frames, of so many ticks each.
    const std::size_t stts = film_.find("stts");
    EXPECT_EQ(film_.substr(stts + 8, 8), std::string("\0\0\0\1\0\0\0\xc", 8));
    const std::string ticks = film_.substr(stts + 16, 4);
    const std::string half{ticks[0], ticks[1], static_cast<char>(ticks[2] / 2), ticks[3]};
    const ComparedPicture fast = with("stts", 12, half);
    EXPECT_EQ(fast.outcome, Outcome::rate) << fast.reason;
    // §8.6.1.3: the third frame is shown 0x400 ticks, two frames, later.
    const std::size_t ctts = film_.find("ctts");
    ASSERT_NE(ctts, std::string::npos);
    std::string offset = film_.substr(ctts + 4 + 8 + 2 * 8 + 4, 4);
    offset[2] = static_cast<char>(offset[2] ^ 8);
    const ComparedPicture late = with("ctts", 8 + 2 * 8 + 4, offset);
    EXPECT_EQ(late.outcome, Outcome::rate) << late.reason;
    EXPECT_EQ(late.reason.find("frame "), 0u) << late.reason;
    EXPECT_NE(late.reason.find(" is shown at "), std::string::npos) << late.reason;
}

// A picture under the name of a film is called one.
TEST_F(ShownFilms, AreNotPictures) {
    write_png(folder_ / "b.mp4", frame_of(plan_, 0));
    const ComparedPicture picture = compare_files("b.mp4", plan_.path, folder_ / "b.mp4", {});
    EXPECT_EQ(picture.outcome, Outcome::unreadable);
    EXPECT_EQ(picture.reason,
              (folder_ / "b.mp4").string() + " is a picture, not a film; name it .png");
}

}  // namespace
}  // namespace poinsot
