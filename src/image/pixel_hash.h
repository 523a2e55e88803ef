// What a picture shows as one name: a hash of its size and pixels.
#pragma once

#include <string>

#include "image/image.h"

namespace poinsot {

// Of a picture's size and pixels ("WIDTHxHEIGHT\n", then 8-bit RGBA row by row): the same for every
// file that holds the same picture.
std::string pixel_hash(const Image& image);

}  // namespace poinsot
