// Encodes premultiplied linear light of 16 bits per component to sRGB bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poinsot {

// The sRGB curve as a table, with an ordered dither of slightly less than one level: gradients show
// no bands, and colours that are exact levels stay uniform. A table of integers gives the same
// bytes on every processor, and costs a fraction of a shader in a software renderer.
class Encoder {
 public:
    Encoder();

    // The same as a table for shaders/screen.frag: 65536 levels in 1/256 of a level, then the 64
    // thresholds of the dither, by rows, in a last row of 256.
    std::vector<std::uint16_t> table() const;

    // Encodes n pixels of a row that begins at pixel (x, y) of the picture.
    void encode_opaque(const std::uint16_t* linear, int x, int y, int n, std::uint8_t* out) const;
    // The same with alpha; the output has linear, non-premultiplied alpha.
    void encode_transparent(const std::uint16_t* linear, int x, int y, int n,
                            std::uint8_t* out) const;
    // The same with 16 bits per component. No dither is needed: the bits below the eighth come from
    // the framebuffer. Alpha is 65535 for opaque pictures.
    void encode_deep(const std::uint16_t* linear, int n, bool transparent,
                     std::uint16_t* out) const;

 private:
    std::vector<std::uint16_t> levels_;       // 256 × level for each linear value
    std::vector<std::uint16_t> deep_levels_;  // of 65535, for each linear value
};

}  // namespace poinsot
