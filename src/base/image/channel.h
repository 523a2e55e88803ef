// One channel of a picture as real numbers, and the convolutions for similarity measures.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "image/image.h"

namespace poinsot {

struct Channel {
    Channel(int width_px, int height_px)
        : width(width_px),
          height(height_px),
          values(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px)) {}
    int width, height;
    std::vector<float> values;  // row by row
};

// Convolution with odd kernels along x, then along y. Border values are repeated outside the
// border.
Channel convolved(const Channel& channel, std::span<const float> kernel_x,
                  std::span<const float> kernel_y);

// A Gaussian sampled at the integers within ±radius, normalised to the sum 1.
std::vector<float> gaussian_kernel(double sigma, int radius);

}  // namespace poinsot
