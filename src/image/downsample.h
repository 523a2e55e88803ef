// A picture drawn larger than wanted, averaged down: supersampling for settings that pay for it.
#pragma once

#include "image/deep_image.h"
#include "image/image.h"

namespace poinsot {

// The mean of factor × factor pixels in linear light, alpha-weighted. Precondition: both sides are
// multiples of the factor, which is at least 1.
Image downsampled(const Image& image, int factor);

// The same, into a picture whose memory is used again.
void downsample_into(const Image& image, int factor, Image& small);

// The same of 16 bits a component.
void downsample_into(const DeepImage& image, int factor, DeepImage& small);

}  // namespace poinsot
