// A PNG file written band by band, for pictures that would not fit into memory whole.
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

// Takes a picture in bands from the top, each as wide as the picture; memory is that of one band.
// Move-only. Destroyed unfinished, it leaves nothing.
class PngBandWriter {
 public:
    // Opaque pictures are written without alpha, whatever their bands say. A sample has 8 bits or
    // 16.
    // Throws: InputError as PngEncoder does, EnvironmentError as AtomicFile does.
    PngBandWriter(const std::filesystem::path& path, int width_px, int height_px, bool opaque,
                  const PngOptions& options = {}, int bit_depth = 8);
    ~PngBandWriter();
    PngBandWriter(PngBandWriter&&) noexcept;
    PngBandWriter& operator=(PngBandWriter&&) noexcept;

    // Bands are of the depth said. Throws: InputError for a band of another width or one row too
    // many; EnvironmentError.
    void write(const Image& band);
    void write(const DeepImage& band);

    // The quick hash of the pixels written so far; see image/pixel_check.h.
    std::string pixel_check() const;

    // Writes texts that are known only now, after the pixels; syncs and renames. Throws: InputError
    // if rows are missing, or for a keyword that PNG cannot hold; EnvironmentError.
    void finish(const std::map<std::string, std::string>& texts = {});

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace poinsot
