// RGB → Y'CbCr for films: BT.709 coefficients, limited range; 4:2:0 of 8 bits with chroma sited
// left (between the rows, on the even columns), which is the convention for H.264 and VP9, or 4:4:4
// of 10 bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/image.h"

namespace poinsot {

// The planes of one video frame; strides in bytes. Chroma planes are (w+1)/2 × (h+1)/2.
struct YuvPlanes {
    std::uint8_t *y = nullptr, *cb = nullptr, *cr = nullptr;
    std::ptrdiff_t y_stride = 0, cb_stride = 0, cr_stride = 0;
};

// Converts pictures of one size and reuses its row buffers. Accuracy: Y' within 0.504 and Cb, Cr
// within 0.506 of the real-valued conversion, before chroma's own 3×2 filter [1 2 1]/4 × [1 1]/2.
// Source: Rec. ITU-R BT.709-6 §3; Rec. ITU-T H.264 Annex E, chroma_sample_loc_type 0.
class YuvConverter {
 public:
    explicit YuvConverter(int width);
    void convert(const Image& image, const YuvPlanes& planes);  // alpha is ignored

 private:
    std::size_t width_;
    std::vector<std::uint16_t> rows_;
};

// Copies the alpha channel to a separate plane.
void copy_alpha(const Image& image, std::uint8_t* plane, std::ptrdiff_t stride);

// Converts to planes Y', Cb, Cr and alpha of 10 bits in two bytes each, the lower first; strides in
// bytes. Accuracy: Y', Cb and Cr within 0.506 of the real-valued conversion. Alpha is 0 to 1023,
// and its upper 8 bits are the picture's.
void convert_to_10_bits(const Image& image, const std::array<std::uint8_t*, 4>& planes,
                        const std::array<std::ptrdiff_t, 4>& strides);

}  // namespace poinsot
