// The hash of a film's coded packets, by which its record and its pictures know each other without
// being decoded. Containers and what they say besides play no part, so a film that another program
// has put into another container still has its hash.
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
// its chunks' hashes, each on a line of its own; so the lists of a film's parts, one after the
// other, are that of the film.
class PacketHash {
 public:
    explicit PacketHash(std::int64_t n_chunk_packets) : n_chunk_packets_(n_chunk_packets) {}

    // A packet, and what comes beside it (the alpha plane's).
    void add(std::span<const std::uint8_t> packet, std::span<const std::uint8_t> beside = {});

    std::vector<std::string> chunks();  // what was added since the last whole chunk is one
    std::string of_film();

 private:
    void end_chunk();

    std::int64_t n_chunk_packets_;
    std::int64_t n_in_chunk_ = 0;
    Sha256 chunk_;
    std::vector<std::string> chunks_;
};

// Of the film in a file. Throws InputError for what is no film.
std::string packet_hash_of(const std::filesystem::path& film);

// A GIF has no packets: of its bytes without comments, a chunk a picture, up to its end or its
// trailer. Throws InputError, with the name, for what is no GIF.
PacketHash gif_packets(std::span<const std::uint8_t> file, const std::string& name);

// The number of bytes up to a GIF's trailer, which is the last of them. Throws as gif_packets does,
// for one without a trailer, too.
std::size_t end_of_gif(std::span<const std::uint8_t> file, const std::string& name);

}  // namespace poinsot
