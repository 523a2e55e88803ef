// PNG files on the disk; image/png.h has their bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "image/png.h"

namespace poinsot {

// The file's bytes. Throws: InputError for a file that is missing, too large or not a regular file;
// EnvironmentError if it cannot be read.
std::vector<std::uint8_t> bytes_of_png(const std::filesystem::path& path);

// The functions of image/png.h and image/pixels_xxh64.h for the bytes of a file. Throw as those do,
// and as bytes_of_png does.
Image read_png(const std::filesystem::path& path, PngInfo* info = nullptr);
StoredPicture read_stored_png(const std::filesystem::path& path);
PngInfo read_png_info(const std::filesystem::path& path);
std::string pixels_xxh64_of(const std::filesystem::path& path);

// Writes the file atomically: to a temporary file, which is synced and renamed. On failure throws
// EnvironmentError with path and reason, and leaves no file.
void write_png(const std::filesystem::path& path, const Image& image,
               const PngOptions& options = {});

}  // namespace poinsot
