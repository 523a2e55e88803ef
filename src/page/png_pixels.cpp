// Reads PNG pictures for the faces of bodies, in a page: the module has neither libpng nor zlib. As
// src/image/png_read.cpp, for sRGB pictures without interlacing of 1 to 16 bits.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "error/error.h"
#include "image/png.h"

namespace poinsot {

namespace {

using Bytes = std::span<const std::uint8_t>;

[[noreturn]] void refuse(const std::string& name, std::string_view what) {
    throw InputError(fmt::format("{}: {}", name, what));
}

// RFC 1951. The code of a symbol is canonical: it follows from the lengths of all codes.
class Codes {
 public:
    explicit Codes(std::span<const std::uint8_t> lengths) {
        for (const std::uint8_t length : lengths) ++n_of_length_[length];
        n_of_length_[0] = 0;
        std::array<std::uint16_t, 16> first{};
        for (std::size_t k = 1; k < 15; ++k)
            first[k + 1] = static_cast<std::uint16_t>(first[k] + n_of_length_[k]);
        symbols_.resize(lengths.size());
        for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol)
            if (lengths[symbol] != 0)
                symbols_[first[lengths[symbol]]++] = static_cast<std::uint16_t>(symbol);
    }

    // `next_bit` returns one bit. -1: no code.
    template <typename NextBit>
    int take(NextBit next_bit) const {
        int code = 0, first = 0, index = 0;
        for (std::size_t length = 1; length < 16; ++length) {
            code |= next_bit();
            const int n = n_of_length_[length];
            if (code - n < first) return symbols_[static_cast<std::size_t>(index + code - first)];
            index += n;
            first = (first + n) << 1;
            code <<= 1;
        }
        return -1;
    }

 private:
    std::array<std::uint16_t, 16> n_of_length_{};
    std::vector<std::uint16_t> symbols_;
};

class Inflater {
 public:
    // `size`: of what comes out, beyond which nothing is read.
    Inflater(Bytes bytes, std::size_t size) : bytes_(bytes), size_(size) {}

    // False: the data are damaged.
    bool inflate(std::vector<std::uint8_t>& out) {
        bool is_last = false;
        while (!is_last) {
            is_last = bits(1) == 1;
            const int kind = bits(2);
            const bool is_well = kind == 0   ? copy_stored(out)
                                 : kind == 1 ? inflate_fixed(out)
                                 : kind == 2 ? inflate_dynamic(out)
                                             : false;
            if (!is_well || is_over_ || out.size() > size_) return false;
        }
        return true;
    }

 private:
    int bit() {
        if (at_ >= bytes_.size()) {
            is_over_ = true;
            return 0;
        }
        const int value = (bytes_[at_] >> bit_) & 1;
        if (++bit_ == 8) {
            bit_ = 0;
            ++at_;
        }
        return value;
    }
    int bits(int n) {
        int value = 0;
        for (int k = 0; k < n; ++k) value |= bit() << k;
        return value;
    }

    bool copy_stored(std::vector<std::uint8_t>& out) {
        if (bit_ != 0) {
            bit_ = 0;
            ++at_;
        }
        const auto n = static_cast<std::size_t>(bits(16));
        bits(16);
        if (is_over_ || bytes_.size() - at_ < n) return false;
        out.insert(out.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(at_),
                   bytes_.begin() + static_cast<std::ptrdiff_t>(at_ + n));
        at_ += n;
        return true;
    }

    bool inflate_with(const Codes& literals, const Codes& distances,
                      std::vector<std::uint8_t>& out) {
        static constexpr std::array<int, 29> bases{3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                                   15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                                   67, 83, 99, 115, 131, 163, 195, 227, 258};
        static constexpr std::array<int, 29> extra{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                                   2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
        const auto next = [this] { return bit(); };
        while (!is_over_ && out.size() <= size_) {
            const int symbol = literals.take(next);
            if (symbol < 0) return false;
            if (symbol < 256) {
                out.push_back(static_cast<std::uint8_t>(symbol));
                continue;
            }
            if (symbol == 256) return true;
            const auto row = static_cast<std::size_t>(symbol - 257);
            if (row >= bases.size()) return false;
            const int length = bases[row] + bits(extra[row]);
            const int far = distances.take(next);
            if (far < 0 || far > 29) return false;
            const int n_extra = std::max(0, far / 2 - 1);
            const int base = far < 2 ? far + 1 : ((2 + far % 2) << n_extra) + 1;
            const auto distance = static_cast<std::size_t>(base + bits(n_extra));
            if (distance > out.size()) return false;
            for (int k = 0; k < length; ++k) out.push_back(out[out.size() - distance]);
        }
        return false;
    }

    bool inflate_fixed(std::vector<std::uint8_t>& out) {
        std::array<std::uint8_t, 288> literals{};
        for (std::size_t k = 0; k < literals.size(); ++k)
            literals[k] = k < 144 ? 8 : k < 256 ? 9 : k < 280 ? 7 : 8;
        std::array<std::uint8_t, 30> distances{};
        distances.fill(5);
        return inflate_with(Codes(literals), Codes(distances), out);
    }

    bool inflate_dynamic(std::vector<std::uint8_t>& out) {
        static constexpr std::array<std::size_t, 19> order{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                           11, 4,  12, 3, 13, 2, 14, 1, 15};
        const auto n_literals = static_cast<std::size_t>(bits(5) + 257);
        const auto n_distances = static_cast<std::size_t>(bits(5) + 1);
        const auto n_lengths = static_cast<std::size_t>(bits(4) + 4);
        std::array<std::uint8_t, 19> of_lengths{};
        for (std::size_t k = 0; k < n_lengths; ++k)
            of_lengths[order[k]] = static_cast<std::uint8_t>(bits(3));
        const Codes codes(of_lengths);
        std::vector<std::uint8_t> lengths;
        while (lengths.size() < n_literals + n_distances) {
            const int symbol = codes.take([this] { return bit(); });
            if (symbol < 0 || is_over_ || (symbol == 16 && lengths.empty())) return false;
            if (symbol < 16) {
                lengths.push_back(static_cast<std::uint8_t>(symbol));
                continue;
            }
            const std::uint8_t value = symbol == 16 ? lengths.back() : std::uint8_t{0};
            const int n = symbol == 16 ? 3 + bits(2) : symbol == 17 ? 3 + bits(3) : 11 + bits(7);
            lengths.insert(lengths.end(), static_cast<std::size_t>(n), value);
        }
        if (lengths.size() > n_literals + n_distances) return false;
        const std::span all(lengths);
        return inflate_with(Codes(all.first(n_literals)), Codes(all.subspan(n_literals)), out);
    }

    Bytes bytes_;
    std::size_t size_, at_ = 0;
    int bit_ = 0;
    bool is_over_ = false;
};

std::uint32_t number_at(Bytes bytes, std::size_t at) {
    return (std::uint32_t{bytes[at]} << 24) | (std::uint32_t{bytes[at + 1]} << 16) |
           (std::uint32_t{bytes[at + 2]} << 8) | bytes[at + 3];
}

struct Parts {
    std::uint32_t width = 0, height = 0;
    int depth = 0, kind = 0;
    std::vector<std::uint8_t> palette, transparent, data;
    bool is_animated = false;
};

Parts parts_of(Bytes file, const std::string& name) {
    constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8);
    if (file.size() < 8 ||
        !std::equal(signature.begin(), signature.end(), file.begin(),
                    [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; }))
        refuse(name, "not a PNG picture");
    Parts parts;
    for (std::size_t at = 8; at + 12 <= file.size();) {
        const std::size_t size = number_at(file, at);
        if (size > file.size() - at - 12) refuse(name, "the PNG picture is incomplete");
        const std::string kind(file.begin() + static_cast<std::ptrdiff_t>(at + 4),
                               file.begin() + static_cast<std::ptrdiff_t>(at + 8));
        const Bytes data = file.subspan(at + 8, size);
        const auto take = [&data](std::vector<std::uint8_t>& to) {
            to.insert(to.end(), data.begin(), data.end());
        };
        if (kind == "IHDR" && size == 13) {
            parts.width = number_at(data, 0);
            parts.height = number_at(data, 4);
            parts.depth = data[8];
            parts.kind = data[9];
            if (data[12] != 0)
                refuse(name,
                       "an interlaced PNG picture, which a page cannot read; save it without "
                       "interlacing");
        }
        if (kind == "PLTE") take(parts.palette);
        if (kind == "tRNS") take(parts.transparent);
        if (kind == "IDAT") take(parts.data);
        if (kind == "acTL") refuse(name, "an animation; name a picture");
        if (kind == "IEND") return parts;
        at += size + 12;
    }
    refuse(name, "the PNG picture is incomplete");
}

int n_components_of(int kind) { return kind == 2 ? 3 : kind == 4 ? 2 : kind == 6 ? 4 : 1; }

// The rows without their filters (PNG specification, "Filtering").
std::vector<std::uint8_t> rows_of(const Parts& parts, std::size_t row_size, std::size_t step,
                                  const std::string& name) {
    const std::size_t n_rows = parts.height;
    std::vector<std::uint8_t> rows;
    if (parts.data.size() < 2 ||
        !Inflater(Bytes(parts.data).subspan(2), (row_size + 1) * n_rows).inflate(rows) ||
        rows.size() != (row_size + 1) * n_rows)
        refuse(name, "the PNG picture is damaged");
    std::vector<std::uint8_t> plain(row_size * n_rows);
    for (std::size_t y = 0; y < n_rows; ++y) {
        const std::uint8_t* const from = rows.data() + y * (row_size + 1);
        std::uint8_t* const to = plain.data() + y * row_size;
        for (std::size_t k = 0; k < row_size; ++k) {
            const int left = k >= step ? to[k - step] : 0;
            const int above =
                y > 0 ? to[static_cast<std::ptrdiff_t>(k) - static_cast<std::ptrdiff_t>(row_size)]
                      : 0;
            const int corner = k >= step && y > 0 ? to[static_cast<std::ptrdiff_t>(k - step) -
                                                       static_cast<std::ptrdiff_t>(row_size)]
                                                  : 0;
            int guess = 0;
            switch (from[0]) {
                case 1:
                    guess = left;
                    break;
                case 2:
                    guess = above;
                    break;
                case 3:
                    guess = (left + above) / 2;
                    break;
                case 4: {
                    const int p = left + above - corner;
                    const int a = std::abs(p - left), b = std::abs(p - above),
                              c = std::abs(p - corner);
                    guess = a <= b && a <= c ? left : b <= c ? above : corner;
                    break;
                }
                default:
                    break;
            }
            to[k] = static_cast<std::uint8_t>(from[k + 1] + guess);
        }
    }
    return plain;
}

}  // namespace

PngInfo decode_png_info(std::span<const std::uint8_t> file, const std::string& name) {
    const Parts parts = parts_of(file, name);
    if (parts.width == 0 || parts.height == 0 ||
        std::uint64_t{parts.width} * parts.height > static_cast<std::uint64_t>(most_png_pixels))
        refuse(name, "a PNG picture of a size that cannot be read");
    PngInfo info;
    info.width_px = static_cast<int>(parts.width);
    info.height_px = static_cast<int>(parts.height);
    info.bit_depth = parts.depth == 16 ? 16 : 8;
    return info;
}

Image decode_png(std::span<const std::uint8_t> file, const std::string& name, PngInfo* info) {
    const PngInfo own = decode_png_info(file, name);
    if (info != nullptr) *info = own;
    const Parts parts = parts_of(file, name);
    const int n = n_components_of(parts.kind);
    const auto depth = static_cast<std::size_t>(parts.depth);
    if (depth != 1 && depth != 2 && depth != 4 && depth != 8 && depth != 16)
        refuse(name, "the PNG picture is damaged");
    const std::size_t bits = static_cast<std::size_t>(n) * depth;
    const std::size_t row_size = (parts.width * bits + 7) / 8;
    const std::vector<std::uint8_t> rows =
        rows_of(parts, row_size, std::max<std::size_t>(1, bits / 8), name);
    const auto sample = [&](std::size_t y, std::size_t index) -> unsigned {
        const std::uint8_t* const row = rows.data() + y * row_size;
        if (depth == 16) return 256u * row[2 * index] + row[2 * index + 1];
        const std::size_t bit = index * depth;
        return (static_cast<unsigned>(row[bit / 8]) >> (8 - depth - bit % 8)) &
               ((1u << depth) - 1u);
    };
    const auto level = [depth](unsigned value) {
        if (depth == 16) return static_cast<std::uint8_t>((value * 255u + 32895u) >> 16);
        return static_cast<std::uint8_t>(value * 255u / ((1u << depth) - 1u));
    };
    const auto clear = [&parts](std::size_t k) {
        return 256u * parts.transparent[2 * k] + parts.transparent[2 * k + 1];
    };
    Image image(own.width_px, own.height_px);
    std::uint8_t* out = image.bytes().data();
    for (std::size_t y = 0; y < parts.height; ++y) {
        for (std::size_t x = 0; x < parts.width; ++x, out += 4) {
            std::array<unsigned, 4> s{};
            for (std::size_t c = 0; c < static_cast<std::size_t>(n); ++c)
                s[c] = sample(y, x * static_cast<std::size_t>(n) + c);
            out[3] = 255;
            if (parts.kind == 3) {
                if (3 * s[0] + 2 >= parts.palette.size())
                    refuse(name, "the PNG picture is damaged");
                for (std::size_t c = 0; c < 3; ++c) out[c] = parts.palette[3 * s[0] + c];
                if (s[0] < parts.transparent.size()) out[3] = parts.transparent[s[0]];
                continue;
            }
            const bool is_grey = n < 3;
            for (std::size_t c = 0; c < 3; ++c) out[c] = level(s[is_grey ? 0 : c]);
            if (n == 2 || n == 4) out[3] = level(s[static_cast<std::size_t>(n) - 1]);
            if (n == 1 && parts.transparent.size() >= 2 && s[0] == clear(0)) out[3] = 0;
            if (n == 3 && parts.transparent.size() >= 6 && s[0] == clear(0) && s[1] == clear(1) &&
                s[2] == clear(2))
                out[3] = 0;
        }
    }
    return image;
}

}  // namespace poinsot
