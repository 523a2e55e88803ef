// Colour reduction: the palette of a GIF, and dithering for colours outside the palette.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "image/image.h"

namespace poinsot {

// A histogram of colours in cells of 4 levels per side, with the mean of each cell.
class ColourCount {
 public:
    ColourCount();
    void add(const Image& image);  // ignores pixels with less than half opacity

    struct Cell {
        double n = 0;
        std::array<double, 3> sum{};  // of R, G, B
    };
    const std::vector<Cell>& cells() const { return cells_; }

 private:
    std::vector<Cell> cells_;
};

// Returns at most n_colours colours near all counted ones: boxes are split at their mean where the
// weighted variance is largest; each colour is then moved to the mean of the counted colours
// nearest to it. Source: Wu, Efficient statistical computations for optimal color quantization,
// Graphics Gems II (1991); Lloyd, IEEE Trans. Inf. Theory 28 (1982) 129.
std::vector<Rgba8> palette_for(const ColourCount& count, std::size_t n_colours);

// Gives each pixel the index of a palette colour. A colour outside the palette becomes a pattern of
// the two nearest palette colours on either side of it, by a fixed 8×8 threshold matrix (Bayer,
// 1973): the pattern of a static area is static, and a colour of the palette stays uniform.
class Ditherer {
 public:
    // Pixels with less than half opacity get transparent_index.
    Ditherer(std::vector<Rgba8> palette, std::uint8_t transparent_index);
    void apply(const Image& image, std::uint8_t* indices, std::ptrdiff_t stride);

 private:
    // Two palette colours and the share of the second, in 64ths; cached by colour.
    struct Mix {
        std::uint32_t colour = ~0u;
        std::uint8_t first = 0, second = 0, share = 0;
    };
    const Mix& mix_for(const std::uint8_t* rgb);
    std::uint8_t nearest(const std::array<int, 3>& colour) const;

    std::vector<Rgba8> palette_;
    std::uint8_t transparent_index_;
    std::vector<Mix> remembered_;
};

}  // namespace poinsot
