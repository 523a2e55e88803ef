// Counts the pixels in which two pictures differ, and says of each why it counts or not. Used by
// image/compare.h.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compare/compare.h"

namespace poinsot {

// The pixels of some regions of a picture.
class PixelMask {
 public:
    PixelMask(int width, int height, std::span<const PictureRegion> regions);
    // One byte per pixel, 0 outside of the regions; empty if no pixel is in them.
    const std::vector<std::uint8_t>& bytes() const { return bytes_; }
    bool has(std::size_t pixel) const { return !bytes_.empty() && bytes_[pixel] != 0; }
    std::int64_t count() const { return count_; }

 private:
    std::vector<std::uint8_t> bytes_;
    std::int64_t count_ = 0;
};

// The samples of a picture, four per pixel.
template <typename Sample>
struct PictureSamples {
    std::span<const Sample> samples;
    int width = 0, height = 0;
};
inline PictureSamples<std::uint8_t> samples_of(const Image& image) {
    return {image.bytes(), image.width(), image.height()};
}
inline PictureSamples<std::uint16_t> samples_of(const DeepImage& image) {
    return {image.samples(), image.width(), image.height()};
}

// The number of sample levels in one 8-bit level.
template <typename Sample>
constexpr int samples_a_level = sizeof(Sample) == 2 ? 257 : 1;

// Whether anti-aliasing explains that two pictures differ in a pixel: the 3×3 pixels around it show
// an edge, which spans at least a tenth of the range in one channel, and each picture's pixel lies,
// in every channel, within the range of the 3×3 pixels of the other picture. An edge that moves by
// less than a pixel passes; a line that is missing does not.
template <typename Sample>
bool is_antialiasing(const PictureSamples<Sample>& a, const PictureSamples<Sample>& b, int x,
                     int y);

// Adds the counts of two pictures of equal size to the result.
template <typename Sample>
void count_differences(const PictureSamples<Sample>& a, const PictureSamples<Sample>& b,
                       const CompareLimits& limits, const PixelMask& ignored, Comparison& result);

}  // namespace poinsot
