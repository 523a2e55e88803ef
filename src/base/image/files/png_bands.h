// Writes a PNG file band by band, for pictures that do not fit into memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "image/deep_image.h"
#include "image/image.h"
#include "image/png.h"

namespace poinsot {

// Takes a picture in bands from the top, each as wide as the picture; needs the memory of one band.
// Move-only. If it is destroyed before finish(), no file is left.
class PngBandWriter {
 public:
    // Opaque pictures are written without alpha; the alpha of their bands is ignored. bit_depth is
    // 8 or 16. Throws: InputError as PngEncoder does, EnvironmentError as AtomicFile does.
    PngBandWriter(const std::filesystem::path& path, int width_px, int height_px, bool opaque,
                  const PngOptions& options = {}, int bit_depth = 8);
    ~PngBandWriter();
    PngBandWriter(PngBandWriter&&) noexcept;
    PngBandWriter& operator=(PngBandWriter&&) noexcept;

    // Writes a band of the bit depth given to the constructor. Throws: InputError for a band of a
    // different width or with too many rows; EnvironmentError.
    void write(const Image& band);
    void write(const DeepImage& band);

    // The XXH64 of the pixels written so far; see image/pixels_xxh64.h.
    std::string pixels_xxh64() const;

    // Writes texts that are known only after the pixels; syncs and renames the file. Throws:
    // InputError if rows are missing or PNG cannot hold a keyword; EnvironmentError.
    void finish(const std::map<std::string, std::string>& texts = {});

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace poinsot
