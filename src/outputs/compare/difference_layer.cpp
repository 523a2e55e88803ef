// The differences of two pictures as a layer that is shown over one of them.
//
// Where some pixels differ clearly, those that differ by a level hide them: dither and rounding
// change such pixels all over a picture. They are then left out, and counted.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "compare/compare.h"
#include "compare/pixel_differences.h"

namespace poinsot {

namespace {

constexpr Rgba8 absent{217, 0, 54, 255}, antialiased{30, 110, 255, 255},
    left_out{128, 128, 128, 110};

// Amber at one level or less, red at 16 levels and more; evenly by the logarithm between.
Rgba8 heat(double levels) {
    const double share = std::clamp(std::log2(std::max(levels, 1.0)) / 4.0, 0.0, 1.0);
    const auto between = [share](int from, int to) {
        return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
    };
    return {between(255, 217), between(176, 0), between(0, 54), 255};
}

// Collects pixels that differ by at most a level.
class FaintPixels {
 public:
    void add(int x, int y, double levels) {
        if (levels <= 1.0)
            faint_.push_back({x, y});
        else
            any_clear_ = true;
    }
    // Removes them from the layer if other pixels differ by more.
    void leave_out_of(DifferenceLayer& layer) const {
        if (!any_clear_) return;
        for (const auto& [x, y] : faint_) layer.image.set(x, y, {0, 0, 0, 0});
        layer.n_faint_left_out = static_cast<std::int64_t>(faint_.size());
    }

 private:
    std::vector<std::array<int, 2>> faint_;
    bool any_clear_ = false;
};

template <typename Sample>
void paint(const PictureSamples<Sample>& a, const PictureSamples<Sample>& b,
           const CompareLimits& limits, const PixelMask& ignored, Image& layer,
           FaintPixels& faint) {
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::size_t pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) +
                static_cast<std::size_t>(x);
            if (ignored.has(pixel)) {
                layer.set(x, y, left_out);
                continue;
            }
            int largest = 0;
            for (std::size_t c = 0; c < 4; ++c)
                largest = std::max(largest, std::abs(int{a.samples[4 * pixel + c]} -
                                                     int{b.samples[4 * pixel + c]}));
            if (largest == 0) continue;
            const double levels = 1.0 * largest / samples_a_level<Sample>;
            faint.add(x, y, levels);
            layer.set(
                x, y,
                limits.antialiasing && is_antialiasing(a, b, x, y) ? antialiased : heat(levels));
        }
    }
}

}  // namespace

DifferenceLayer difference_layer(const StoredPicture& expected, const StoredPicture& actual,
                                 const CompareLimits& limits,
                                 std::span<const PictureRegion> ignored) {
    const int width = std::max(expected.image.width(), actual.image.width());
    const int height = std::max(expected.image.height(), actual.image.height());
    DifferenceLayer layer{Image(width, height)};
    FaintPixels faint;
    if (expected.image.width() != actual.image.width() ||
        expected.image.height() != actual.image.height()) {
        const auto has = [](const Image& image, int x, int y) {
            return x < image.width() && y < image.height();
        };
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                if (!has(expected.image, x, y) || !has(actual.image, x, y)) {
                    layer.image.set(x, y, absent);
                    continue;
                }
                const Rgba8 a = expected.image.at(x, y), b = actual.image.at(x, y);
                const int largest = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g),
                                              std::abs(a.b - b.b), std::abs(a.a - b.a)});
                if (largest == 0) continue;
                faint.add(x, y, largest);
                layer.image.set(x, y, heat(largest));
            }
        faint.leave_out_of(layer);
        return layer;
    }
    const PixelMask mask(width, height, ignored);
    if (!expected.deep.empty() && !actual.deep.empty())
        paint(samples_of(expected.deep), samples_of(actual.deep), limits, mask, layer.image, faint);
    else
        paint(samples_of(expected.image), samples_of(actual.image), limits, mask, layer.image,
              faint);
    faint.leave_out_of(layer);
    return layer;
}

}  // namespace poinsot
