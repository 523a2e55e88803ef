#include "image/alpha.h"

namespace poinsot {

bool is_opaque(const Image& image) {
    const std::span<const std::uint8_t> bytes = image.bytes();
    std::uint8_t all = 255;
    for (std::size_t i = 3; i < bytes.size(); i += 4) all &= bytes[i];
    return all == 255;
}

void flatten_on_white(const Image& image, Image& flat) {
    if (flat.width() != image.width() || flat.height() != image.height())
        flat = Image(image.width(), image.height());
    const std::uint8_t* from = image.bytes().data();
    std::uint8_t* to = flat.bytes().data();
    for (std::size_t i = 0; i < image.bytes().size(); i += 4) {
        const unsigned alpha = from[i + 3];
        for (std::size_t c = 0; c < 3; ++c)
            to[i + c] =
                static_cast<std::uint8_t>((from[i + c] * alpha + 255 * (255 - alpha) + 127) / 255);
        to[i + 3] = 255;
    }
}

}  // namespace poinsot
