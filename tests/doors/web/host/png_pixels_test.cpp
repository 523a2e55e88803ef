// The page's reader of PNG pictures, with every kind of samples that PNG has.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <random>

#include "error/error.h"
#include "image/png.h"

namespace poinsot {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Kind {
    int colour_type, depth, n_channels;
};
constexpr std::array<Kind, 15> kinds{{{PNG_COLOR_TYPE_GRAY, 1, 1},
                                      {PNG_COLOR_TYPE_GRAY, 2, 1},
                                      {PNG_COLOR_TYPE_GRAY, 4, 1},
                                      {PNG_COLOR_TYPE_GRAY, 8, 1},
                                      {PNG_COLOR_TYPE_GRAY, 16, 1},
                                      {PNG_COLOR_TYPE_RGB, 8, 3},
                                      {PNG_COLOR_TYPE_RGB, 16, 3},
                                      {PNG_COLOR_TYPE_PALETTE, 1, 1},
                                      {PNG_COLOR_TYPE_PALETTE, 2, 1},
                                      {PNG_COLOR_TYPE_PALETTE, 4, 1},
                                      {PNG_COLOR_TYPE_PALETTE, 8, 1},
                                      {PNG_COLOR_TYPE_GRAY_ALPHA, 8, 2},
                                      {PNG_COLOR_TYPE_GRAY_ALPHA, 16, 2},
                                      {PNG_COLOR_TYPE_RGB_ALPHA, 8, 4},
                                      {PNG_COLOR_TYPE_RGB_ALPHA, 16, 4}}};
constexpr int width = 13, height = 9;
// The colour that is transparent in pictures without alpha.
constexpr std::array<unsigned, 3> clear{1, 0, 1};

// Samples as numbers, pixel by pixel.
std::vector<unsigned> random_samples(const Kind& kind) {
    std::mt19937 random(7);
    std::vector<unsigned> samples(static_cast<std::size_t>(width * height * kind.n_channels));
    for (unsigned& sample : samples) sample = random() & ((1u << kind.depth) - 1u);
    for (std::size_t c = 0; c < static_cast<std::size_t>(kind.n_channels); ++c)
        samples[c] = clear[c % 3];
    return samples;
}

png_color colour_of(unsigned index) {
    return {static_cast<png_byte>(index * 7), static_cast<png_byte>(255 - index),
            static_cast<png_byte>(index * index)};
}
png_byte alpha_of(unsigned index) { return index == 1 ? 40 : 255; }

Bytes file_of(const Kind& kind, const std::vector<unsigned>& samples, int interlace) {
    Bytes file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &file,
        [](png_structp from, png_bytep bytes, std::size_t size) {
            auto& to = *static_cast<Bytes*>(png_get_io_ptr(from));
            to.insert(to.end(), bytes, bytes + size);
        },
        nullptr);
    png_set_IHDR(png, info, width, height, kind.depth, kind.colour_type, interlace,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (kind.colour_type == PNG_COLOR_TYPE_PALETTE) {
        std::vector<png_color> palette;
        Bytes alphas;
        for (unsigned k = 0; k < 1u << kind.depth; ++k) {
            palette.push_back(colour_of(k));
            alphas.push_back(alpha_of(k));
        }
        png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
        png_set_tRNS(png, info, alphas.data(), static_cast<int>(alphas.size()), nullptr);
    } else if (kind.n_channels % 2 == 1) {
        png_color_16 colour{};
        colour.gray = colour.red = clear[0];
        colour.green = clear[1];
        colour.blue = clear[2];
        png_set_tRNS(png, info, nullptr, 0, &colour);
    }
    const std::size_t row_size = png_get_rowbytes(png, info);
    Bytes packed(row_size * height);
    const auto n_in_row = static_cast<std::size_t>(width * kind.n_channels);
    for (std::size_t k = 0; k < samples.size(); ++k) {
        const std::size_t bit = k % n_in_row * static_cast<std::size_t>(kind.depth);
        std::uint8_t* const at = packed.data() + k / n_in_row * row_size + bit / 8;
        if (kind.depth == 16) {
            at[0] = static_cast<std::uint8_t>(samples[k] >> 8);
            at[1] = static_cast<std::uint8_t>(samples[k]);
        } else {
            *at |= static_cast<std::uint8_t>(samples[k] << (8 - kind.depth - bit % 8));
        }
    }
    std::vector<png_bytep> rows;
    for (int y = 0; y < height; ++y)
        rows.push_back(packed.data() + static_cast<std::size_t>(y) * row_size);
    png_write_info(png, info);
    png_write_image(png, rows.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return file;
}

Rgba8 expected_of(const Kind& kind, const unsigned* s) {
    const auto level = [&kind](unsigned value) {
        return kind.depth == 16
                   ? static_cast<std::uint8_t>((value * 255u + 32895u) >> 16)
                   : static_cast<std::uint8_t>(value * 255u / ((1u << kind.depth) - 1));
    };
    if (kind.colour_type == PNG_COLOR_TYPE_PALETTE) {
        const png_color colour = colour_of(s[0]);
        return {colour.red, colour.green, colour.blue, alpha_of(s[0])};
    }
    const bool grey = kind.n_channels < 3, has_alpha = kind.n_channels % 2 == 0;
    const bool is_clear = s[0] == clear[0] && (grey || (s[1] == clear[1] && s[2] == clear[2]));
    return {
        level(s[0]), level(s[grey ? 0 : 1]), level(s[grey ? 0 : 2]),
        has_alpha ? level(s[kind.n_channels - 1]) : static_cast<std::uint8_t>(is_clear ? 0 : 255)};
}

TEST(PngPixels, AreThoseOfEveryKindOfPng) {
    for (const int interlace : {PNG_INTERLACE_NONE, PNG_INTERLACE_ADAM7})
        for (const Kind& kind : kinds) {
            const std::string name = fmt::format("type {}, {} bits", kind.colour_type, kind.depth);
            const std::vector<unsigned> samples = random_samples(kind);
            PngInfo info;
            const Image image = decode_png(file_of(kind, samples, interlace), name, &info);
            ASSERT_EQ(info.width_px, width) << name;
            ASSERT_EQ(info.height_px, height) << name;
            EXPECT_EQ(info.bit_depth, kind.depth == 16 ? 16 : 8) << name;
            for (int k = 0; k < width * height; ++k) {
                const Rgba8 seen = image.at(k % width, k / width);
                const Rgba8 wanted = expected_of(kind, samples.data() + k * kind.n_channels);
                ASSERT_TRUE(seen.r == wanted.r && seen.g == wanted.g && seen.b == wanted.b &&
                            seen.a == wanted.a)
                    << name << ", pixel " << k;
            }
        }
}

TEST(PngPixels, OfABrokenPictureAreRefusedByName) {
    const Bytes whole = file_of(kinds[5], random_samples(kinds[5]), PNG_INTERLACE_NONE);
    for (std::size_t n = 0; n + 13 < whole.size(); ++n) {
        try {
            decode_png(std::span(whole).first(n), "a.png");
            ADD_FAILURE() << n << " of " << whole.size() << " bytes were read";
        } catch (const InputError& error) {
            EXPECT_TRUE(std::string_view(error.what()).starts_with("a.png: ")) << error.what();
        }
    }
    Bytes animated = whole;
    const std::string_view chunk("\0\0\0\0acTL\0\0\0\0", 12);
    animated.insert(animated.begin() + 33, chunk.begin(), chunk.end());
    EXPECT_THROW(decode_png(animated, "a.png"), InputError);
}

}  // namespace
}  // namespace poinsot
