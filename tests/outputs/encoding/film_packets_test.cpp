// The hash of a film's packets: the same while writing and from the file, and different for a
// changed film.
#include "encoding/film_packets.h"

#include <gtest/gtest.h>

#include "encoding/films.h"

namespace poinsot {
namespace {

std::span<const std::uint8_t> bytes_of_text(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// Computed in python3: each chunk hashlib.sha256 of struct.pack(">Q", len(p)) + p of its packets p;
// the film's of their hexadecimal digits, "\n" after each.
TEST(PacketHash, IsTheHashOfTheListOfChunks) {
    PacketHash hash(2);
    for (const char* packet : {"ab", "c", "def"}) hash.add(bytes_of_text(packet));
    EXPECT_EQ(hash.of_film(), "b6eb336aa2ca2d91bbe548696c467bbe2e33c4cf6d183787e00c094386321e83");
}

// Parts that end at chunks are joined without hashing their packets again.
TEST(PacketHash, OfAFilmFollowsFromThoseOfItsParts) {
    PacketHash film(3), first(3), second(3);
    for (int k = 0; k < 8; ++k) {
        const std::string packet(static_cast<std::size_t>(k), 'x');
        film.add(bytes_of_text(packet));
        (k < 6 ? first : second).add(bytes_of_text(packet));
    }
    std::vector<std::string> joined = first.chunks();
    for (const std::string& chunk : second.chunks()) joined.push_back(chunk);
    EXPECT_EQ(film.chunks(), joined);
}

class FilmPackets : public ::testing::TestWithParam<const char*> {
 protected:
    // Writes the film and returns the hash that was passed to its metadata.
    std::string write(OutputPlan plan) const {
        std::string told;
        plan.seal = [&told](const std::string& metadata, const EncodedMetadata& contents) {
            told = contents.packets;
            EXPECT_EQ(contents.n_frames, 130);
            return metadata + told;
        };
        write_film(plan);
        return told;
    }
    TemporaryFolder folder_;
    OutputPlan plan_ = small_plan(folder_ / GetParam(), 130);
};

TEST_P(FilmPackets, AreReadBackFromTheFile) {
    const std::string told = write(plan_);
    EXPECT_EQ(packet_hash_of(plan_.path), told);
    EXPECT_EQ(VideoReader(plan_.path).info().n_frames, 130);
    // The hash does not depend on the metadata.
    OutputPlan other = plan_;
    other.metadata = std::string(3000, 'y');
    EXPECT_EQ(write(other), told);
    EXPECT_EQ(packet_hash_of(other.path), told);
}

TEST_P(FilmPackets, DifferWhereABitIsChanged) {
    const std::string told = write(plan_);
    const std::string film = bytes_of(plan_.path);
    for (const double share : {0.6, 0.8, 0.9}) {
        std::string changed = film;
        char& byte = changed[static_cast<std::size_t>(share * static_cast<double>(film.size()))];
        byte = static_cast<char>(byte ^ 4);
        std::ofstream(plan_.path, std::ios::binary) << changed;
        std::string found = "refused";
        try {
            found = packet_hash_of(plan_.path);
        } catch (const InputError&) {
            // An unreadable film is detected, too.
            EXPECT_EQ(found, "refused");
        }
        EXPECT_NE(found, told) << share;
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, FilmPackets,
                         ::testing::Values("a.mp4", "a.webm", "a.mov", "a.gif"),
                         [](const auto& tested) { return std::string(tested.param).substr(2); });

TEST(FilmPackets, WithTransparencyAreReadBack) {
    const TemporaryFolder folder;
    OutputPlan plan = small_plan(folder / "a.webm", 3);
    std::string told;
    plan.seal = [&told](const std::string& metadata, const EncodedMetadata& contents) {
        told = contents.packets;
        return metadata;
    };
    const auto sink = format_for(plan.path).open(plan);
    for (int k = 0; k < 3; ++k) {
        Image frame = frame_of(plan, k);
        for (std::size_t i = 3; i < frame.bytes().size(); i += 8) frame.bytes()[i] = 90;
        sink->write(frame);
    }
    sink->finish();
    EXPECT_EQ(packet_hash_of(plan.path), told);
}

TEST(FilmPackets, OfOtherFilesAreRefused) {
    const TemporaryFolder folder;
    for (const char* name : {"a.mp4", "a.webm", "a.mov", "a.gif"}) {
        std::ofstream(folder / name) << "GIF no film";
        EXPECT_THROW(packet_hash_of(folder / name), InputError) << name;
        EXPECT_THROW(packet_hash_of(folder / ("none" + std::string(name))), EnvironmentError)
            << name;
    }
}

}  // namespace
}  // namespace poinsot
