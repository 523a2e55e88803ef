#include "encoding/yuv.h"

#include <bit>
#include <cassert>
#include <cstring>

namespace poinsot {

namespace {

static_assert(std::endian::native == std::endian::little, "pixels are read as 16-bit halves");

// Products are computed as (channel · 2^8) · (coefficient · 2^16) >> 16, which the compiler turns
// into one 16-bit high multiplication; sums are in 1/256 of a level. Each product loses up to one
// unit, 1/2 on average; the added constant compensates this.
constexpr std::uint32_t scaled(double coefficient) {
    return (static_cast<std::uint32_t>(coefficient * (2 << 16)) + 1) / 2;
}
constexpr double kr = 0.2126, kg = 0.7152, kb = 0.0722;
constexpr double luma_scale = 219.0 / 255.0, chroma_scale = 224.0 / 255.0;
constexpr std::uint32_t y_r = scaled(luma_scale * kr), y_g = scaled(luma_scale * kg),
                        y_b = scaled(luma_scale * kb);
constexpr std::uint32_t c_own = scaled(chroma_scale / 2);
constexpr std::uint32_t cb_r = scaled(chroma_scale / 2 * kr / (1 - kb)),
                        cb_g = scaled(chroma_scale / 2 * kg / (1 - kb));
constexpr std::uint32_t cr_g = scaled(chroma_scale / 2 * kg / (1 - kr)),
                        cr_b = scaled(chroma_scale / 2 * kb / (1 - kr));

inline std::uint16_t times(std::uint16_t value, std::uint32_t coefficient) {
    return static_cast<std::uint16_t>((value * coefficient) >> 16);
}

// One row: luma, and separate channels for the chroma of two rows. Pixels are read as two 16-bit
// halves, which takes fewer steps than reading four bytes.
void luma_row(const std::uint8_t* __restrict rgba, std::size_t n, std::uint16_t* __restrict r,
              std::uint16_t* __restrict g, std::uint16_t* __restrict b,
              std::uint8_t* __restrict y) {
    constexpr std::uint16_t offset = 16 * 256 + 128 + 1;
    for (std::size_t x = 0; x < n; ++x) {
        std::uint16_t rg = 0, ba = 0;
        std::memcpy(&rg, rgba + 4 * x, 2);
        std::memcpy(&ba, rgba + 4 * x + 2, 2);
        const auto red = static_cast<std::uint16_t>(rg << 8);
        const auto green = static_cast<std::uint16_t>(rg & 0xff00);
        const auto blue = static_cast<std::uint16_t>(ba << 8);
        const auto sum = static_cast<std::uint16_t>(times(red, y_r) + times(green, y_g) +
                                                    times(blue, y_b) + offset);
        y[x] = static_cast<std::uint8_t>(sum >> 8);
        r[x] = rg & 0xff;
        g[x] = static_cast<std::uint16_t>(rg >> 8);
        b[x] = ba & 0xff;
    }
}

// Sums of two rows, with the left neighbour of column 0 and the right neighbour of the last column
// repeated.
void add_rows(const std::uint16_t* __restrict a, const std::uint16_t* __restrict b, std::size_t n,
              std::uint16_t* __restrict sum) {
    for (std::size_t x = 0; x < n; ++x) sum[x + 1] = static_cast<std::uint16_t>(a[x] + b[x]);
    sum[0] = sum[1];
    sum[n + 1] = sum[n];
}

// [1 2 1] about the even columns: 8 × the mean, then × 2^5 for the product's scale.
inline std::uint16_t sited(const std::uint16_t* sum, std::size_t i) {
    return static_cast<std::uint16_t>((sum[2 * i] + 2 * sum[2 * i + 1] + sum[2 * i + 2]) << 5);
}

void chroma_row(const std::uint16_t* __restrict r, const std::uint16_t* __restrict g,
                const std::uint16_t* __restrict b, std::size_t n, std::uint8_t* __restrict cb,
                std::uint8_t* __restrict cr) {
    // One product adds and two subtract, so that truncation adds 1/2 unit, which is subtracted
    // here.
    constexpr std::uint16_t offset = 128 * 256 + 128 - 1;
    for (std::size_t i = 0; i < n; ++i) {
        const std::uint16_t red = sited(r, i), green = sited(g, i), blue = sited(b, i);
        const std::uint16_t blueness = static_cast<std::uint16_t>(
            offset + times(blue, c_own) - times(red, cb_r) - times(green, cb_g));
        const std::uint16_t redness = static_cast<std::uint16_t>(
            offset + times(red, c_own) - times(green, cr_g) - times(blue, cr_b));
        cb[i] = static_cast<std::uint8_t>(blueness >> 8);
        cr[i] = static_cast<std::uint8_t>(redness >> 8);
    }
}

}  // namespace

YuvConverter::YuvConverter(int width)
    : width_(static_cast<std::size_t>(width)), rows_(9 * (width_ + 3)) {}

void YuvConverter::convert(const Image& image, const YuvPlanes& planes) {
    assert(static_cast<std::size_t>(image.width()) == width_);
    const std::size_t stride = width_ + 3;
    std::uint16_t* row[9];
    for (std::size_t i = 0; i < 9; ++i) row[i] = rows_.data() + i * stride;
    const std::uint8_t* rgba = image.bytes().data();
    const int height = image.height();
    for (int y = 0; y < height; y += 2) {
        luma_row(rgba + 4 * width_ * static_cast<std::size_t>(y), width_, row[0], row[1], row[2],
                 planes.y + y * planes.y_stride);
        // A last row without a partner is used twice.
        const bool paired = y + 1 < height;
        if (paired)
            luma_row(rgba + 4 * width_ * static_cast<std::size_t>(y + 1), width_, row[3], row[4],
                     row[5], planes.y + (y + 1) * planes.y_stride);
        for (std::size_t c = 0; c < 3; ++c)
            add_rows(row[c], paired ? row[3 + c] : row[c], width_, row[6 + c]);
        chroma_row(row[6], row[7], row[8], (width_ + 1) / 2, planes.cb + y / 2 * planes.cb_stride,
                   planes.cr + y / 2 * planes.cr_stride);
    }
}

void copy_alpha(const Image& image, std::uint8_t* plane, std::ptrdiff_t stride) {
    const std::uint8_t* rgba = image.bytes().data();
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) plane[x] = rgba[4 * x + 3];
        rgba += 4 * image.width();
        plane += stride;
    }
}

namespace {

// A row of 10-bit components; products in 1/65536.
void row_of_10_bits(const std::uint8_t* __restrict rgba, std::size_t n, std::uint16_t* __restrict y,
                    std::uint16_t* __restrict cb, std::uint16_t* __restrict cr,
                    std::uint16_t* __restrict alpha) {
    constexpr auto fixed = [](double coefficient) {
        return static_cast<std::int32_t>(coefficient * 65536 + (coefficient < 0 ? -0.5 : 0.5));
    };
    constexpr double luma = 4 * luma_scale, chroma = 4 * chroma_scale / 2;
    constexpr std::int32_t half = 1 << 15, black = (64 << 16) + half, grey = (512 << 16) + half;
    constexpr std::int32_t yr = fixed(luma * kr), yg = fixed(luma * kg), yb = fixed(luma * kb);
    constexpr std::int32_t own = fixed(chroma);
    constexpr std::int32_t br = fixed(-chroma * kr / (1 - kb)), bg = fixed(-chroma * kg / (1 - kb));
    constexpr std::int32_t rg = fixed(-chroma * kg / (1 - kr)), rb = fixed(-chroma * kb / (1 - kr));
    for (std::size_t x = 0; x < n; ++x) {
        const std::int32_t r = rgba[4 * x], g = rgba[4 * x + 1], b = rgba[4 * x + 2];
        const std::uint32_t a = rgba[4 * x + 3];
        y[x] = static_cast<std::uint16_t>((yr * r + yg * g + yb * b + black) >> 16);
        cb[x] = static_cast<std::uint16_t>((br * r + bg * g + own * b + grey) >> 16);
        cr[x] = static_cast<std::uint16_t>((own * r + rg * g + rb * b + grey) >> 16);
        alpha[x] = static_cast<std::uint16_t>(a << 2 | a >> 6);
    }
}

}  // namespace

void convert_to_10_bits(const Image& image, const std::array<std::uint8_t*, 4>& planes,
                        const std::array<std::ptrdiff_t, 4>& strides) {
    const auto width = static_cast<std::size_t>(image.width());
    for (int y = 0; y < image.height(); ++y) {
        std::array<std::uint16_t*, 4> rows{};
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i] = reinterpret_cast<std::uint16_t*>(planes[i] + y * strides[i]);
        row_of_10_bits(image.bytes().data() + 4 * width * static_cast<std::size_t>(y), width,
                       rows[0], rows[1], rows[2], rows[3]);
    }
}

}  // namespace poinsot
