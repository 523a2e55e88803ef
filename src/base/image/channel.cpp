#include "image/channel.h"

#include <algorithm>
#include <cmath>

#include "system/interrupt.h"

namespace poinsot {

namespace {

// Convolves one row, using a copy that is padded with its end values.
void convolve_row(const float* row, std::size_t n, std::span<const float> kernel,
                  std::vector<float>& padded, float* out) {
    const std::size_t radius = kernel.size() / 2;
    padded.resize(n + 2 * radius);
    std::fill_n(padded.begin(), radius, row[0]);
    std::copy_n(row, n, padded.begin() + static_cast<std::ptrdiff_t>(radius));
    std::fill_n(padded.begin() + static_cast<std::ptrdiff_t>(radius + n), radius, row[n - 1]);
    std::fill_n(out, n, 0.0f);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
        const float weight = kernel[k];
        const float* from = padded.data() + k;
        for (std::size_t x = 0; x < n; ++x) out[x] += weight * from[x];
    }
}

}  // namespace

Channel convolved(const Channel& channel, std::span<const float> kernel_x,
                  std::span<const float> kernel_y) {
    const auto width = static_cast<std::size_t>(channel.width);
    const auto radius = static_cast<int>(kernel_y.size() / 2);
    Channel along_x(channel.width, channel.height), both(channel.width, channel.height);
    std::vector<float> padded;
    for (std::size_t y = 0; y < static_cast<std::size_t>(channel.height); ++y) {
        stop_if_interrupted();
        convolve_row(channel.values.data() + y * width, width, kernel_x, padded,
                     along_x.values.data() + y * width);
    }
    for (int y = 0; y < channel.height; ++y) {
        stop_if_interrupted();
        float* out = both.values.data() + static_cast<std::size_t>(y) * width;
        for (int k = 0; k < static_cast<int>(kernel_y.size()); ++k) {
            const int from_y = std::clamp(y + k - radius, 0, channel.height - 1);
            const float* from = along_x.values.data() + static_cast<std::size_t>(from_y) * width;
            const float weight = kernel_y[static_cast<std::size_t>(k)];
            for (std::size_t x = 0; x < width; ++x) out[x] += weight * from[x];
        }
    }
    return both;
}

std::vector<float> gaussian_kernel(double sigma, int radius) {
    std::vector<double> weights;
    double sum = 0;
    for (int i = -radius; i <= radius; ++i) {
        weights.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
        sum += weights.back();
    }
    std::vector<float> kernel;
    kernel.reserve(weights.size());
    for (const double weight : weights) kernel.push_back(static_cast<float>(weight / sum));
    return kernel;
}

}  // namespace poinsot
