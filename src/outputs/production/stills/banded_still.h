// Stills drawn and written in bands: pictures larger than a framebuffer, in the memory of one band,
// and pictures with 16 bits per component.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "image/png.h"
#include "production/stills/picture.h"

namespace poinsot {

// Whether a picture of this size is drawn in bands: it exceeds the framebuffer or a reasonable
// amount of memory.
bool wants_bands(const PictureMaker& pictures);

// The texts of a PNG, given the hash of its pixels; see image/pixels_xxh64.h.
using TextsOfPixels = std::function<std::map<std::string, std::string>(const std::string& pixels)>;

// Draws the picture of an instant and writes it. Bands have no seams: every pixel is computed
// independently, and the dither pattern continues. Throws EnvironmentError if the picture cannot be
// written.
void write_in_bands(PictureMaker& pictures, const FilmTime& moment,
                    const std::filesystem::path& path, const PngOptions& png, int bit_depth,
                    const TextsOfPixels& texts);

}  // namespace poinsot
