#include "production/stills/banded_still.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "error/error.h"
#include "image/files/png_bands.h"
#include "shapes/crop.h"
#include "system/interrupt.h"

namespace poinsot {

namespace {

// Pixels per band: 14 bytes each in framebuffer and picture.
constexpr double band_pixels = 4e6;
constexpr double most_whole_pixels = 32e6;
constexpr int widest_part_px = 8192;
// Parts are aligned to the cells of the dither pattern and to the renderer's blocks of four pixels.
constexpr int step_px = 32;

// Copies a part of the band into it; `x`: column of its left edge.
void place(const Image& part, int x, Image& band) {
    const std::size_t row = 4u * static_cast<std::size_t>(part.width());
    for (int y = 0; y < part.height(); ++y)
        std::memcpy(band.bytes().data() +
                        4u * (static_cast<std::size_t>(y) * static_cast<std::size_t>(band.width()) +
                              static_cast<std::size_t>(x)),
                    part.bytes().data() + static_cast<std::size_t>(y) * row, row);
}

void place(const DeepImage& part, int x, DeepImage& band) {
    const std::size_t row = 4u * static_cast<std::size_t>(part.width());
    for (int y = 0; y < part.height(); ++y)
        std::copy_n(
            part.samples().begin() + static_cast<std::ptrdiff_t>(y * row), row,
            band.samples().begin() + 4 * (static_cast<std::ptrdiff_t>(y) * band.width() + x));
}

template <typename Picture>
void write_bands(PictureMaker& pictures, const Drawing& whole, PngBandWriter& file) {
    const int most_side_px = pictures.context_info().largest_picture_px;
    const int width = pictures.width_px();
    const int height = pictures.height_px();
    const int samples_a_side = static_cast<int>(std::lround(std::sqrt(pictures.samples_a_pixel())));
    const int part_width =
        std::min({width, widest_part_px, most_side_px / samples_a_side / step_px * step_px});
    const int n_rows =
        std::max(step_px, static_cast<int>(band_pixels / pictures.samples_a_pixel() / width) /
                              step_px * step_px);
    Picture part;
    for (int y = 0; y < height; y += n_rows) {
        stop_if_interrupted();
        Picture band(width, std::min(n_rows, height - y));
        for (int x = 0; x < width; x += part_width) {
            pictures.draw_part(whole, {x, y, std::min(part_width, width - x), band.height()}, part);
            place(part, x, band);
        }
        file.write(band);
    }
}

}  // namespace

bool wants_bands(const PictureMaker& pictures) {
    const double n_pixels =
        1.0 * pictures.width_px() * pictures.height_px() * pictures.samples_a_pixel();
    const double side =
        std::sqrt(pictures.samples_a_pixel()) * std::max(pictures.width_px(), pictures.height_px());
    return n_pixels > most_whole_pixels || side > pictures.context_info().largest_picture_px;
}

void write_in_bands(PictureMaker& pictures, const FilmTime& moment,
                    const std::filesystem::path& path, const PngOptions& png, int bit_depth,
                    const TextsOfPixels& texts) {
    const Drawing whole = pictures.stage().at(moment);
    const bool opaque = whole.background.alpha >= 1.0;
    PngBandWriter file(path, pictures.width_px(), pictures.height_px(), opaque, png, bit_depth);
    if (bit_depth == 16)
        write_bands<DeepImage>(pictures, whole, file);
    else
        write_bands<Image>(pictures, whole, file);
    file.finish(texts(file.pixels_xxh64()));
}

}  // namespace poinsot
