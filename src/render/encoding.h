// From linear light, 16 bits a component and premultiplied, to sRGB bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poinsot {

// The sRGB curve as a table, with an ordered dither of slightly less than a level: gradients do not
// band, and colours that are exact levels stay flat. A table of integers gives the same bytes on
// every processor, and costs a fraction of the same done in a shader of a software renderer.
class Encoder {
 public:
    Encoder();

    // Encodes n pixels of a row that begins at pixel (x, y) of the picture.
    void encode_opaque(const std::uint16_t* linear, int x, int y, int n, std::uint8_t* out) const;
    // The same with alpha, which comes out linear and not multiplied into the colour.
    void encode_transparent(const std::uint16_t* linear, int x, int y, int n,
                            std::uint8_t* out) const;
    // The same in 16 bits a component, where no dither is needed: the bits below the eighth are the
    // framebuffer's own. Alpha is 65535 for opaque pictures.
    void encode_deep(const std::uint16_t* linear, int n, bool transparent,
                     std::uint16_t* out) const;

 private:
    std::vector<std::uint16_t> levels_;       // level times 256 for each linear value
    std::vector<std::uint16_t> deep_levels_;  // of 65535, likewise
};

}  // namespace poinsot
