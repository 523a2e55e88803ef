// A bit that is flipped anywhere in a film is seen. Which boxes and elements decide what a player
// shows is written down here from the containers' specifications; tests/trust/film_flips.py asks
// ffprobe, with thousands of random bits.
#include "production/records/verify.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "encoding/films.h"
#include "system/sha256.h"

namespace poinsot {
namespace {

constexpr std::int64_t n_film_frames = 9;

// The text of a record without what is known only after encoding.
std::string record_of_a_film(const OutputPlan& plan) {
    Record record;
    record.version = "1.0.0";
    record.scene_name = "scene";
    record.scene_toml = "theme = \"light\"\n";
    record.scene_hash = sha256_of(record.scene_toml);
    record.method = "exact";
    record.bounds = "none";
    record.renderer = "none";
    record.mesa = "none";
    record.width_px = plan.width_px;
    record.height_px = plan.height_px;
    record.frames = {0, plan.n_frames - 1};
    return to_text(record);
}

class RecordedFilm : public ::testing::TestWithParam<const char*> {
 protected:
    void SetUp() override {
        plan_.quality = "lecture";
        plan_.metadata = record_of_a_film(plan_);
        plan_.seal = sealed_metadata;
        plan_.chapters = {{"One", 0, 4}, {"Two", 4, n_film_frames}};
        plan_.subtitles = {{"Said at the top", 0, 100, true}, {"Said below", 120, 250, false}};
        write_film(plan_);
        film_ = bytes_of(plan_.path);
    }
    bool is_gif() const { return plan_.path.extension() == ".gif"; }

    // As `explain --verify` reads a file with these bytes. A file that cannot be read is changed,
    // and its sentence says why.
    Verification verification_of(const std::string& bytes) const {
        const std::filesystem::path file = folder_ / ("b" + plan_.path.extension().string());
        std::ofstream(file, std::ios::binary) << bytes;
        try {
            return verify(file, read_record(file));
        } catch (const InputError& error) {
            return {Verified::no, error.what()};
        }
    }
    Verification with_flipped(std::size_t byte, unsigned bit) const {
        std::string bytes = film_;
        bytes.at(byte) = static_cast<char>(static_cast<unsigned char>(bytes[byte]) ^ 1U << bit);
        return verification_of(bytes);
    }

    TemporaryFolder folder_;
    OutputPlan plan_ = small_plan(folder_ / GetParam(), n_film_frames);
    std::string film_;
};

INSTANTIATE_TEST_SUITE_P(Formats, RecordedFilm,
                         ::testing::Values("a.mp4", "a.webm", "a.mov", "a.gif"),
                         [](const auto& tested) { return std::string(tested.param).substr(2); });

// What the bytes after the name of a box or an element decide.
struct Decided {
    std::string_view name;
    std::size_t n_bytes;  // after it, that are flipped
};

TEST_P(RecordedFilm, IsSeenToBeChangedWhereOneBitDecidesWhatIsShown) {
    using namespace std::string_view_literals;
    // ISO/IEC 14496-12: headers of the film and its tracks with matrices, durations and sizes;
    // times and order of samples; where they are; edit lists; colours and pixels' shape; texts.
    static const std::vector<Decided> boxes{
        {"ftyp", 16}, {"mvhd", 100}, {"tkhd", 84}, {"mdhd", 24}, {"hdlr", 20}, {"elst", 20},
        {"stsd", 40}, {"stts", 16},  {"stsc", 20}, {"stsz", 12}, {"stco", 12}, {"colr", 11},
        {"tx3g", 30}, {"keys", 20},  {"text", 4},  {"mdat", 40}};
    // RFC 9559: scale of times, duration of the film and of a frame, size in pixels and as shown,
    // colours, index, time of a cluster, times of blocks.
    static const std::vector<Decided> elements{
        {"\x2a\xd7\xb1"sv, 4},      {"\x44\x89"sv, 9},          {"\x23\xe3\x83"sv, 5},
        {"\xb0\x81"sv, 1},          {"\xba\x81"sv, 1},          {"\x55\xb0"sv, 9},
        {"\x1c\x53\xbb\x6b"sv, 30}, {"\x1f\x43\xb6\x75"sv, 16}, {"D_WEBVTT"sv, 8}};
    // GIF89a: size, colours, background and pixels' shape; loops; delays, disposal and
    // transparency.
    static const std::vector<Decided> blocks{
        {"GIF89a", 20}, {"NETSCAPE2.0", 5}, {"\x21\xf9\x04"sv, 5}, {"\x21\xfe"sv, 20}};
    const std::string kind = plan_.path.extension().string();
    std::vector<Decided> all = kind == ".gif" ? blocks : kind == ".webm" ? elements : boxes;
    // Only H.264 shows frames in another order than that of decoding, and only QuickTime says how
    // wide pixels are that are square.
    if (kind == ".mp4") all.push_back({"ctts", 20});
    if (kind == ".mov") all.push_back({"pasp", 8});
    ASSERT_EQ(verification_of(film_).verified, Verified::yes) << verification_of(film_).sentence;
    unsigned bit = 0;
    for (const Decided& decided : all) {
        const std::size_t at = film_.find(decided.name);
        ASSERT_NE(at, std::string::npos) << decided.name;
        for (std::size_t k = 0; k < decided.n_bytes; ++k) {
            bit = (bit + 3) % 8;
            const std::size_t byte = at + decided.name.size() + k;
            EXPECT_NE(with_flipped(byte, bit).verified, Verified::yes)
                << decided.name << ", bit " << bit << " of the byte after " << k;
        }
    }
}

TEST_P(RecordedFilm, IsSeenToBeChangedWhereverABitIs) {
    std::uint32_t random = 47;
    for (int k = 0; k < 100; ++k) {
        random = 1664525 * random + 1013904223;
        const std::size_t byte = (random >> 4) % film_.size();
        EXPECT_NE(with_flipped(byte, random >> 29).verified, Verified::yes)
            << "bit " << (random >> 29) << " of byte " << byte;
    }
}

// Pictures alone are told from everything else, for films that another program has rewritten.
TEST_P(RecordedFilm, SaysWhereOnlyThePicturesAreUnchanged) {
    if (is_gif() || plan_.path.extension() == ".webm") return;  // they have no such matrix
    // a and d of the first track's matrix: the picture is turned by 180°.
    constexpr std::size_t matrix_at = 44;
    std::string turned = film_;
    for (const std::size_t place : {0, 16})
        turned.replace(turned.find("tkhd") + matrix_at + place, 4, std::string("\xff\xff\0\0", 4));
    const Verification verification = verification_of(turned);
    EXPECT_EQ(verification.verified, Verified::no);
    EXPECT_EQ(verification.sentence.find("its record and its coded pictures are unchanged, but "
                                         "other data are not: it is shown turned or mirrored; "),
              0u)
        << verification.sentence;
}

// Older versions wrote no hash of the file.
TEST_P(RecordedFilm, OfAnOlderVersionIsVerifiedAsFarAsItsRecordGoes) {
    plan_.seal = [](const std::string& metadata, EncodedMetadata contents) {
        contents.file.clear();
        return sealed_metadata(metadata, contents);
    };
    write_film(plan_);
    const Verification verification = verification_of(bytes_of(plan_.path));
    EXPECT_EQ(verification.verified, is_gif() ? Verified::yes : Verified::cannot_be);
    if (is_gif()) return;
    EXPECT_EQ(verification.sentence.find("its record and its coded pictures are unchanged, but"),
              0u)
        << verification.sentence;
}

}  // namespace
}  // namespace poinsot
