// Few colours for many: the palette of a GIF and the patterns that mix what it lacks.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "image/image.h"

namespace poinsot {

// How often which colours occur, in cells of 4 levels a side, with each cell's mean kept.
class ColourCount {
 public:
    ColourCount();
    void add(const Image& image);  // pixels under half opaque are left out

    struct Cell {
        double n = 0;
        std::array<double, 3> sum{};  // of R, G, B
    };
    const std::vector<Cell>& cells() const { return cells_; }

 private:
    std::vector<Cell> cells_;
};

// At most n_colours colours near all those counted: boxes split at their mean where the weighted
// variance is largest, then moved to the means of what is nearest to them.
// Source: Wu, Efficient statistical computations for optimal color quantization, Graphics Gems II
// (1991); Lloyd, IEEE Trans. Inf. Theory 28 (1982) 129.
std::vector<Rgba8> palette_for(const ColourCount& count, std::size_t n_colours);

// Gives each pixel the index of a palette colour. A colour that the palette lacks becomes a pattern
// of the two nearest on either side of it, by a fixed 8×8 threshold matrix (Bayer, 1973): what
// stands still in the picture stands still in the pattern, and a colour of the palette stays flat.
class Ditherer {
 public:
    // Pixels under half opaque get transparent_index.
    Ditherer(std::vector<Rgba8> palette, std::uint8_t transparent_index);
    void apply(const Image& image, std::uint8_t* indices, std::ptrdiff_t stride);

 private:
    // Two palette colours and how much of the second, in 64ths; remembered by colour.
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
