// A cryptographic hash (SHA-256) of a picture's size and pixels, used to identify pictures.
#pragma once

#include <string>

#include "image/deep_image.h"
#include "image/image.h"
#include "image/png.h"

namespace poinsot {

// Hash of "WIDTHxHEIGHT\n", then 8-bit RGBA row by row: equal for every file that holds the same
// picture.
std::string pixels_sha256(const Image& image);

// The same for 16 bits per component ("WIDTHxHEIGHT 16\n", then the samples, big-endian).
std::string pixels_sha256(const DeepImage& image);

// Hash of the pixels at their stored depth.
std::string pixels_sha256(const StoredPicture& picture);

}  // namespace poinsot
