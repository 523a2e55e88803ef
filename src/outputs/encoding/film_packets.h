// The hash of a film's coded packets: it links a film to its record and its pictures without
// decoding. The hash does not depend on the container and its metadata, so a film that another
// program has put into another container still has its hash.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "system/sha256.h"

namespace poinsot {

// A chunk's hash is that of its packets, in the order in which they are stored: SHA-256 of the size
// of each, eight bytes, the highest first, and its contents. A film's hash is that of the list of
// its chunks' hashes, each on its own line; the concatenated lists of a film's parts are
// therefore the list of the film.
class PacketHash {
 public:
    explicit PacketHash(std::int64_t n_chunk_packets) : n_chunk_packets_(n_chunk_packets) {}

    // Adds a packet and its side data (the alpha plane's).
    void add(std::span<const std::uint8_t> packet, std::span<const std::uint8_t> side_data = {});

    std::vector<std::string> chunks();  // packets since the last whole chunk count as one chunk
    std::string of_film();

 private:
    void end_chunk();

    std::int64_t n_chunk_packets_;
    std::int64_t n_in_chunk_ = 0;
    Sha256 chunk_;
    std::vector<std::string> chunks_;
};

// Returns the hash of the film in a file. Throws InputError for a file that is not a film.
std::string packet_hash_of(const std::filesystem::path& film);

// A GIF has no packets: hashes its bytes without comments, one chunk per picture, up to the end or
// the trailer. Throws InputError, with the name, for a file that is not a GIF.
PacketHash gif_packets(std::span<const std::uint8_t> file, const std::string& name);

// Returns the number of bytes up to and including a GIF's trailer. Throws like gif_packets, and
// also for a GIF without a trailer.
std::size_t end_of_gif(std::span<const std::uint8_t> file, const std::string& name);

}  // namespace poinsot
