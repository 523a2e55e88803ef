// PNG files of pictures in vector figures, in a page: uncompressed, as the module has no zlib.
#include <algorithm>
#include <cstdint>
#include <string>

#include "vector/pdf.h"

namespace poinsot::vector {

namespace {

void put_number(std::string& to, std::uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8)
        to.push_back(static_cast<char>((number >> shift) & 0xff));
}

// PNG specification, "CRC algorithm".
std::uint32_t crc_of(const std::string& bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int k = 0; k < 8; ++k) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
    }
    return ~crc;
}

void put_chunk(std::string& to, const std::string& kind, const std::string& data) {
    put_number(to, static_cast<std::uint32_t>(data.size()));
    to += kind + data;
    put_number(to, crc_of(kind + data));
}

}  // namespace

std::string png_of(const Raster& raster) {
    std::string rows;
    const auto width = static_cast<std::size_t>(raster.width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(raster.height); ++y) {
        rows.push_back('\0');  // no filter
        for (std::size_t k = 4 * width * y; k < 4 * width * (y + 1); ++k)
            rows.push_back(static_cast<char>(raster.rgba[k]));
    }
    // RFC 1950 and 1951: stored blocks, and Adler's sum.
    std::string data("\x78\x01", 2);
    constexpr std::size_t most = 65535;
    for (std::size_t at = 0; at < rows.size(); at += most) {
        const std::size_t n = std::min(most, rows.size() - at);
        data.push_back(at + n == rows.size() ? '\x01' : '\0');
        for (const std::size_t size : {n, ~n}) {
            data.push_back(static_cast<char>(size & 0xff));
            data.push_back(static_cast<char>((size >> 8) & 0xff));
        }
        data.append(rows, at, n);
    }
    std::uint32_t a = 1, b = 0;
    for (const char byte : rows) {
        a = (a + static_cast<unsigned char>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    put_number(data, (b << 16) | a);
    std::string header;
    put_number(header, static_cast<std::uint32_t>(raster.width));
    put_number(header, static_cast<std::uint32_t>(raster.height));
    header += std::string("\x08\x06\0\0\0", 5);  // 8 bits of R, G, B and alpha
    std::string png("\x89PNG\r\n\x1a\n", 8);
    put_chunk(png, "IHDR", header);
    put_chunk(png, "IDAT", data);
    put_chunk(png, "IEND", "");
    return png;
}

}  // namespace poinsot::vector
