#include "image/pixel_hash.h"

#include <fmt/format.h>

#include "system/sha256.h"

namespace poinsot {

std::string pixel_hash(const Image& image) {
    Sha256 hash;
    hash.add(fmt::format("{}x{}\n", image.width(), image.height()));
    hash.add(image.bytes());
    return hash.finish();
}

}  // namespace poinsot
