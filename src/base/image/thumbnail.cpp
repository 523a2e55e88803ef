#include "image/thumbnail.h"

#include <algorithm>

#include "image/downsample.h"

namespace poinsot {

namespace {

int factor_for(const Image& image, int most_px) {
    return std::max(1, (std::max(image.width(), image.height()) + most_px - 1) / most_px);
}

// How strong a difference the colour of a layer stands for.
int strength(Rgba8 colour) { return 1000 * colour.a + colour.r - colour.g; }

}  // namespace

Image thumbnail(const Image& image, int most_px) {
    const int factor = factor_for(image, most_px);
    if (factor == 1) return image;
    const int width = std::max(1, image.width() / factor),
              height = std::max(1, image.height() / factor);
    Image whole(width * factor, height * factor);
    for (int y = 0; y < whole.height(); ++y)
        for (int x = 0; x < whole.width(); ++x)
            whole.set(x, y,
                      image.at(std::min(x, image.width() - 1), std::min(y, image.height() - 1)));
    return downsampled(whole, factor);
}

Image layer_thumbnail(const Image& layer, int most_px) {
    const int factor = factor_for(layer, most_px);
    if (factor == 1) return layer;
    Image small(std::max(1, layer.width() / factor), std::max(1, layer.height() / factor));
    for (int y = 0; y < layer.height(); ++y)
        for (int x = 0; x < layer.width(); ++x) {
            const int to_x = std::min(x / factor, small.width() - 1);
            const int to_y = std::min(y / factor, small.height() - 1);
            const Rgba8 colour = layer.at(x, y);
            if (strength(colour) > strength(small.at(to_x, to_y))) small.set(to_x, to_y, colour);
        }
    return small;
}

}  // namespace poinsot
