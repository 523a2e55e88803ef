// What a picture shows as one name: a hash of its size and pixels.
#pragma once

#include <string>

#include "image/deep_image.h"
#include "image/image.h"
#include "image/png.h"

namespace poinsot {

// Of a picture's size and pixels ("WIDTHxHEIGHT\n", then 8-bit RGBA row by row): the same for every
// file that holds the same picture.
std::string pixel_hash(const Image& image);

// The same of 16 bits a component ("WIDTHxHEIGHT 16\n", then the samples, the high byte first).
std::string pixel_hash(const DeepImage& image);

// Of the pixels as they are stored.
std::string pixel_hash(const StoredPicture& picture);

}  // namespace poinsot
