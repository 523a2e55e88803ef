#include "encoding/film_packets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <utility>

#include "encoding/formats.h"
#include "encoding/libav.h"
#include "encoding/video_encoder.h"
#include "error/error.h"
#include "system/files/file_contents.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

std::string hash_of_stream(const fs::path& film) {
    const auto check = [&film](int result) {
        if (result < 0)
            throw InputError(fmt::format("{} cannot be read as a film: {}", film.string(),
                                         libav::error_text(result)));
        return result;
    };
    const libav::DemuxContext input = libav::open_film(film);
    AVFormatContext* const context = input.get();
    const int stream = check(av_find_best_stream(context, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0));
    const libav::Packet packet = libav::make_packet();
    PacketHash hash(frames_a_chunk);
    for (int result = 0; (result = av_read_frame(context, packet.get())) != AVERROR_EOF;) {
        check(result);
        if (packet->stream_index == stream) {
            std::size_t n_side_bytes = 0;
            const std::uint8_t* const side_data = av_packet_get_side_data(
                packet.get(), AV_PKT_DATA_MATROSKA_BLOCKADDITIONAL, &n_side_bytes);
            hash.add({packet->data, static_cast<std::size_t>(packet->size)},
                     {side_data, n_side_bytes});
        }
        av_packet_unref(packet.get());
    }
    return hash.of_film();
}

// Parses a GIF from its beginning. Source: GIF89a specification, §17–27.
class GifReader {
 public:
    GifReader(std::span<const std::uint8_t> file, std::string name)
        : file_(file), name_(std::move(name)) {}

    PacketHash packets() {
        PacketHash hash(1);
        std::vector<std::uint8_t> picture;
        const auto take = [&](std::size_t n_bytes) {
            const auto bytes = next(n_bytes);
            picture.insert(picture.end(), bytes.begin(), bytes.end());
            return bytes;
        };
        const auto take_blocks = [&] {
            while (const std::size_t size = take(1)[0]) take(size);
        };
        constexpr std::size_t flags_at = 10;
        const auto head = take(13);
        if (!std::equal(head.begin(), head.begin() + 3, "GIF")) refuse();
        take(colours_of(head[flags_at]));
        while (at_ < file_.size() && file_[at_] != trailer_byte) {
            const bool is_comment = file_[at_] == extension_byte && file_.size() - at_ > 1 &&
                                    file_[at_ + 1] == comment_label;
            const std::size_t before = picture.size();
            if (file_[at_] == extension_byte) {
                take(2);
                take_blocks();
            } else if (file_[at_] == image_byte) {
                take(colours_of(take(10)[9]));
                take(1);
                take_blocks();
                hash.add(picture);
                picture.clear();
                continue;
            } else {
                refuse();
            }
            if (is_comment) picture.resize(before);
        }
        if (!picture.empty()) hash.add(picture);
        return hash;
    }

    std::size_t end() {
        packets();
        next(1);
        return at_;
    }

 private:
    static constexpr std::uint8_t extension_byte = 0x21, image_byte = 0x2c, trailer_byte = 0x3b,
                                  comment_label = 0xfe;

    // Size in bytes of the colour table that the flags announce.
    static std::size_t colours_of(std::uint8_t flags) {
        return flags & 0x80 ? std::size_t{3} << ((flags & 7) + 1) : 0;
    }

    std::span<const std::uint8_t> next(std::size_t n_bytes) {
        if (n_bytes > file_.size() - at_) refuse();
        at_ += n_bytes;
        return file_.subspan(at_ - n_bytes, n_bytes);
    }

    [[noreturn]] void refuse() const {
        throw InputError(fmt::format("{} cannot be read as a GIF", name_));
    }

    std::span<const std::uint8_t> file_;
    std::string name_;
    std::size_t at_ = 0;
};

}  // namespace

void PacketHash::add(std::span<const std::uint8_t> packet,
                     std::span<const std::uint8_t> side_data) {
    for (const auto part : {packet, side_data}) {
        if (part.empty()) continue;
        std::array<std::uint8_t, 8> size{};
        for (std::size_t i = 0; i < size.size(); ++i)
            size[i] = static_cast<std::uint8_t>(std::uint64_t{part.size()} >> (56 - 8 * i));
        chunk_.add(size);
        chunk_.add(part);
    }
    if (++n_in_chunk_ == n_chunk_packets_) end_chunk();
}

void PacketHash::end_chunk() {
    if (n_in_chunk_ == 0) return;
    chunks_.push_back(chunk_.finish());
    chunk_ = {};
    n_in_chunk_ = 0;
}

std::vector<std::string> PacketHash::chunks() {
    end_chunk();
    return chunks_;
}

std::string PacketHash::of_film() {
    std::string list;
    for (const std::string& chunk : chunks()) list += chunk + "\n";
    return sha256_of(list);
}

PacketHash gif_packets(std::span<const std::uint8_t> file, const std::string& name) {
    return GifReader(file, name).packets();
}

std::size_t end_of_gif(std::span<const std::uint8_t> file, const std::string& name) {
    return GifReader(file, name).end();
}

std::string packet_hash_of(const fs::path& film) {
    constexpr std::string_view gif = "GIF";
    if (read_beginning(film, gif.size()) != gif) return hash_of_stream(film);
    return gif_packets(read_bytes(film), film.string()).of_film();
}

}  // namespace poinsot
