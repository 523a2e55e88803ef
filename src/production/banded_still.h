// A still drawn and written band by band: pictures larger than a framebuffer, in the memory of one
// band, and pictures of 16 bits a component.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "image/png.h"
#include "production/picture.h"

namespace poinsot {

// Whether a picture of this size is better drawn so: it is beyond the framebuffer, or beyond what
// should be held in memory whole.
bool wants_bands(const PictureMaker& pictures);

// What a picture carries, from the hash of its pixels; see image/pixel_check.h.
using TextsOfPixels = std::function<std::map<std::string, std::string>(const std::string& pixels)>;

// Draws the picture of an instant and writes it. The bands show no seams: every pixel is computed
// by itself, and the dither goes on. Throws EnvironmentError if it cannot be written.
void write_in_bands(PictureMaker& pictures, const FilmMoment& moment,
                    const std::filesystem::path& path, const PngOptions& png, int bit_depth,
                    const TextsOfPixels& texts);

}  // namespace poinsot
