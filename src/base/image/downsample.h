// Averages a picture that was drawn larger than requested (supersampling).
#pragma once

#include "image/deep_image.h"
#include "image/image.h"

namespace poinsot {

// The mean of factor × factor pixels in linear light, weighted by alpha. Precondition: width and
// height are multiples of the factor, which is at least 1.
Image downsampled(const Image& image, int factor);

// The same, into a picture whose memory is reused.
void downsample_into(const Image& image, int factor, Image& small);

// The same with 16 bits per component.
void downsample_into(const DeepImage& image, int factor, DeepImage& small);

}  // namespace poinsot
